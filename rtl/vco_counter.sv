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
  logic [26:0] low;  // its lower 26 bits, and their carry
  logic counted;  // the carry is new, and has still to be added to
  logic [5:0] high;  // the others
  logic full;  // which are all ones: the carry ends the turn

  wire carry = low[26] && counted;  // line 37
  wire [5:0] sum_40 = high + {5'd0, carry};  // line 40

  always_ff @(posedge clk) begin
    if (load_i) begin
      low <= 27'd0;
      if (half_i) begin
        high <= 6'd32;
      end else begin
        high <= 6'd0;
      end
      full <= 1'b0;
    end else begin
      if (enable_i) begin
        low <= {1'b0, low[25:0]} + {1'b0, frequency_i};
      end
      high <= sum_40;
      if (carry) begin
        full <= high == 6'd62;
      end
    end
    counted <= enable_i;
    if (rst) begin
      low <= 27'd0;
      counted <= 1'b0;
      high <= 6'd0;
      full <= 1'b0;
    end
  end

  assign phase_o = {sum_40, 10'd0} | {6'd0, low[25:16]};
  assign pulse_o = carry && full;
endmodule
