// start_sequence: steplock::StartSequence, printed by hlsgen from hls/six_step/start_sequence.hpp:41.
// Do not edit: change the C++ and print again.

module start_sequence #(
    parameter logic OBSERVES = 1'b1  // else kObserve is left out, as with words.observe = 0
) (
    input  logic        clk,
    input  logic        rst,  // synchronous, active high
    input  logic        tick_i,  // the slow time base
    input  logic        command_configured_i,  // the words are valid; until then all six gates are off
    input  logic        command_run_i,
    input  logic        command_reverse_i,
    input  logic        command_brake_to_stop_i,  // else coast
    input  logic        command_clear_fault_i,  // a rising edge re-arms, once `run` is low and the cause is gone
    input  logic        source_i,
    input  logic [11:0] words_settle_i,  // first pattern, so that a rotor opposite to the reset place moves
    input  logic [11:0] words_reset_i,  // reset pattern: t_r of Eq. (22)
    input  logic [15:0] words_reset_duty_i,  // twice that from the third try on, and so start_duty
    input  logic [15:0] words_start_duty_i,  // during acceleration and pull-in
    input  logic [19:0] words_ramp_i,  // u0.32 per tick: the VCO's acceleration; a quarter after each failed try
    input  logic [25:0] words_hand_over_i,  // f_a: the end of the ramp
    input  logic [15:0] words_window_i,  // u0.16: a crossing closer than this to its place is a good one
    input  logic [5:0]  words_good_crossings_i,  // in a row, for lock (and for catching)
    input  logic [11:0] words_pull_in_i,  // time limit from hand-over to lock
    input  logic [11:0] words_observe_i,  // time to look for a rotor that already spins; 0 skips it
    input  logic [11:0] words_slow_down_i,  // time limit for slowing to hand-over speed before a reversal
    input  logic [11:0] words_brake_i,  // one braking interval, between two looks
    input  logic [15:0] words_brake_duty_i,
    input  logic [11:0] words_rest_i,  // gates off between a failure and the next try
    input  logic [3:0]  words_retries_i,  // failed tries before the fault latches
    input  logic        fast_i,  // the VCO's frequency is hand_over or more
    input  logic        commutate_i,  // strobe: a new step began
    input  logic        update_i,  // strobe: the phase detector has a new error
    input  logic        good_i,  // with `update`: it is a small one
    input  logic        lags_i,  // the last error was negative: the rotor lags the VCO
    input  logic        turns_reverse_i,  // while observing: the code last moved downwards
    input  logic [2:0]  sector_i,  // while observing: 0 to 5
    input  logic        lost_i,  // protection: give up this try
    input  logic        fatal_i,  // protection: latch
    input  logic [3:0]  cause_i,  // protection: why
    output logic [3:0]  state_o,
    output logic [3:0]  reason_o,  // of the last failed try, or of the fault
    output logic        enable_o,  // the gate guard may turn gates on
    output logic [4:0]  pattern_bits_o,  // public, for a set to be a port
    output logic        reverse_o,  // direction of this try
    output logic        running_o,  // locked and under speed control
    output logic [1:0]  mode_o,
    output logic [15:0] duty_o,  // u1.15, for kFixed and kAboveBemf
    output logic        stop_o,  // speed control: towards standstill, not the set speed
    output logic [1:0]  watch_o,  // phase detector
    output logic [2:0]  loop_o,  // loop filter
    output logic        load_step_o,  // one clock: take `step`, in its middle
    output logic [2:0]  step_o,  // 0 to 5
    output logic        turn_vco_o,  // the VCO may count
    output logic [1:0]  gentle_o,  // loop filter: the ramp is quartered so often
    output logic        began_o,  // one clock: `run` was obeyed
    output logic        failed_o  // one clock: a try failed
);
  localparam logic [3:0] Reason_kNone = 4'd0;
  localparam logic [3:0] Reason_kNoLock = 4'd6;
  localparam logic [3:0] Reason_kCannotStop = 4'd7;
  localparam logic [1:0] SpeedMode_kFixed = 2'd0;
  localparam logic [1:0] SpeedMode_kAboveBemf = 2'd1;
  localparam logic [1:0] SpeedMode_kControl = 2'd2;
  localparam logic [1:0] Evidence_kNothing = 2'd0;
  localparam logic [1:0] Evidence_kCrossings = 2'd1;
  localparam logic [1:0] Evidence_kSectors = 2'd2;
  localparam logic [2:0] Loop_kStop = 3'd0;
  localparam logic [2:0] Loop_kRamp = 3'd1;
  localparam logic [2:0] Loop_kTrack = 3'd2;
  localparam logic [2:0] Loop_kCatch = 3'd3;
  localparam logic [2:0] Loop_kHall = 3'd4;

  logic [10:0] at_bits;  // public, for a set to be a port
  logic drives;  // one of the states in which the bridge commutates
  logic enables;  // or one of the others in which gates may be on
  logic boosts;  // one of those whose duty comes above the back-EMF's
  logic entered;  // this is the first clock of the state
  logic braking;  // a braking interval begins
  logic [3:0] reason;
  logic load_step;
  logic began;
  logic failed;
  logic reverse;  // direction of this try
  logic clear_was;

  wire counters_over;
  wire counters_enough;
  wire counters_tried;
  wire counters_braked;
  wire counters_turns_reverse;
  wire [1:0] counters_gentle;
  wire counters_strong;
  start_counters counters (
      .clk(clk),
      .rst(rst),
      .tick_i(tick_i),
      .state_bits_i(at_bits),
      .entered_i(entered),
      .failed_i(failed),
      .braking_i(braking),
      .update_i(update_i),
      .good_i(good_i),
      .turns_reverse_i(turns_reverse_i),
      .words_settle_i(words_settle_i),
      .words_reset_i(words_reset_i),
      .words_reset_duty_i(words_reset_duty_i),
      .words_start_duty_i(words_start_duty_i),
      .words_ramp_i(words_ramp_i),
      .words_hand_over_i(words_hand_over_i),
      .words_window_i(words_window_i),
      .words_good_crossings_i(words_good_crossings_i),
      .words_pull_in_i(words_pull_in_i),
      .words_observe_i(words_observe_i),
      .words_slow_down_i(words_slow_down_i),
      .words_brake_i(words_brake_i),
      .words_brake_duty_i(words_brake_duty_i),
      .words_rest_i(words_rest_i),
      .words_retries_i(words_retries_i),
      .over_o(counters_over),
      .enough_o(counters_enough),
      .tried_o(counters_tried),
      .braked_o(counters_braked),
      .turns_reverse_o(counters_turns_reverse),
      .gentle_o(counters_gentle),
      .strong_o(counters_strong)
  );

  wire [2:0] either_218 = {1'b0, at_bits[3] ? 2'd3 : at_bits[2:1]} | {at_bits[4], 2'd0};
  wire [1:0] choice_218 = at_bits[6] ? 2'd2 : 2'd0;  // line 218
  wire [3:0] wide_218 =  // line 218
      {1'b0,
      either_218 | (at_bits[5] ? 3'd5 : 3'd0) | {choice_218[1], choice_218} | {3{at_bits[7]}}};
  wire [3:0] either_218_2 = wide_218 | {at_bits[8], 3'd0} | (at_bits[9] ? 4'd9 : 4'd0);  // line 218
  wire [4:0] either_234 = {3'd0, (drives ? 2'd2 : 2'd0) | {1'b0, !enables}} | {at_bits[2], 4'd0};

  wire [15:0] open_loop_duty;
  open_loop_duty open_loop (
      .clk(clk),
      .rst(rst),
      .state_bits_i(at_bits),
      .strong_i(counters_strong),
      .commutate_i(commutate_i),
      .lags_i(lags_i),
      .reset_duty_i(words_reset_duty_i),
      .start_duty_i(words_start_duty_i),
      .brake_duty_i(words_brake_duty_i),
      .duty_o(open_loop_duty)
  );

  wire both_239 = at_bits[8:7] != 2'd0 && source_i;  // line 239
  wire either = at_bits[6] || (at_bits[8:7] != 2'd0 && !source_i);
  wire inverse_255 = !reverse;  // line 255
  wire [2:0] choice_256 = (sector_i[2] ? sector_i[0] : !sector_i[1] && !sector_i[0]) ? 3'd4 : 3'd0;
  wire [1:0] choice_256_2 = (sector_i[0] ? sector_i[1] : sector_i[2]) ? 2'd2 : 2'd0;  // line 256
  wire [2:0] either_256 = choice_256 | {1'b0, choice_256_2} | {2'd0, !sector_i[0]};  // line 256
  wire either_160 =  // line 160
      (at_bits[6] && counters_over && !counters_enough) || (at_bits[8:7] != 2'd0 && lost_i);
  wire either_99 = !(!at_bits[5] || fast_i || !counters_over) || either_160;  // line 99
  wire choice_147 =  // line 147
      (!command_brake_to_stop_i || at_bits[8:7] != 2'd0) ? command_brake_to_stop_i :
      at_bits[2:1] != 2'd0;
  wire either_149 = command_run_i || choice_147;  // line 149
  wire both_152 = !fatal_i && either_149;  // line 152
  wire either_152 = at_bits[10] || !command_configured_i;  // line 152
  wire both_99 = !either_152 && both_152;  // line 99
  wire failed_next = both_99 && either_99;  // line 99
  wire [9:0] choice_191 = (failed_next && !counters_tried) ? 10'd512 : 10'd0;  // line 191
  wire both_150 = command_clear_fault_i && !clear_was && !(command_run_i || fatal_i);  // line 150
  wire both_151 = command_configured_i && fatal_i;  // line 151
  wire choice_154 = at_bits[10] ? !both_150 : both_151;  // line 154
  wire differ_99 = command_reverse_i ^ reverse;  // line 99
  wire either_176 = !command_run_i || differ_99;  // line 176
  wire either_158 = !at_bits[8] || lost_i;  // line 158
  wire both_99_2 = !either_158 && either_176 && (counters_over || !fast_i);  // line 99
  wire differ_99_2 = counters_turns_reverse ^ reverse;  // line 99
  wire both_157 = at_bits[1] && counters_enough;  // line 157
  wire choice_99 = both_157 ? !command_run_i || differ_99_2 || both_99_2 : both_99_2;  // line 99
  wire braking_next = both_99 && choice_99;  // line 99
  wire [10:0] choice_191_2 =  // line 191
      (choice_154 || (braking_next && counters_braked) || (failed_next && counters_tried)) ?
      11'd1024 : 11'd0;
  wire both_156 = at_bits[9] && counters_over;  // line 156
  wire both_130 = OBSERVES && !source_i;  // line 130
  wire both_130_2 = both_130 && words_observe_i != 12'd0;  // line 130
  wire both_155 = at_bits[2] && counters_over;  // line 155
  wire choice_99_2 = both_155 ? command_run_i || both_130_2 || both_156 : both_156;  // line 99
  wire either_99_2 = at_bits[0] || choice_99_2;  // line 99
  wire both_99_3 = both_99 && either_99_2;  // line 99
  wire [3:0] choice_209 = (both_99_3 && !(both_130_2 || source_i)) ? 4'd8 : 4'd0;  // line 209
  wire [2:0] choice_191_3 = (braking_next && !counters_braked) ? 3'd4 : 3'd0;  // line 191
  wire [1:0] choice_191_4 = (both_99_3 && both_130 && words_observe_i != 12'd0) ? 2'd2 : 2'd0;
  wire choice_153 = either_152 ? !at_bits[10] || both_150 : !(either_149 || fatal_i);  // line 153
  wire [7:0] choice_208 = (both_99_3 && !both_130_2 && source_i) ? 8'd128 : 8'd0;  // line 208
  wire [7:0] wide_207 = {6'd0, choice_191_4 | {1'b0, choice_153}};  // line 207
  wire inverse_194 = !(counters_enough || counters_over);  // line 194
  wire [1:0] choice_194 = (OBSERVES && at_bits[1] && inverse_194) ? 2'd2 : 2'd0;  // line 194
  wire both_186 = at_bits[1] && !counters_enough && counters_over;  // line 186
  wire both_100 =  // line 100
      !(!both_155 || command_run_i) && (!OBSERVES || source_i || words_observe_i == 12'd0);
  wire [2:0] choice_191_5 = (at_bits[2] && !counters_over) ? 3'd4 : 3'd0;  // line 191
  wire [2:0] wide_194 = {1'b0, choice_194 | {1'b0, (both_186 && !command_run_i) || both_100}};
  wire [3:0] choice_191_6 =  // line 191
      ((both_186 && command_run_i) || (at_bits[3] && !counters_over)) ? 4'd8 : 4'd0;
  wire [4:0] choice_191_7 = (counters_over ? at_bits[3] : at_bits[4]) ? 5'd16 : 5'd0;  // line 191
  wire [4:0] wide_196 = {1'b0, {1'b0, wide_194 | choice_191_5} | choice_191_6};  // line 196
  wire [5:0] choice_198 =  // line 198
      ((at_bits[4] && counters_over) || (at_bits[5] && !(fast_i || counters_over))) ? 6'd32 : 6'd0;
  wire both_200 = at_bits[5] && fast_i;  // line 200
  wire [6:0] choice_200 = (both_200 || (at_bits[6] && inverse_194)) ? 7'd64 : 7'd0;  // line 200
  wire [6:0] wide_199 = {1'b0, {1'b0, wide_196 | choice_191_7} | choice_198};  // line 199
  wire either_202 = (both_157 && command_run_i && !differ_99_2) || (at_bits[6] && counters_enough);
  wire both_202 = command_run_i && !differ_99;  // line 202
  wire both_189 = at_bits[8:7] != 2'd0 && !lost_i;  // line 189
  wire [7:0] choice_191_8 = ((either_202 || !both_189) ? either_202 : both_202) ? 8'd128 : 8'd0;
  wire [7:0] wide_201 = {1'b0, wide_199 | choice_200};  // line 201
  wire [8:0] choice_203 =  // line 203
      (both_189 && either_176 && (at_bits[7] || (!counters_over && fast_i))) ? 9'd256 : 9'd0;
  wire [8:0] wide_202 = {1'b0, wide_201 | choice_191_8};  // line 202
  wire [9:0] choice_191_9 = (at_bits[9] && !counters_over) ? 10'd512 : 10'd0;  // line 191
  wire [9:0] wanted = {1'b0, wide_202 | choice_203} | choice_191_9;  // line 203
  wire [9:0] choice_205 = (choice_153 || choice_154) ? 10'd0 : wanted;  // line 205
  wire [9:0] either_207 = {2'd0, wide_207 | choice_208} | choice_205;  // line 207
  wire [9:0] either_209 = {6'd0, choice_209 | {1'b0, choice_191_3}} | either_207;  // line 209
  wire [10:0] at_bits_next = {1'b0, choice_191} | choice_191_2 | {1'b0, either_209};  // line 211
  wire either_118 = choice_205[6:5] != 2'd0 || either_207[7];  // line 118
  wire began_next = both_99_3 && at_bits[0];  // line 102

  always_ff @(posedge clk) begin
    at_bits <= at_bits_next;  // line 211
    drives <= either_118 || choice_205[8];
    enables <= either_118 || choice_205[8] || either_209[3:2] != 2'd0 || choice_205[4];
    boosts <= choice_205[6:5] != 2'd0;  // line 117
    if (began_next) begin
      entered <= 1'b1;
      reason <= Reason_kNone;
      reverse <= command_reverse_i;
    end else begin
      if (both_99) begin
        logic choice_161;
        logic choice_161_2;
        logic either_161;
        logic inverse_169;
        choice_161 = either_158 ? at_bits[8] : both_202 || !fast_i;  // line 161
        choice_161_2 =  // line 161
            at_bits[7] ? lost_i || !command_run_i || differ_99 || choice_161 : choice_161;
        either_161 = both_200 || choice_161_2;  // line 161
        inverse_169 = !(!at_bits[0] && (!counters_over || (at_bits & 11'h481) != 11'd0));
        entered <= inverse_169 || (counters_enough && (at_bits[6:1] & 6'h21) != 6'd0) || either_161;
      end else begin
        entered <=
            (at_bits & 11'h401) == 11'd0 || (at_bits[0] && both_151) || (at_bits[10] && both_150);
      end
      if (!at_bits[10]) begin
        logic both_99_4;
        both_99_4 = command_configured_i && both_152;  // line 99
        if ((both_99_4 && either_99) || at_bits_next[10]) begin
          if (both_99_4 && choice_99) begin
            reason <= Reason_kCannotStop;
          end else if (fatal_i || lost_i) begin
            reason <= cause_i;
          end else begin
            reason <= Reason_kNoLock;
          end
        end
        if (both_99_4 && either_99_2) begin
          reverse <= command_reverse_i;
        end
      end
    end
    braking <= braking_next;  // line 99
    if (at_bits[5]) begin
      load_step <= at_bits[1] && either_207[7];
    end else if (choice_205[5] || !at_bits[1]) begin
      load_step <= choice_205[5];
    end else begin
      load_step <= either_207[7];
    end
    began <= began_next;  // line 102
    failed <= failed_next;  // line 99
    clear_was <= command_clear_fault_i;
    if (rst) begin
      at_bits <= 11'd1;
      drives <= 1'b0;
      enables <= 1'b0;
      boosts <= 1'b0;
      entered <= 1'b0;
      braking <= 1'b0;
      reason <= Reason_kNone;
      load_step <= 1'b0;
      began <= 1'b0;
      failed <= 1'b0;
      reverse <= 1'b0;
      clear_was <= 1'b0;
    end
  end

  assign state_o = either_218_2 | (at_bits[10] ? 4'd10 : 4'd0);
  assign reason_o = reason;
  assign enable_o = enables;
  assign pattern_bits_o = either_234 | {2'd0, at_bits[3], 2'd0} | {1'b0, at_bits[4], 3'd0};
  assign reverse_o = reverse;
  assign running_o = at_bits[8:7] != 2'd0;
  assign mode_o =
      (at_bits[8:7] == 2'd0) ? ((at_bits[1] || boosts) ? SpeedMode_kAboveBemf : SpeedMode_kFixed) :
      SpeedMode_kControl;
  assign duty_o = open_loop_duty;
  assign stop_o = at_bits[8];
  assign watch_o =
      (at_bits[1] || both_239) ? Evidence_kSectors :
      either ? Evidence_kCrossings :
      Evidence_kNothing;
  assign loop_o =
      at_bits[1] ? Loop_kCatch :
      both_239 ? Loop_kHall :
      either ? Loop_kTrack :
      at_bits[5] ? Loop_kRamp :
      Loop_kStop;
  assign load_step_o = load_step;
  assign step_o =
      at_bits[5] ? {1'b0, {2{inverse_255}}} :
      reverse ? sector_i :
      either_256;
  assign turn_vco_o = at_bits[1] || drives;
  assign gentle_o = counters_gentle;
  assign began_o = began;
  assign failed_o = failed;
endmodule
