// protection: steplock::Protection, printed by hlsgen from hls/six_step/protection.hpp:34.
// Do not edit: change the C++ and print again.

module protection (
    input  logic        clk,
    input  logic        rst,  // synchronous, active high
    input  logic        running_i,  // locked and under speed control
    input  logic        tick_i,  // time base of the wrong-lock test
    input  logic        commutate_i,  // a new step began
    input  logic        update_i,  // strobe: a step had its crossing, or ended without
    input  logic        good_i,  // with `update`: a crossing near its place
    input  logic        missed_i,  // with `update`: a step without a crossing
    input  logic        lags_i,  // with `missed`: the step ended on the level before
    input  logic        slow_i,  // the VCO's frequency is below `stall`
    input  logic        slips_i,  // the duty is more than the back-EMF explains
    input  logic [15:0] freewheel_i,  // u0.16, of the present or last step
    input  logic [3:0]  stuck_i,  // hits of the current limit whose comparator was never released
    input  logic        fault_pin_i,  // synchronised
    input  logic        hall_i,  // steps come from the Hall sensors
    input  logic        hall_illegal_i,  // their code is 000 or 111
    input  logic [5:0]  words_misses_i,  // lost lock: score of missed (4), hidden or far (1), good (-1) crossings; 0: off
    input  logic [25:0] words_stall_i,  // u0.32: slower than this in speed control is a stall
    input  logic [15:0] words_slip_i,  // duty above the back-EMF's that no right lock shows
    input  logic [15:0] words_freewheel_i,  // u0.16: freewheeling for longer than this part of a step is wrong
    input  logic [11:0] words_wrong_lock_i,  // for how long; 0 disables the test
    input  logic [3:0]  words_over_current_i,  // limit hits with the comparator never released; 0 disables
    output logic        lost_o,  // give up this try
    output logic        fatal_o,  // latch a fault, in any state
    output logic [3:0]  reason_o,
    output logic        freewheel_long_o  // strobe: the step that ended freewheeled for too long
);
  localparam logic [3:0] Reason_kNone = 4'd0;
  localparam logic [3:0] Reason_kFaultPin = 4'd1;
  localparam logic [3:0] Reason_kOverCurrent = 4'd2;
  localparam logic [3:0] Reason_kStepOut = 4'd3;
  localparam logic [3:0] Reason_kStall = 4'd4;
  localparam logic [3:0] Reason_kWrongLock = 4'd5;
  localparam logic [3:0] Reason_kHallCode = 4'd8;

  logic [6:0] score;  // of missed and far crossings
  logic [2:0] slow;  // slow steps in a row
  logic [11:0] wrong;  // ticks more that may look like a wrong lock
  logic [1:0] hall;  // ticks in a row with an illegal code

  wire [2:0] choice_99 = (missed_i && lags_i) ? 3'd4 : 3'd1;  // line 99
  wire [6:0] choice =
      (missed_i || (update_i && !(good_i || hall_i))) ? {4'd0, choice_99} + score :
      (good_i && score != 7'd0) ? score - 7'd1 :
      score;
  wire [6:0] score_next = running_i ? choice : 7'd0;
  wire both_77 = words_misses_i != 6'd0 && {1'b0, words_misses_i} <= score_next;  // line 77
  wire [2:0] choice_103 = slow_i ? ((slow == 3'd6) ? 3'd6 : slow + 3'd1) : 3'd0;  // line 103
  wire [2:0] choice_103_2 = commutate_i ? choice_103 : slow;  // line 103
  wire both_78 = running_i && choice_103_2 == 3'd6;  // line 78
  wire below_62 = words_freewheel_i < freewheel_i;  // line 62
  wire [11:0] choice_113 = (wrong == 12'd0) ? 12'd0 : wrong - 12'd1;  // line 113
  wire [11:0] choice_2 = tick_i ? ((slips_i || below_62) ? choice_113 : words_wrong_lock_i) : wrong;
  wire [11:0] wrong_next = running_i ? choice_2 : words_wrong_lock_i;
  wire both_79 = words_wrong_lock_i != 12'd0 && wrong_next == 12'd0;  // line 79
  wire [1:0] choice_120 = (hall == 2'd2) ? 2'd2 : hall + 2'd1;  // line 120
  wire [1:0] choice_3 = tick_i ? ((hall_i && hall_illegal_i) ? choice_120 : 2'd0) : hall;
  wire both_80 = running_i && choice_3 == 2'd2;  // line 80
  wire below_76 = words_over_current_i - 4'd1 < stuck_i;  // line 76
  wire fatal = fault_pin_i || below_76;  // line 81

  always_ff @(posedge clk) begin
    score <= score_next;
    if (running_i) begin
      slow <= choice_103_2;
      hall <= choice_3;
    end else begin
      slow <= 3'd0;
      hall <= 2'd0;
    end
    wrong <= wrong_next;
    if (rst) begin
      score <= 7'd0;
      slow <= 3'd0;
      wrong <= 12'd4095;
      hall <= 2'd0;
    end
  end

  assign lost_o = both_77 || both_78 || both_79 || both_80;
  assign fatal_o = fatal;
  assign reason_o =
      (fatal || both_77) ?
      (fault_pin_i ? Reason_kFaultPin :
      below_76 ? Reason_kOverCurrent :
      Reason_kStepOut) :
      both_78 ? Reason_kStall :
      both_79 ? Reason_kWrongLock :
      both_80 ? Reason_kHallCode :
      Reason_kNone;
  assign freewheel_long_o = commutate_i && below_62;

  // What nothing reads, for the linters.
  wire unused = &{1'b0, words_stall_i, words_slip_i};
endmodule
