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
  logic [1:0] gate;  // the gates
  logic [1:0] was;  // the request of the last clock
  logic [7:0] timer;  // clocks of minimum on-time (on) or dead time (off); 0 and 1 are due

  wire [1:0] same = (gate == 2'd0) ? was : gate;  // line 44
  wire both_48 = !off_i && (gate != 2'd0 || timer[7:1] == 7'd0);  // line 48
  wire both_40 = low_i && !high_i;  // line 40
  wire either = off_i || timer[7:1] == 7'd0;
  wire choice =
      either ? both_48 && both_40 && same[1] :
      (gate[1] || !both_48 || !both_40) ? gate[1] :
      same[1];
  wire both_39 = high_i && !low_i;  // line 39
  wire choice_2 =
      either ? both_48 && both_39 && same[0] :
      (gate[0] || !both_48 || !both_39) ? gate[0] :
      same[0];
  wire [1:0] choice_58 = (both_40 && !off_i) ? 2'd2 : 2'd0;  // line 58
  wire both_45 = both_39 && same[0];  // line 45
  wire choice_45 = (both_45 || !both_40) ? both_45 : same[1];  // line 45
  wire both = !off_i && choice_45;
  wire both_46 = gate == 2'd0 && timer[7:1] == 7'd0;  // line 46

  always_ff @(posedge clk) begin
    gate <= (choice ? 2'd2 : 2'd0) | {1'b0, choice_2};  // line 57
    was <= choice_58 | {1'b0, both_39 && !off_i};  // line 58
    if ((gate == 2'd0 || both) ? both_46 || !(both_46 || both) : either) begin
      if (gate != 2'd0 || !both) begin
        timer <= dead_time_i;
      end else begin
        timer <= minimum_i;
      end
    end else if (timer[7:1] != 7'd0) begin
      timer <= timer - 8'd1;
    end
    if (rst) begin
      gate <= 2'd0;
      was <= 2'd0;
      timer <= 8'd0;
    end
  end

  assign high_o = gate[0];
  assign low_o = gate[1];
endmodule
