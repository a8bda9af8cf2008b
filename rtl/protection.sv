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

  logic [6:0] score;  // of missed and far crossings, but for the last
  logic [2:0] strikes;  // the last one's
  logic credit;  // the last one was good
  logic ended;  // the score is enough
  logic one_ends;  // one more would be
  logic four_end;  // four more would be
  logic long;  // freewheeling stood for too long a clock ago
  logic [2:0] slow;  // slow steps in a row
  logic [11:0] wrong;  // ticks left of those that may look like a wrong lock
  logic none_left;  // wrong_ a clock ago, which ticks are long enough apart for: 0
  logic few_left;  // 2 or less
  logic all_left;  // all of them
  logic [1:0] hall;  // ticks in a row with an illegal code

  wire both_70 = missed_i && lags_i;  // line 70
  wire choice = (missed_i || !update_i) ? missed_i : !(good_i || hall_i);
  wire choice_2 = (!running_i || ended) ? running_i : (both_70 && four_end) || (choice && one_ends);
  wire either_77 = slow == 3'd6 || !commutate_i;  // line 77
  wire choice_3 = either_77 ? slow == 3'd6 : slow_i && slow == 3'd5;
  wire both = running_i && choice_3;
  wire either = slips_i || long;
  wire both_2 =
      running_i && words_wrong_lock_i != 12'd0 && (none_left || (tick_i && either && few_left));
  wire both_79 = tick_i && hall_i && hall_illegal_i && hall != 2'd0;  // line 79
  wire both_3 = running_i && (!(hall != 2'd2 || tick_i) || both_79);
  wire below_103 = words_over_current_i - 4'd1 < stuck_i;  // line 103
  wire fatal = fault_pin_i || below_103;  // line 104
  wire long_next = words_freewheel_i < freewheel_i;  // line 64
  wire [1:0] choice_132 = either ? 2'd2 : 2'd1;  // line 132
  wire [11:0] change = running_i ? {{10{choice_132[1]}}, choice_132} : words_wrong_lock_i;
  wire [11:0] sum_136 = (running_i ? wrong : 12'd0) + change;  // line 136

  always_ff @(posedge clk) begin
    if (running_i) begin
      logic [3:0] choice_85;
      choice_85 = (strikes == 3'd0 && credit && score != 7'd0) ? 4'd15 : {1'b0, strikes};
      score <= {{3{choice_85[3]}}, choice_85} + score;
      if (both_70) begin
        strikes <= 3'd4;
      end else begin
        strikes <= {2'd0, choice};
      end
      if (commutate_i) begin
        if (slow_i) begin
          if (slow != 3'd6) begin
            slow <= slow + 3'd1;
          end
        end else begin
          slow <= 3'd0;
        end
      end
      if (tick_i) begin
        if (either && few_left) begin
          wrong <= 12'd0;
        end else if (either || !all_left) begin
          wrong <= sum_136;
        end
        if (hall_i && hall_illegal_i) begin
          if (hall != 2'd2) begin
            hall <= hall + 2'd1;
          end
        end else begin
          hall <= 2'd0;
        end
      end
    end else begin
      score <= 7'd0;
      strikes <= 3'd0;
      slow <= 3'd0;
      wrong <= sum_136;
      hall <= 2'd0;
    end
    credit <= running_i && good_i;
    ended <= words_misses_i != 6'd0 && {1'b0, words_misses_i} <= score;  // line 72
    one_ends <= words_misses_i != 6'd0 && {2'd0, words_misses_i} <= {1'b0, score} + 8'd1;
    four_end <= words_misses_i != 6'd0 && {2'd0, words_misses_i} <= {1'b0, score} + 8'd4;
    long <= long_next;  // line 64
    none_left <= wrong == 12'd0;  // line 80
    few_left <= wrong < 12'd3;  // line 81
    all_left <= (words_wrong_lock_i <= wrong);  // line 82
    if (rst) begin
      score <= 7'd0;
      strikes <= 3'd0;
      credit <= 1'b0;
      ended <= 1'b0;
      one_ends <= 1'b0;
      four_end <= 1'b0;
      long <= 1'b0;
      slow <= 3'd0;
      wrong <= 12'd4095;
      none_left <= 1'b0;
      few_left <= 1'b0;
      all_left <= 1'b1;
      hall <= 2'd0;
    end
  end

  assign lost_o = choice_2 || both || both_2 || both_3;
  assign fatal_o = fatal;
  assign reason_o =
      (fatal || choice_2) ?
      (fault_pin_i ? Reason_kFaultPin :
      below_103 ? Reason_kOverCurrent :
      Reason_kStepOut) :
      both ? Reason_kStall :
      both_2 ? Reason_kWrongLock :
      both_3 ? Reason_kHallCode :
      Reason_kNone;
  assign freewheel_long_o = commutate_i && long_next;

  // What nothing reads, for the linters.
  wire unused = &{1'b0, words_stall_i, words_slip_i};
endmodule
