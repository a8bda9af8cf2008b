// guarded_leg: steplock::GuardedLeg, printed by hlsgen from hls/bridge/guarded_leg.hpp:22.
// Do not edit: change the C++ and print again.

module guarded_leg (
    input  logic       clk,
    input  logic       rst,  // synchronous, active high
    input  logic       high_i,  // request for the high side; both requested is none
    input  logic       low_i,  // request for the low side
    input  logic       off_i,  // both gates off at the next clock
    input  logic [7:0] dead_time_i,  // clocks, 1 at least; taken when a request comes, goes or changes
    input  logic [7:0] minimum_i,  // clocks of on-time at least; taken at turn-on
    output logic       high_o,  // gate of the high side
    output logic       low_o  // gate of the low side
);
  logic high;  // gate of the high side
  logic low;  // gate of the low side
  logic was_high;  // the request of the last clock
  logic was_low;  // the request of the last clock
  logic [7:0] timer;  // clocks of minimum on-time (on) or dead time (off); 0 and 1 are due

  wire was_high_next = !off_i && high_i && !low_i;
  wire was_low_next = !off_i && low_i && !high_i;
  wire either_46 = !(off_i || timer[7:1] == 7'd0) || (high ? was_high_next : was_low_next);
  wire either_42 = high || low;  // line 42
  wire both = either_42 && either_46;
  wire either_41 = (was_high_next && was_high) || (was_low_next && was_low);  // line 41
  wire both_47 = !either_42 && either_41 && timer[7:1] == 7'd0;  // line 47
  wire unequal_51 = timer[7:1] != 7'd0;  // line 51
  wire [7:0] sum_51 = timer + {8{unequal_51}};  // line 51
  wire [7:0] choice_50 = both_47 ? minimum_i : dead_time_i;  // line 50

  always_ff @(posedge clk) begin
    if (rst) begin
      high <= 1'b0;
      low <= 1'b0;
      was_high <= 1'b0;
      was_low <= 1'b0;
      timer <= 8'd0;
    end else begin
      high <= (high && both) || (both_47 && was_high_next);  // line 54
      low <= (low && both) || (both_47 && was_low_next);  // line 55
      was_high <= was_high_next;
      was_low <= was_low_next;
      if (either_42) begin
        if (either_46) begin
          timer <= sum_51;
        end else begin
          timer <= choice_50;
        end
      end else if (!either_41 || timer[7:1] == 7'd0) begin
        timer <= choice_50;
      end else begin
        timer <= sum_51;
      end
    end
  end

  assign high_o = high;
  assign low_o = low;
endmodule
