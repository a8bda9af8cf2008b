// The VCO counter as written by hand: the size yardstick for rtl/vco_counter.sv (docs/sizes.md).  As fast, too: beyond
// the frequency's 26 bits the carry is taken a clock later, and a flag says whether it ends the turn.
module vco_counter (
    input  logic        clk,
    input  logic        rst,
    input  logic        enable_i,
    input  logic        load_i,
    input  logic        half_i,
    input  logic [25:0] frequency_i,
    output logic [15:0] phase_o,
    output logic        pulse_o
);
  logic [26:0] low;
  logic [ 5:0] high;
  logic        full;
  logic        counted;
  logic        carry;

  assign carry   = low[26] & counted;
  assign phase_o = {high + 6'(carry), low[25:16]};
  assign pulse_o = carry & full;

  always_ff @(posedge clk) begin
    counted <= enable_i;
    if (load_i) begin
      low  <= '0;
      high <= {half_i, 5'd0};
      full <= 1'b0;
    end else begin
      if (enable_i) low <= {1'b0, low[25:0]} + {1'b0, frequency_i};
      high <= high + 6'(carry);
      if (carry) full <= high == 6'd62;
    end
    if (rst) begin
      low     <= '0;
      high    <= '0;
      full    <= 1'b0;
      counted <= 1'b0;
    end
  end
endmodule
