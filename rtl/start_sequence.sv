// start_sequence: steplock::StartSequence, printed by hlsgen from hls/six_step/start_sequence.hpp:38.
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
  logic [15:0] duty;  // u1.15, of the state a clock ago; in kPullIn it fades
  logic entered;  // this is the first clock of the state
  logic late;  // there was a tick in it
  logic last;  // no ticks are left
  logic tried;  // no more tries are left
  logic braking;  // a braking interval begins
  logic braked;  // no more braking intervals are left
  logic [3:0] reason;
  logic [14:0] ticks;  // left in this state
  logic [5:0] good;  // good crossings in a row
  logic nearly;  // one more is enough
  logic enough;  // that one came in the last clock
  logic [3:0] retries;  // failed tries
  logic [7:0] brakes;  // braking intervals of this stop
  logic faded;  // the duty is below the start's
  logic load_step;
  logic began;
  logic failed;
  logic reverse;  // direction of this try
  logic turns_reverse;  // direction at the last update while observing
  logic clear_was;

  wire [2:0] either_280 = {1'b0, at_bits[3] ? 2'd3 : at_bits[2:1]} | {at_bits[4], 2'd0};
  wire [1:0] choice_280 = at_bits[6] ? 2'd2 : 2'd0;  // line 280
  wire [3:0] wide_280 =  // line 280
      {1'b0,
      either_280 | (at_bits[5] ? 3'd5 : 3'd0) | {choice_280[1], choice_280} | {3{at_bits[7]}}};
  wire [3:0] either_280_2 = wide_280 | {at_bits[8], 3'd0} | (at_bits[9] ? 4'd9 : 4'd0);  // line 280
  wire [4:0] either_296 = {3'd0, (drives ? 2'd2 : 2'd0) | {1'b0, !enables}} | {at_bits[2], 4'd0};
  wire both_301 = at_bits[8:7] != 2'd0 && source_i;  // line 301
  wire either = at_bits[6] || (at_bits[8:7] != 2'd0 && !source_i);
  wire inverse_320 = !reverse;  // line 320
  wire [2:0] choice_321 = (sector_i[2] ? sector_i[0] : !sector_i[1] && !sector_i[0]) ? 3'd4 : 3'd0;
  wire [1:0] choice_321_2 = (sector_i[0] ? sector_i[1] : sector_i[2]) ? 2'd2 : 2'd0;  // line 321
  wire [2:0] either_321 = choice_321 | {1'b0, choice_321_2} | {2'd0, !sector_i[0]};  // line 321
  wire [1:0] gentle = (retries[3:2] == 2'd0) ? retries[1:0] : 2'd3;  // line 316
  wire both = tick_i && last && !entered;
  wire either_144 = (at_bits[6] && both && !enough) || (at_bits[8:7] != 2'd0 && lost_i);
  wire either_81 = !(!at_bits[5] || fast_i || !both) || either_144;  // line 81
  wire choice_131 =  // line 131
      (!command_brake_to_stop_i || at_bits[8:7] != 2'd0) ? command_brake_to_stop_i :
      at_bits[2:1] != 2'd0;
  wire either_133 = command_run_i || choice_131;  // line 133
  wire both_136 = !fatal_i && either_133;  // line 136
  wire either_136 = at_bits[10] || !command_configured_i;  // line 136
  wire both_81 = !either_136 && both_136;  // line 81
  wire failed_next = both_81 && either_81;  // line 81
  wire [9:0] choice_172 = (failed_next && !tried) ? 10'd512 : 10'd0;  // line 172
  wire differ_81 = command_reverse_i ^ reverse;  // line 81
  wire either_160 = !command_run_i || differ_81;  // line 160
  wire either_142 = !at_bits[8] || lost_i;  // line 142
  wire both_81_2 = !either_142 && either_160 && (both || !fast_i);  // line 81
  wire differ_81_2 = turns_reverse ^ reverse;  // line 81
  wire both_141 = at_bits[1] && enough;  // line 141
  wire choice_81 = both_141 ? !command_run_i || differ_81_2 || both_81_2 : both_81_2;  // line 81
  wire braking_next = both_81 && choice_81;  // line 81
  wire both_134 = command_clear_fault_i && !clear_was && !(command_run_i || fatal_i);  // line 134
  wire both_135 = command_configured_i && fatal_i;  // line 135
  wire choice_138 = at_bits[10] ? !both_134 : both_135;  // line 138
  wire [10:0] choice =
      (choice_138 || (braking_next && braked) || (failed_next && tried)) ? 11'd1024 : 11'd0;
  wire both_140 = at_bits[9] && both;  // line 140
  wire both_115 = OBSERVES && !source_i;  // line 115
  wire both_115_2 = both_115 && words_observe_i != 12'd0;  // line 115
  wire both_139 = at_bits[2] && both;  // line 139
  wire choice_81_2 = both_139 ? command_run_i || both_115_2 || both_140 : both_140;  // line 81
  wire either_81_2 = at_bits[0] || choice_81_2;  // line 81
  wire both_81_3 = both_81 && either_81_2;  // line 81
  wire [3:0] choice_172_2 = (both_81_3 && !(both_115_2 || source_i)) ? 4'd8 : 4'd0;  // line 172
  wire [2:0] choice_172_3 = (braking_next && !braked) ? 3'd4 : 3'd0;  // line 172
  wire [1:0] choice_172_4 = (both_81_3 && both_115 && words_observe_i != 12'd0) ? 2'd2 : 2'd0;
  wire choice_137 = either_136 ? !at_bits[10] || both_134 : !(either_133 || fatal_i);  // line 137
  wire [7:0] choice_172_5 = (both_81_3 && !both_115_2 && source_i) ? 8'd128 : 8'd0;  // line 172
  wire [7:0] wide_188 = {6'd0, choice_172_4 | {1'b0, choice_137}};  // line 188
  wire inverse_82 = !(enough || both);  // line 82
  wire [1:0] choice_172_6 = (OBSERVES && at_bits[1] && inverse_82) ? 2'd2 : 2'd0;  // line 172
  wire both_167 = at_bits[1] && !enough && both;  // line 167
  wire [2:0] choice_172_7 = (at_bits[2] && !both) ? 3'd4 : 3'd0;  // line 172
  wire [2:0] wide_175 =  // line 175
      {1'b0,
      choice_172_6 |
      {1'b0, (both_167 && !command_run_i) || (both_139 && !(command_run_i || both_115_2))}};
  wire [3:0] choice_172_8 = ((both_167 && command_run_i) || (at_bits[3] && !both)) ? 4'd8 : 4'd0;
  wire [4:0] choice_172_9 = (both ? at_bits[3] : at_bits[4]) ? 5'd16 : 5'd0;  // line 172
  wire [4:0] wide_177 = {1'b0, {1'b0, wide_175 | choice_172_7} | choice_172_8};  // line 177
  wire [5:0] choice_172_10 =  // line 172
      ((at_bits[4] && both) || (at_bits[5] && !(fast_i || both))) ? 6'd32 : 6'd0;
  wire both_181 = at_bits[5] && fast_i;  // line 181
  wire [6:0] choice_172_11 = (both_181 || (at_bits[6] && inverse_82)) ? 7'd64 : 7'd0;  // line 172
  wire [6:0] wide_180 = {1'b0, {1'b0, wide_177 | choice_172_9} | choice_172_10};  // line 180
  wire either_183 = (both_141 && command_run_i && !differ_81_2) || (at_bits[6] && enough);
  wire both_183 = command_run_i && !differ_81;  // line 183
  wire both_170 = at_bits[8:7] != 2'd0 && !lost_i;  // line 170
  wire [7:0] choice_172_12 = ((either_183 || !both_170) ? either_183 : both_183) ? 8'd128 : 8'd0;
  wire [7:0] wide_182 = {1'b0, wide_180 | choice_172_11};  // line 182
  wire [8:0] choice_172_13 =  // line 172
      (both_170 && either_160 && (at_bits[7] || (!both && fast_i))) ? 9'd256 : 9'd0;
  wire [8:0] wide_183 = {1'b0, wide_182 | choice_172_12};  // line 183
  wire [9:0] choice_172_14 = (at_bits[9] && !both) ? 10'd512 : 10'd0;  // line 172
  wire [9:0] wanted = {1'b0, wide_183 | choice_172_13} | choice_172_14;  // line 184
  wire [9:0] choice_186 = (choice_137 || choice_138) ? 10'd0 : wanted;  // line 186
  wire [9:0] either_188 = {2'd0, wide_188 | choice_172_5} | choice_186;  // line 188
  wire [9:0] either_190 = {6'd0, choice_172_2 | {1'b0, choice_172_3}} | either_188;  // line 190
  wire [10:0] at_bits_next = {1'b0, choice_172} | choice | {1'b0, either_190};  // line 192
  wire either_103 = choice_186[6:5] != 2'd0 || either_188[7];  // line 103
  wire [12:0] change = {lags_i ? {1'b0, duty[15:5]} : ~{1'b0, duty[15:5]}, 1'b0} | {12'd0, !lags_i};
  wire [16:0] change_2 = {{4{change[12]}}, change};  // line 266
  wire [16:0] sum_267 = {duty, 1'b1} + change_2;  // line 267
  wire [15:0] choice_2 =
      (retries[3:1] == 3'd0) ? words_start_duty_i :
      words_start_duty_i[15] ? 16'd65535 :
      {words_start_duty_i[14:0], 1'b0};
  wire [6:0] sum_242 = {1'b0, good} + 7'd1;  // line 242

  always_ff @(posedge clk) begin
    at_bits <= at_bits_next;  // line 192
    drives <= either_103 || choice_186[8];
    enables <= either_103 || choice_186[8] || either_190[3:2] != 2'd0 || choice_186[4];
    boosts <= choice_186[6:5] != 2'd0;  // line 102
    if (at_bits[6]) begin
      if (commutate_i && !(lags_i && !faded)) begin
        duty <= sum_267[16:1];
      end
    end else if (at_bits[5]) begin
      duty <= choice_2;
    end else if (at_bits[4:3] == 2'd0) begin
      if (at_bits[2]) begin
        duty <= words_brake_duty_i;
      end else begin
        duty <= 16'd0;
      end
    end else if (retries[3:1] == 3'd0) begin
      duty <= words_reset_duty_i;
    end else if (words_reset_duty_i[15]) begin
      duty <= 16'd65535;
    end else begin
      duty <= {words_reset_duty_i[14:0], 1'b0};
    end
    if (both_81) begin
      logic choice_145;
      logic choice_145_2;
      logic either_145;
      logic inverse_153;
      choice_145 = either_142 ? at_bits[8] : both_183 || !fast_i;  // line 145
      choice_145_2 = at_bits[7] ? lost_i || !command_run_i || differ_81 || choice_145 : choice_145;
      either_145 = both_181 || choice_145_2;  // line 145
      inverse_153 = !(!at_bits[0] && (!both || (at_bits & 11'h481) != 11'd0));  // line 153
      entered <= inverse_153 || (enough && (at_bits[6:1] & 6'h21) != 6'd0) || either_145;
    end else begin
      entered <=
          (at_bits & 11'h401) == 11'd0 || (at_bits[0] && both_135) || (at_bits[10] && both_134);
    end
    late <= tick_i && entered;  // line 219
    last <= !entered && ticks == 15'd0;  // line 220
    tried <= (words_retries_i <= retries);  // line 226
    if (at_bits[10]) begin
      braking <= 1'b0;
      began <= 1'b0;
      failed <= 1'b0;
    end else begin
      logic both_81_4;
      logic both_81_5;
      logic both_81_6;
      logic both_84;
      logic both_81_7;
      both_81_4 = command_configured_i && both_136;  // line 81
      both_81_5 = both_81_4 && choice_81;  // line 81
      both_81_6 = both_81_4 && either_81_2;  // line 81
      both_84 = both_81_6 && at_bits[0];  // line 84
      both_81_7 = both_81_4 && either_81;  // line 81
      braking <= both_81_5;
      if (both_84) begin
        reason <= Reason_kNone;
        reverse <= command_reverse_i;
      end else begin
        if (both_81_7 || at_bits_next[10]) begin
          if (both_81_5) begin
            reason <= Reason_kCannotStop;
          end else if (fatal_i || lost_i) begin
            reason <= cause_i;
          end else begin
            reason <= Reason_kNoLock;
          end
        end
        if (both_81_6) begin
          reverse <= command_reverse_i;
        end
      end
      began <= both_84;
      failed <= both_81_7;
    end
    braked <= brakes == 8'd255;  // line 232
    if (entered) begin
      logic [14:0] wide_206;
      logic [14:0] once;
      logic [14:0] then;
      logic [14:0] once_2;
      logic [14:0] then_2;
      logic [14:0] either_207;
      logic [14:0] either_209;
      logic [14:0] either_210;
      logic [12:0] once_3;
      logic [14:0] then_3;
      wide_206 =  // line 206
          {3'd0, (at_bits[1] ? words_observe_i : 12'd0) | (at_bits[2] ? words_brake_i : 12'd0)};
      once = {3'd0, words_settle_i} << gentle[0];  // line 200
      then = gentle[1] ? {once[12:0], 2'd0} : once;  // line 201
      once_2 = {3'd0, words_reset_i} << gentle[0];  // line 200
      then_2 = gentle[1] ? {once_2[12:0], 2'd0} : once_2;  // line 201
      either_207 = wide_206 | (at_bits[3] ? then : 15'd0) | (at_bits[4] ? then_2 : 15'd0);
      either_209 =  // line 209
          either_207 | {3'd0, at_bits[6] ? words_pull_in_i : 12'd0} |
          {3'd0, at_bits[8] ? words_slow_down_i : 12'd0};
      either_210 =  // line 210
          either_209 | {3'd0, at_bits[9] ? words_rest_i : 12'd0} | {4'd0, at_bits[7], 10'd0};
      once_3 = gentle[0] ? 13'd8190 : 13'd4095;  // line 200
      then_3 = gentle[1] ? {once_3, 2'd0} : {2'd0, once_3};  // line 201
      ticks <= either_210 | (at_bits[5] ? then_3 : 15'd0);
      good <= 6'd0;
      enough <= 1'b0;
    end else begin
      if ((tick_i || late) && ticks != 15'd0) begin
        ticks <= ticks - 15'd1;
      end
      if (update_i) begin
        if (at_bits[1] && (turns_reverse_i ^ turns_reverse)) begin
          good <= 6'd0;
          enough <= 1'b0;
        end else begin
          if (good_i) begin
            good <= sum_242[5:0];
          end else begin
            good <= 6'd0;
          end
          enough <= good_i && nearly;
        end
        turns_reverse <= turns_reverse_i;
      end else begin
        enough <= 1'b0;
      end
    end
    nearly <= ({1'b0, words_good_crossings_i} <= sum_242);  // line 242
    if (at_bits[0] || (both && at_bits[7])) begin
      retries <= 4'd0;
    end else if (failed) begin
      retries <= retries + 4'd1;
    end
    if ((at_bits[7:0] & 8'h81) == 8'd0) begin
      if (braking) begin
        brakes <= brakes + 8'd1;
      end
    end else begin
      brakes <= 8'd0;
    end
    faded <= duty < choice_2;  // line 258
    if (at_bits[5]) begin
      load_step <= at_bits[1] && either_188[7];
    end else if (choice_186[5] || !at_bits[1]) begin
      load_step <= choice_186[5];
    end else begin
      load_step <= either_188[7];
    end
    clear_was <= command_clear_fault_i;
    if (rst) begin
      at_bits <= 11'd1;
      drives <= 1'b0;
      enables <= 1'b0;
      boosts <= 1'b0;
      duty <= 16'd0;
      entered <= 1'b0;
      late <= 1'b0;
      last <= 1'b0;
      tried <= 1'b0;
      braking <= 1'b0;
      braked <= 1'b0;
      reason <= Reason_kNone;
      ticks <= 15'd0;
      good <= 6'd0;
      nearly <= 1'b0;
      enough <= 1'b0;
      retries <= 4'd0;
      brakes <= 8'd0;
      faded <= 1'b0;
      load_step <= 1'b0;
      began <= 1'b0;
      failed <= 1'b0;
      reverse <= 1'b0;
      turns_reverse <= 1'b0;
      clear_was <= 1'b0;
    end
  end

  assign state_o = either_280_2 | (at_bits[10] ? 4'd10 : 4'd0);
  assign reason_o = reason;
  assign enable_o = enables;
  assign pattern_bits_o = either_296 | {2'd0, at_bits[3], 2'd0} | {1'b0, at_bits[4], 3'd0};
  assign reverse_o = reverse;
  assign running_o = at_bits[8:7] != 2'd0;
  assign mode_o =
      (at_bits[8:7] == 2'd0) ? ((at_bits[1] || boosts) ? SpeedMode_kAboveBemf : SpeedMode_kFixed) :
      SpeedMode_kControl;
  assign duty_o = duty;
  assign stop_o = at_bits[8];
  assign watch_o =
      (at_bits[1] || both_301) ? Evidence_kSectors :
      either ? Evidence_kCrossings :
      Evidence_kNothing;
  assign loop_o =
      at_bits[1] ? Loop_kCatch :
      both_301 ? Loop_kHall :
      either ? Loop_kTrack :
      at_bits[5] ? Loop_kRamp :
      Loop_kStop;
  assign load_step_o = load_step;
  assign step_o =
      at_bits[5] ? {1'b0, {2{inverse_320}}} :
      reverse ? sector_i :
      either_321;
  assign turn_vco_o = at_bits[1] || drives;
  assign gentle_o = gentle;
  assign began_o = began;
  assign failed_o = failed;

  // What nothing reads, for the linters.
  wire unused = &{1'b0, words_ramp_i, words_hand_over_i, words_window_i, sum_267[0]};
endmodule
