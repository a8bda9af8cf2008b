// start_sequence: steplock::StartSequence, printed by hlsgen from hls/six_step/start_sequence.hpp:34.
// Do not edit: change the C++ and print again.

module start_sequence (
    input  logic        clk,
    input  logic        rst,  // synchronous, active high
    input  logic        tick_i,  // the slow time base
    input  logic        command_configured_i,  // the words are valid; until then all six gates are off
    input  logic        command_run_i,
    input  logic        command_reverse_i,
    input  logic        command_brake_to_stop_i,  // else coast
    input  logic        command_clear_fault_i,  // a rising edge re-arms, once `run` is low and the cause is gone
    input  logic        source_i,
    input  logic [11:0] words_settle_i,  // first pattern, so that a rotor opposite to the reset position moves
    input  logic [11:0] words_reset_i,  // reset pattern: t_r of Eq. (22)
    input  logic [15:0] words_reset_duty_i,
    input  logic [15:0] words_start_duty_i,  // during acceleration and pull-in
    input  logic [19:0] words_ramp_i,  // u0.32 per tick: the VCO's acceleration
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
    input  logic [25:0] target_i,  // u0.32, set speed
    input  logic [25:0] frequency_i,  // u0.32, of the VCO
    input  logic        commutate_i,  // strobe: a new step began
    input  logic        update_i,  // strobe: the phase detector has a new error
    input  logic        good_i,  // with `update`: it is a small one
    input  logic        turns_reverse_i,  // while observing: the code last moved downwards
    input  logic [2:0]  sector_i,  // while observing: 0 to 5
    input  logic        lost_i,  // protection: give up this try
    input  logic        fatal_i,  // protection: latch
    input  logic [3:0]  cause_i,  // protection: why
    output logic [3:0]  state_o,
    output logic [3:0]  reason_o,  // of the last failed try, or of the fault
    output logic        enable_o,  // the gate guard may turn gates on
    output logic [2:0]  pattern_o,
    output logic        reverse_o,  // direction of this try
    output logic        running_o,  // locked and under speed control
    output logic [1:0]  mode_o,
    output logic [15:0] duty_o,  // u1.15, for kFixed and kAboveBemf
    output logic [25:0] target_o,  // u0.32, for speed control
    output logic [1:0]  watch_o,  // phase detector
    output logic [2:0]  loop_o,  // loop filter
    output logic        load_o,  // loop filter: take load_frequency
    output logic [25:0] load_frequency_o,  // u0.32
    output logic        load_step_o,  // one clock: take `step`, in its middle
    output logic [2:0]  step_o,  // 0 to 5
    output logic        turn_vco_o,  // the VCO may count
    output logic        began_o,  // one clock: `run` was obeyed
    output logic        failed_o  // one clock: a try failed
);
  localparam logic [3:0] Reason_kNone = 4'd0;
  localparam logic [3:0] Reason_kNoLock = 4'd6;
  localparam logic [3:0] Reason_kCannotStop = 4'd7;
  localparam logic [3:0] State_kIdle = 4'd0;
  localparam logic [3:0] State_kObserve = 4'd1;
  localparam logic [3:0] State_kBrake = 4'd2;
  localparam logic [3:0] State_kSettle = 4'd3;
  localparam logic [3:0] State_kReset = 4'd4;
  localparam logic [3:0] State_kAccelerate = 4'd5;
  localparam logic [3:0] State_kPullIn = 4'd6;
  localparam logic [3:0] State_kRun = 4'd7;
  localparam logic [3:0] State_kSlowDown = 4'd8;
  localparam logic [3:0] State_kRest = 4'd9;
  localparam logic [3:0] State_kFault = 4'd10;
  localparam logic [2:0] Pattern_kBrake = 3'd4;
  localparam logic [1:0] SpeedMode_kFixed = 2'd0;
  localparam logic [1:0] SpeedMode_kAboveBemf = 2'd1;
  localparam logic [1:0] SpeedMode_kControl = 2'd2;
  localparam logic [1:0] Evidence_kNothing = 2'd0;
  localparam logic [1:0] Evidence_kCrossings = 2'd1;
  localparam logic [1:0] Evidence_kSectors = 2'd2;
  localparam logic [2:0] Loop_kHold = 3'd0;
  localparam logic [2:0] Loop_kRamp = 3'd1;
  localparam logic [2:0] Loop_kTrack = 3'd2;
  localparam logic [2:0] Loop_kCatch = 3'd3;
  localparam logic [2:0] Loop_kHall = 3'd4;

  logic [3:0] state;
  logic [3:0] reason;
  logic [11:0] ticks;  // left in this state
  logic [5:0] good;  // good crossings in a row
  logic [3:0] retries;  // failed tries
  logic [7:0] brakes;  // braking intervals of this stop
  logic [15:0] boost;  // u1.15, duty above the back-EMF's while pulling in
  logic [2:0] step;  // to be loaded
  logic load_step;
  logic began;
  logic failed;
  logic reverse;  // direction of this try
  logic turns_reverse;  // direction at the last update while observing
  logic clear_was;

  wire either = state == State_kBrake || state == State_kSettle || state == State_kReset;
  wire either_2 =
      either || state == State_kAccelerate || state == State_kPullIn || state == State_kRun;
  wire [1:0] choice_299 = (state == State_kSettle) ? 2'd2 : 2'd3;  // line 299
  wire either_3 = state == State_kAccelerate || state == State_kPullIn || state == State_kRun;
  wire either_4 = state == State_kSettle || state == State_kReset;
  wire [1:0] choice = either_4 ? choice_299 : {1'b0, either_3 || state == State_kSlowDown};
  wire [2:0] wide = {1'b0, choice};
  wire either_5 = state == State_kRun || state == State_kSlowDown;
  wire either_6 = state == State_kObserve || state == State_kAccelerate || state == State_kPullIn;

  logic [1:0] choice_2;
  always_comb begin
    case (state)
      State_kObserve, State_kAccelerate, State_kPullIn: choice_2 = SpeedMode_kAboveBemf;
      State_kRun, State_kSlowDown: choice_2 = SpeedMode_kControl;
      default: choice_2 = SpeedMode_kFixed;
    endcase
  end

  logic [15:0] out_duty;  // line 75
  always_comb begin
    case (state)
      State_kBrake: out_duty = words_brake_duty_i;
      State_kSettle, State_kReset: out_duty = words_reset_duty_i;
      State_kAccelerate: out_duty = words_start_duty_i;
      State_kPullIn: out_duty = boost;
      default: out_duty = 16'd0;
    endcase
  end

  logic [1:0] choice_3;
  always_comb begin
    case (state)
      State_kObserve: choice_3 = Evidence_kSectors;
      State_kPullIn: choice_3 = Evidence_kCrossings;
      State_kRun, State_kSlowDown: choice_3 = source_i ? Evidence_kSectors : Evidence_kCrossings;
      default: choice_3 = Evidence_kNothing;
    endcase
  end

  logic [2:0] choice_4;
  always_comb begin
    case (state)
      State_kObserve: choice_4 = Loop_kCatch;
      State_kAccelerate: choice_4 = Loop_kRamp;
      State_kPullIn: choice_4 = Loop_kTrack;
      State_kRun, State_kSlowDown: choice_4 = source_i ? Loop_kHall : Loop_kTrack;
      default: choice_4 = Loop_kHold;
    endcase
  end

  wire either_7 = either_6 || state == State_kRun || state == State_kSlowDown;
  wire either_8 = !command_clear_fault_i || clear_was || command_run_i || fatal_i;
  wire [1:0] choice_131 = (words_observe_i == 12'd0) ? 2'd3 : 2'd1;  // line 131
  wire [2:0] choice_5 = source_i ? 3'd7 : {1'b0, choice_131};
  wire [3:0] choice_6 = (brakes == 8'd255) ? State_kFault : State_kBrake;
  wire either_215 = (turns_reverse_i ^ reverse) || !command_run_i;  // line 215
  wire [3:0] choice_7 = either_215 ? choice_6 : State_kRun;
  wire both_210 = good_i && !(turns_reverse_i ^ turns_reverse);  // line 210
  wire [5:0] sum = good + 6'd1;
  wire [5:0] choice_212 = both_210 ? sum : 6'd0;  // line 212
  wire both_213 =  // line 213
      both_210 && words_good_crossings_i <= choice_212 && {1'b0, words_hand_over_i[25:1]} <
      frequency_i;
  wire both = update_i && both_213;
  wire both_148 = tick_i && ticks == 12'd0;  // line 148
  wire [3:0] choice_8 =
      both ? choice_7 :
      both_148 ? {2'd0, command_run_i, command_run_i} :
      both ? choice_7 : state;
  wire both_240 = !command_run_i && (source_i || words_observe_i == 12'd0);  // line 240
  wire below_107 = retries < words_retries_i;  // line 107
  wire [3:0] choice_9 = below_107 ? State_kRest : State_kFault;
  wire [3:0] choice_10 = both_148 ? choice_9 : state;
  wire below_179 = frequency_i < words_hand_over_i;  // line 179
  wire [5:0] choice_248 = update_i ? (good_i ? sum : 6'd0) : good;  // line 248
  wire both_249 = update_i && good_i && words_good_crossings_i <= choice_248;  // line 249
  wire [3:0] choice_257 = both_148 ? 4'd0 : retries;  // line 257
  wire below_107_2 = choice_257 < words_retries_i;  // line 107
  wire either_260 = !command_run_i || (command_reverse_i ^ reverse);  // line 260
  wire below_267 =  // line 267
      {1'b0, words_hand_over_i} + {3'd0, words_hand_over_i[25:2]} < {1'b0, frequency_i};
  wire both_2 = state == State_kRest && both_148;

  logic [3:0] choice_11;
  always_comb begin
    case (state)
      State_kIdle: choice_11 = {1'b0, choice_5};
      State_kObserve: choice_11 = choice_8;
      State_kBrake: choice_11 = both_148 ? {1'b0, both_240 ? 3'd0 : choice_5} : state;
      State_kSettle: choice_11 = both_148 ? State_kReset : state;
      State_kReset: choice_11 = both_148 ? State_kAccelerate : state;
      State_kAccelerate: choice_11 = below_179 ? choice_10 : State_kPullIn;
      State_kPullIn: choice_11 = both_249 ? State_kRun : choice_10;
      State_kRun: choice_11 =
          lost_i ? (below_107_2 ? State_kRest : State_kFault) :
          either_260 ? State_kSlowDown : state;
      State_kSlowDown: choice_11 =
          lost_i ? choice_9 :
          either_260 ? (both_148 ? choice_6 :
          below_267 ? state : choice_6) : State_kRun;
      default: choice_11 = both_2 ? {1'b0, choice_5} : state;
    endcase
  end

  wire either_153 =  // line 153
      command_run_i || (command_brake_to_stop_i && (either_5 || state == State_kBrake || state ==
      State_kObserve));
  wire [3:0] choice_12 = (brakes == 8'd255) ? Reason_kCannotStop : reason;
  wire both_3 = below_179 && both_148;

  logic [3:0] choice_13;
  always_comb begin
    case (state)
      State_kIdle: choice_13 = Reason_kNone;
      State_kObserve: choice_13 =
          (both && either_215 && brakes == 8'd255) ? Reason_kCannotStop : reason;
      State_kAccelerate: choice_13 = both_3 ? Reason_kNoLock : reason;
      State_kPullIn: choice_13 =
          both_249 ? reason :
          both_148 ? Reason_kNoLock : reason;
      State_kRun: choice_13 = lost_i ? cause_i : reason;
      State_kSlowDown: choice_13 =
          lost_i ? cause_i :
          either_260 ? (both_148 ? choice_12 :
          below_267 ? reason : choice_12) : reason;
      default: choice_13 = reason;
    endcase
  end

  wire [11:0] choice_14 =
      source_i ? 12'd1024 :
      (words_observe_i == 12'd0) ? words_settle_i : words_observe_i;
  wire [11:0] choice_88 = (brakes == 8'd255) ? 12'd0 : words_brake_i;  // line 88
  wire [11:0] choice_88_2 = either_215 ? choice_88 : 12'd1024;  // line 88
  wire both_149 = tick_i && ticks != 12'd0;  // line 149
  wire [11:0] sum_149 = ticks + {{11{both_149}}, both_149};  // line 149
  wire [11:0] choice_15 = below_107 ? words_rest_i : 12'd0;
  wire [11:0] choice_16 = both_148 ? choice_15 : sum_149;

  logic [11:0] choice_17;
  always_comb begin
    case (state)
      State_kIdle: choice_17 = choice_14;
      State_kObserve: choice_17 =
          both ? choice_88_2 :
          both_148 ? (command_run_i ? words_settle_i : 12'd0) :
          both ? choice_88_2 : sum_149;
      State_kBrake: choice_17 = both_148 ? (both_240 ? 12'd0 : choice_14) : sum_149;
      State_kSettle: choice_17 = both_148 ? words_reset_i : sum_149;
      State_kReset: choice_17 = both_148 ? 12'd4095 : sum_149;
      State_kAccelerate: choice_17 = below_179 ? choice_16 : words_pull_in_i;
      State_kPullIn: choice_17 = both_249 ? 12'd1024 : choice_16;
      State_kRun: choice_17 =
          lost_i ? (below_107_2 ? words_rest_i : 12'd0) :
          either_260 ? words_slow_down_i : sum_149;
      State_kSlowDown: choice_17 =
          lost_i ? choice_15 :
          either_260 ? (both_148 ? choice_88 :
          below_267 ? sum_149 : choice_88) : 12'd1024;
      default: choice_17 = both_2 ? choice_14 : sum_149;
    endcase
  end

  wire both_4 = command_configured_i && !fatal_i;
  wire both_5 = both_4 && either_153;

  logic [5:0] choice_18;
  always_comb begin
    case (state)
      State_kObserve: choice_18 =
          (both || both_148) ? 6'd0 :
          update_i ? (both_213 ? 6'd0 : choice_212) : good;
      State_kBrake, State_kSettle, State_kReset, State_kRest: choice_18 = both_148 ? 6'd0 : good;
      State_kAccelerate: choice_18 = (below_179 && !both_148) ? good : 6'd0;
      State_kPullIn: choice_18 = (both_249 || both_148) ? 6'd0 : choice_248;
      State_kRun: choice_18 = (lost_i || either_260) ? 6'd0 : good;
      State_kSlowDown: choice_18 =
          lost_i ? 6'd0 :
          (either_260 && !both_148 && below_267) ? good : 6'd0;
      default: choice_18 = good;
    endcase
  end

  wire [3:0] sum_110 = retries + 4'd1;  // line 110
  wire both_6 = both_148 && below_107;

  logic [3:0] choice_19;
  always_comb begin
    case (state)
      State_kIdle: choice_19 = 4'd0;
      State_kAccelerate: choice_19 = (below_179 && both_6) ? sum_110 : retries;
      State_kPullIn: choice_19 =
          both_249 ? retries :
          both_6 ? sum_110 : retries;
      State_kRun: choice_19 = (lost_i && below_107_2) ? choice_257 + 4'd1 : choice_257;
      default: choice_19 = (state == State_kSlowDown && lost_i && below_107) ? sum_110 : retries;
    endcase
  end

  wire [7:0] choice_20 = (brakes == 8'd255) ? 8'd255 : brakes + 8'd1;
  wire [7:0] choice_21 =
      both_148 ? choice_20 :
      below_267 ? brakes : choice_20;

  logic [7:0] choice_22;
  always_comb begin
    case (state)
      State_kIdle: choice_22 = 8'd0;
      State_kObserve: choice_22 = (both && either_215) ? choice_20 : brakes;
      State_kRun: choice_22 =
          lost_i ? brakes :
          either_260 ? 8'd0 : brakes;
      default: choice_22 = (state == State_kSlowDown && !lost_i && either_260) ? choice_21 : brakes;
    endcase
  end

  wire inverse_174 = !reverse;  // line 174
  wire both_7 = state == State_kReset && both_148;
  wire choice_23 = both ? !either_215 : update_i && both_213 && !either_215;
  wire choice_24 = (state == State_kObserve) ? choice_23 : both_7;
  wire both_8 = command_configured_i && !fatal_i && either_153 && choice_24;
  wire choice_25 =
      (state == State_kAccelerate) ? both_3 :
      (state == State_kPullIn) ? !both_249 && both_148 : either_5 && lost_i;

  always_ff @(posedge clk) begin
    if (rst) begin
      state <= State_kIdle;
      reason <= Reason_kNone;
      ticks <= 12'd0;
      good <= 6'd0;
      retries <= 4'd0;
      brakes <= 8'd0;
      boost <= 16'd0;
      step <= 3'd0;
      load_step <= 1'b0;
      began <= 1'b0;
      failed <= 1'b0;
      reverse <= 1'b0;
      turns_reverse <= 1'b0;
      clear_was <= 1'b0;
    end else begin
      if (state == State_kFault) begin
        if (either_8) begin
          state <= State_kFault;
        end else begin
          state <= State_kIdle;
          ticks <= 12'd0;
          good <= 6'd0;
        end
      end else begin
        if (command_configured_i) begin
          if (fatal_i) begin
            state <= State_kFault;
            reason <= cause_i;
          end else if (either_153) begin
            state <= choice_11;
            reason <= choice_13;
          end else begin
            state <= State_kIdle;
          end
        end else begin
          state <= State_kIdle;
        end
        if (both_5) begin
          ticks <= choice_17;
          retries <= choice_19;
          brakes <= choice_22;
          if (state == State_kObserve) begin
            if (both && !either_215) begin
              if (turns_reverse_i) begin
                step <= sector_i;
              end else if (sector_i == 3'd0) begin
                step <= 3'd5;
              end else begin
                step <= sector_i - 3'd1;
              end
            end
          end else if (both_7) begin
            step <= {1'b0, inverse_174, inverse_174};
          end
          if (state == State_kIdle) begin
            reverse <= command_reverse_i;
          end else if (state == State_kBrake) begin
            if (both_148 && !both_240) begin
              reverse <= command_reverse_i;
            end
          end else if (both_2) begin
            reverse <= command_reverse_i;
          end
        end else begin
          ticks <= 12'd0;
        end
        if (both_4 && either_153 && state != State_kIdle) begin
          good <= choice_18;
        end else begin
          good <= 6'd0;
        end
        if (both_4 && either_153 && state == State_kObserve && update_i) begin
          turns_reverse <= turns_reverse_i;
        end
      end
      if (state == State_kPullIn) begin  // line 119
        boost <= boost - {5'd0, commutate_i ? boost[15:5] : 11'd0};
      end else begin
        boost <= words_start_duty_i;
      end
      load_step <= state != State_kFault && both_8;
      began <=
          state != State_kFault && command_configured_i && !fatal_i && either_153 && state ==
          State_kIdle;
      failed <=
          state != State_kFault && command_configured_i && !fatal_i && either_153 && choice_25;
      clear_was <= command_clear_fault_i;
    end
  end

  assign state_o = state;
  assign reason_o = reason;
  assign enable_o = either_2 || state == State_kSlowDown;
  assign pattern_o = (state == State_kBrake) ? Pattern_kBrake : wide;
  assign reverse_o = reverse;
  assign running_o = either_5;
  assign mode_o = choice_2;
  assign duty_o = out_duty;
  assign target_o = (state == State_kSlowDown) ? words_hand_over_i : target_i;
  assign watch_o = choice_3;
  assign loop_o = choice_4;
  assign load_o = !either_7;
  assign load_frequency_o = either_4 ? 26'd0 : words_hand_over_i;
  assign load_step_o = load_step;
  assign step_o = step;
  assign turn_vco_o = either_7;
  assign began_o = began;
  assign failed_o = failed;

  // What nothing reads, for the linters.
  wire unused = &{1'b0, words_ramp_i, words_window_i};
endmodule
