// protection: steplock::Protection, printed by hlsgen from hls/six_step/protection.hpp:36.
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
    input  logic [11:0] words_wrong_lock_i,  // a wrong tick takes two of them; 0 disables the test
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
  logic [11:0] wrong;  // ticks left of those that may look like a wrong lock
  logic [1:0] hall;  // ticks in a row with an illegal code

  wire [2:0] choice_101 = (missed_i && lags_i) ? 3'd4 : 3'd1;  // line 101
  wire [6:0] choice =
      (missed_i || (update_i && !(good_i || hall_i))) ? {4'd0, choice_101} + score :
      (good_i && score != 7'd0) ? score - 7'd1 :
      score;
  wire [6:0] score_next = running_i ? choice : 7'd0;
  wire both_79 = words_misses_i != 6'd0 && {1'b0, words_misses_i} <= score_next;  // line 79
  wire [2:0] choice_105 = slow_i ? ((slow == 3'd6) ? 3'd6 : slow + 3'd1) : 3'd0;  // line 105
  wire [2:0] choice_105_2 = commutate_i ? choice_105 : slow;  // line 105
  wire both_80 = running_i && choice_105_2 == 3'd6;  // line 80
  wire below_64 = words_freewheel_i < freewheel_i;  // line 64
  wire [11:0] choice_115 =  // line 115
      (slips_i || below_64) ? ((wrong[11:1] == 11'd0) ? 12'd0 : wrong - 12'd2) :
      (wrong < words_wrong_lock_i) ? wrong + 12'd1 :
      wrong;
  wire [11:0] wrong_next = running_i ? (tick_i ? choice_115 : wrong) : words_wrong_lock_i;
  wire both_81 = words_wrong_lock_i != 12'd0 && wrong_next == 12'd0;  // line 81
  wire [1:0] choice_122 = (hall == 2'd2) ? 2'd2 : hall + 2'd1;  // line 122
  wire [1:0] choice_2 = tick_i ? ((hall_i && hall_illegal_i) ? choice_122 : 2'd0) : hall;
  wire both_82 = running_i && choice_2 == 2'd2;  // line 82
  wire below_78 = words_over_current_i - 4'd1 < stuck_i;  // line 78
  wire fatal = fault_pin_i || below_78;  // line 83

  always_ff @(posedge clk) begin
    score <= score_next;
    if (running_i) begin
      slow <= choice_105_2;
      hall <= choice_2;
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

  assign lost_o = both_79 || both_80 || both_81 || both_82;
  assign fatal_o = fatal;
  assign reason_o =
      (fatal || both_79) ?
      (fault_pin_i ? Reason_kFaultPin :
      below_78 ? Reason_kOverCurrent :
      Reason_kStepOut) :
      both_80 ? Reason_kStall :
      both_81 ? Reason_kWrongLock :
      both_82 ? Reason_kHallCode :
      Reason_kNone;
  assign freewheel_long_o = commutate_i && below_64;

  // What nothing reads, for the linters.
  wire unused = &{1'b0, words_stall_i, words_slip_i};
endmodule
