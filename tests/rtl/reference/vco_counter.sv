// The VCO counter as written by hand: the size yardstick for rtl/vco_counter.sv (docs/sizes.md).
module vco_counter (
    input  logic        clk,
    input  logic        rst,
    input  logic        enable_i,
    input  logic        load_i,
    input  logic [15:0] phase_i,
    input  logic [25:0] frequency_i,
    output logic [15:0] phase_o,
    output logic        pulse_o
);
  logic [31:0] phase;
  logic [32:0] sum;

  assign sum     = phase + frequency_i;
  assign phase_o = phase[31:16];

  always_ff @(posedge clk) begin
    pulse_o <= enable_i & ~load_i & sum[32];
    if (load_i) phase <= {phase_i, 16'h0000};
    else if (enable_i) phase <= sum[31:0];
    if (rst) begin
      phase   <= '0;
      pulse_o <= 1'b0;
    end
  end
endmodule
