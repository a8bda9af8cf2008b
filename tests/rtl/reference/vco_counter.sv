// The VCO counter as written by hand: the size yardstick for rtl/vco_counter.sv (docs/sizes.md).  As fast, too: beyond
// the frequency's 26 bits a flag says whether the carry ends the turn.
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
  logic [25:0] low;
  logic [ 5:0] high;
  logic        full;
  logic [26:0] sum;

  assign sum     = low + frequency_i;
  assign phase_o = {high, low[25:16]};

  always_ff @(posedge clk) begin
    pulse_o <= enable_i & ~load_i & sum[26] & full;
    if (load_i) begin
      low  <= '0;
      high <= {half_i, 5'd0};
      full <= 1'b0;
    end else if (enable_i) begin
      low  <= sum[25:0];
      high <= high + 6'(sum[26]);
      full <= high == (sum[26] ? 6'd62 : 6'd63);
    end
    if (rst) begin
      low     <= '0;
      high    <= '0;
      full    <= 1'b0;
      pulse_o <= 1'b0;
    end
  end
endmodule
