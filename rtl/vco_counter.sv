// vco_counter: steplock::VcoCounter, printed by hlsgen from hls/six_step/vco_counter.hpp:21.
// Do not edit: change the C++ and print again.

module vco_counter (
    input  logic        clk,
    input  logic        rst,  // synchronous, active high
    input  logic        enable_i,  // false holds the phase
    input  logic        load_i,  // takes `phase` instead of adding; wins over enable
    input  logic [15:0] phase_i,  // u0.16, VCO turns
    input  logic [25:0] frequency_i,  // u0.32, VCO turns per clock
    output logic [15:0] phase_o,  // u0.16, VCO turns
    output logic        pulse_o  // one clock, the first of a new turn
);
  logic [31:0] phase;  // u0.32, VCO turns
  logic pulse;  // the last addition passed a whole turn

  always_ff @(posedge clk) begin
    if (load_i) begin
      phase <= {phase_i, 16'd0};
      pulse <= 1'b0;
    end else if (enable_i) begin
      logic [32:0] sum;
      sum = {1'b0, phase} + {7'd0, frequency_i};  // line 37
      phase <= sum[31:0];
      pulse <= sum[32];
    end else begin
      pulse <= 1'b0;
    end
    if (rst) begin
      phase <= 32'd0;
      pulse <= 1'b0;
    end
  end

  assign phase_o = phase[31:16];
  assign pulse_o = pulse;
endmodule
