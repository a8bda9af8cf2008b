// vco_counter: steplock::VcoCounter, printed by hlsgen from hls/six_step/vco_counter.hpp:21.
// Do not edit: change the C++ and print again.

module vco_counter (
    input  logic        clk,
    input  logic        rst,  // synchronous, active high
    input  logic        enable_i,  // false holds the phase
    input  logic        load_i,  // begins a turn instead of adding; wins over enable
    input  logic        half_i,  // with `load`: in its middle
    input  logic [25:0] frequency_i,  // u0.32, VCO turns per clock
    output logic [15:0] phase_o,  // u0.16, VCO turns
    output logic        pulse_o  // one clock, the first of a new turn
);
  logic [26:0] low;  // its lower 26 bits, and room for the carry
  logic [5:0] high;  // the others
  logic full;  // they are all ones: the next carry into them ends the turn
  logic pulse;  // the last addition passed a whole turn

  always_ff @(posedge clk) begin
    if (load_i) begin
      low <= 27'd0;
      if (half_i) begin
        high <= 6'd32;
      end else begin
        high <= 6'd0;
      end
      full <= 1'b0;
      pulse <= 1'b0;
    end else if (enable_i) begin
      logic [26:0] sum;
      logic [1:0] choice_46;
      sum = low + {1'b0, frequency_i};  // line 37
      choice_46 = sum[26] ? 2'd2 : 2'd3;  // line 46
      low <= {1'b0, sum[25:0]};
      if (sum[26]) begin
        high <= high + 6'd1;
      end
      full <= high == {{4{choice_46[1]}}, choice_46};
      pulse <= sum[26] && full;
    end else begin
      pulse <= 1'b0;
    end
    if (rst) begin
      low <= 27'd0;
      high <= 6'd0;
      full <= 1'b0;
      pulse <= 1'b0;
    end
  end

  assign phase_o = {high, 10'd0} | {5'd0, low[26:16]};
  assign pulse_o = pulse;
endmodule
