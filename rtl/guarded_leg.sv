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

  wire either_47 = off_i || timer[7:1] == 7'd0;  // line 47
  wire [1:0] held = either_47 ? 2'd0 : gate;  // line 48
  wire [1:0] choice_45 = (gate == 2'd0) ? was : gate;  // line 45
  wire [1:0] same = off_i ? 2'd0 : choice_45;  // line 45
  wire [1:0] ready = ((gate != 2'd0 || timer[7:1] == 7'd0) && !off_i) ? choice_45 : 2'd0;
  wire [1:0] choice_44 = (low_i && !high_i) ? 2'd2 : 2'd0;  // line 44
  wire [1:0] request = choice_44 | {1'b0, high_i && !low_i};  // line 44

  always_ff @(posedge clk) begin
    gate <= held | (ready & request);  // line 58
    if (off_i) begin
      was <= 2'd0;
    end else begin
      was <= request;
    end
    if ((request & same) != 2'd0 || (gate != 2'd0 && !either_47)) begin
      if (timer[7:1] == 7'd0) begin
        if (gate == 2'd0) begin
          timer <= minimum_i;
        end else begin
          timer <= 8'd0;
        end
      end else begin
        timer <= timer - 8'd1;
      end
    end else begin
      timer <= dead_time_i;
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
