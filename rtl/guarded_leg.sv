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

  wire either_39 = off_i || !(high_i ^ low_i);  // line 39
  wire [1:0] choice_40 = high_i ? 2'd1 : 2'd2;  // line 40
  wire [1:0] was_next = either_39 ? 2'd0 : choice_40;  // line 40
  wire unequal_51 = timer[7:1] != 7'd0;  // line 51
  wire [7:0] sum_51 = timer + {8{unequal_51}};  // line 51

  always_ff @(posedge clk) begin
    if (gate != 2'd0 && (!(off_i || timer[7:1] == 7'd0) || was_next == gate)) begin
      timer <= sum_51;
    end else begin
      logic both_41;
      logic [7:0] choice_50;
      both_41 = was_next == was && !either_39;  // line 41
      choice_50 = (gate == 2'd0 && both_41 && timer[7:1] == 7'd0) ? minimum_i : dead_time_i;
      if (gate == 2'd0) begin
        if (!both_41 || timer[7:1] == 7'd0) begin
          if (both_41 && timer[7:1] == 7'd0) begin
            gate <= choice_40;
          end
          timer <= choice_50;
        end else begin
          timer <= sum_51;
        end
      end else begin
        gate <= 2'd0;
        timer <= choice_50;
      end
    end
    was <= was_next;  // line 40
    if (rst) begin
      gate <= 2'd0;
      was <= 2'd0;
      timer <= 8'd0;
    end
  end

  assign high_o = gate[0];
  assign low_o = gate[1];
endmodule
