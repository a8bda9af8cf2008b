// Power-on reset for FPGAs whose flip-flops wake up as their initial values say (iCE40 does): `rst` is
// high for 2^10 clocks after configuration, and again after `hold`, which is asynchronous.
//
// Doc: docs/boards.md   Test: tests/boards/CMakeLists.txt

module power_on_reset (
    input  logic clk,
    input  logic hold,
    output logic rst
);
  logic [1:0] held = 2'b00;
  logic [9:0] clocks = 10'd0;
  logic ready = 1'b0;  // iCE40's flip-flops wake up as 0; as the opposite of one, `rst` would lose its name in the netlist

  always_ff @(posedge clk) begin
    held <= {held[0], hold};
    if (held[1]) clocks <= 10'd0;
    else if (clocks != 10'h3ff) clocks <= clocks + 10'd1;
    ready <= clocks == 10'h3ff;
  end
  assign rst = !ready;
endmodule
