// Dice for the benches: xorshift, the same numbers in every simulator, from +seed=N and a salt.
//
//     dice #(.SALT(1)) dice ();     if (dice.draw(200) == 0) ...
//
// Draw before you ask for anything else: whether `a && draw(2) == 0` draws where `a` is false differs from tool to tool.
//
// Test: tests/rtl/properties.sh

`timescale 1ns / 1ps

module dice #(
    parameter logic [31:0] SALT = 32'd0
);
  logic [31:0] state = 32'd1;
  initial begin
    if (!$value$plusargs("seed=%d", state)) state = 32'd1;
    state = (state ^ (SALT * 32'h9e37_79b9)) | 32'd1;
  end
  function automatic logic [31:0] bits;
    state = state ^ (state << 13);
    state = state ^ (state >> 17);
    state = state ^ (state << 5);
    return state;
  endfunction
  // 0 to below - 1.
  function automatic int draw(input int below);
    return int'((bits() >> 4) % below);
  endfunction
  // A pin that is up now and then: for `lasts` clocks of `between` and those, on the average.
  function automatic logic now_and_then(input logic pin, input int between, input int lasts);
    int drawn;
    drawn = draw(pin ? lasts : between);
    return pin ? drawn != 0 : drawn == 0;
  endfunction
endmodule
