// start_sequence: steplock::StartSequence, printed by hlsgen from hls/six_step/start_sequence.hpp:37.
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
    output logic [2:0]  pattern_o,
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
  localparam logic [2:0] Pattern_kOff = 3'd0;
  localparam logic [2:0] Pattern_kDrive = 3'd1;
  localparam logic [2:0] Pattern_kSettle = 3'd2;
  localparam logic [2:0] Pattern_kReset = 3'd3;
  localparam logic [2:0] Pattern_kBrake = 3'd4;
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

  logic [3:0] state;
  logic [3:0] reason;
  logic [14:0] ticks;  // left in this state
  logic [5:0] good;  // good crossings in a row
  logic fresh;  // good_ was counted in the last clock
  logic [3:0] retries;  // failed tries
  logic [7:0] brakes;  // braking intervals of this stop
  logic [15:0] boost;  // u1.15, duty above the back-EMF's while pulling in
  logic load_step;
  logic began;
  logic failed;
  logic reverse;  // direction of this try
  logic turns_reverse;  // direction at the last update while observing
  logic clear_was;

  wire either = state == State_kBrake || state == State_kSettle || state == State_kReset;
  wire either_2 =
      either || state == State_kAccelerate || state == State_kPullIn || state == State_kRun;

  logic [2:0] pattern;
  always_comb begin
    case (state)
      State_kBrake: pattern = Pattern_kBrake;
      State_kSettle: pattern = Pattern_kSettle;
      State_kReset: pattern = Pattern_kReset;
      State_kAccelerate, State_kPullIn, State_kRun, State_kSlowDown: pattern = Pattern_kDrive;
      default: pattern = Pattern_kOff;
    endcase
  end

  wire running = state == State_kRun || state == State_kSlowDown;
  wire either_3 = state == State_kObserve || state == State_kAccelerate || state == State_kPullIn;

  logic [1:0] mode;
  always_comb begin
    case (state)
      State_kObserve, State_kAccelerate, State_kPullIn: mode = SpeedMode_kAboveBemf;
      State_kRun, State_kSlowDown: mode = SpeedMode_kControl;
      default: mode = SpeedMode_kFixed;
    endcase
  end

  wire [15:0] choice_77 =  // line 77
      (retries[3:1] == 3'd0) ? words_reset_duty_i :
      words_reset_duty_i[15] ? 16'd65535 :
      {words_reset_duty_i[14:0], 1'b0};

  logic [15:0] out_duty;  // line 77
  always_comb begin
    case (state)
      State_kBrake: out_duty = words_brake_duty_i;
      State_kSettle, State_kReset: out_duty = choice_77;
      State_kAccelerate, State_kPullIn: out_duty = boost;
      default: out_duty = 16'd0;
    endcase
  end

  logic [1:0] watch;
  logic [2:0] loop;
  always_comb begin
    case (state)
      State_kObserve: begin
        watch = Evidence_kSectors;
        loop = Loop_kCatch;
      end
      State_kPullIn: begin
        watch = Evidence_kCrossings;
        loop = Loop_kTrack;
      end
      State_kAccelerate: begin
        watch = Evidence_kNothing;
        loop = Loop_kRamp;
      end
      State_kRun, State_kSlowDown: begin
        watch = source_i ? Evidence_kSectors : Evidence_kCrossings;
        loop = source_i ? Loop_kHall : Loop_kTrack;
      end
      default: begin
        watch = Evidence_kNothing;
        loop = Loop_kStop;
      end
    endcase
  end

  wire inverse_286 = !reverse;  // line 286
  wire [1:0] gentle = (retries[3:2] == 2'd0) ? retries[1:0] : 2'd3;  // line 243
  wire both_78 = tick_i && ticks == 15'd0;  // line 78
  wire both_124 = fresh && words_good_crossings_i <= good;  // line 124
  wire either_125 = !command_run_i || (command_reverse_i ^ reverse);  // line 125
  wire [3:0] choice_79 =  // line 79
      (command_run_i || (!source_i && words_observe_i != 12'd0)) ? State_kObserve : State_kIdle;
  wire [3:0] choice_79_2 =  // line 79
      both_124 ? ((!command_run_i || (turns_reverse ^ reverse)) ? State_kBrake : State_kRun) :
      both_78 ? {2'd0, {2{command_run_i}}} :
      State_kObserve;

  logic [3:0] choice_79_3;  // line 79
  always_comb begin
    case (state)
      State_kIdle: choice_79_3 = State_kObserve;
      State_kObserve: choice_79_3 = choice_79_2;
      State_kBrake: choice_79_3 = both_78 ? choice_79 : State_kBrake;
      State_kSettle: choice_79_3 = both_78 ? State_kReset : State_kSettle;
      State_kReset: choice_79_3 = both_78 ? State_kAccelerate : State_kReset;
      State_kAccelerate: choice_79_3 =
          fast_i ? State_kPullIn :
          both_78 ? State_kRest :
          State_kAccelerate;
      State_kPullIn: choice_79_3 =
          both_124 ? State_kRun :
          both_78 ? State_kRest :
          State_kPullIn;
      State_kRun: choice_79_3 =
          lost_i ? State_kRest :
          either_125 ? State_kSlowDown :
          State_kRun;
      State_kSlowDown: choice_79_3 =
          lost_i ? State_kRest :
          either_125 ? ((both_78 || !fast_i) ? State_kBrake : State_kSlowDown) :
          State_kRun;
      default: choice_79_3 = both_78 ? State_kObserve : state;
    endcase
  end

  wire either_122 =  // line 122
      command_run_i ||
      (command_brake_to_stop_i && (running || state == State_kBrake || state == State_kObserve));
  wire [3:0] wanted =  // line 79
      (state == State_kFault) ?
      ((command_clear_fault_i && !clear_was && !(command_run_i || fatal_i)) ? State_kIdle :
      State_kFault) :
      (!command_configured_i || fatal_i) ? (command_configured_i ? State_kFault : State_kIdle) :
      either_122 ? choice_79_3 :
      State_kIdle;

  logic [3:0] choice_81;  // line 81
  always_comb begin
    case (wanted)
      State_kObserve: choice_81 =
          source_i ? State_kRun :
          (words_observe_i == 12'd0) ? State_kSettle :
          State_kObserve;
      State_kBrake: choice_81 = (brakes == 8'd255) ? State_kFault : State_kBrake;
      State_kRest: choice_81 = (retries < words_retries_i) ? State_kRest : State_kFault;
      default: choice_81 = wanted;
    endcase
  end

  wire unequal_80 = wanted != state;  // line 80
  wire equal_81 = wanted == state;  // line 81
  wire [3:0] state_next = equal_81 ? state : choice_81;  // line 81
  wire both_83 = unequal_80 && state == State_kIdle;  // line 83
  wire [15:0] choice_228 =  // line 228
      (retries[3:1] == 3'd0) ? words_start_duty_i :
      words_start_duty_i[15] ? 16'd65535 :
      {words_start_duty_i[14:0], 1'b0};

  always_ff @(posedge clk) begin
    state <= state_next;  // line 81
    if (both_83 && wanted == State_kObserve) begin
      reason <= Reason_kNone;
    end else if (!equal_81 && (state_next == State_kRest || state_next == State_kFault)) begin
      if (wanted == State_kBrake) begin
        reason <= Reason_kCannotStop;
      end else if (fatal_i || lost_i) begin
        reason <= cause_i;
      end else begin
        reason <= Reason_kNoLock;
      end
    end
    if (equal_81) begin
      if (!(!tick_i || ticks == 15'd0)) begin
        ticks <= ticks - 15'd1;
      end
    end else begin
      case (state_next)
        State_kObserve: ticks <= {3'd0, words_observe_i};
        State_kBrake: ticks <= {3'd0, words_brake_i};
        State_kSettle, State_kReset: begin
          logic [11:0] ticks_2;
          logic [14:0] once;
          ticks_2 = (state_next == State_kSettle) ? words_settle_i : words_reset_i;  // line 181
          once = {3'd0, ticks_2} << gentle[0];  // line 171
          if (gentle[1]) begin
            ticks <= {once[12:0], 2'd0};
          end else begin
            ticks <= once;
          end
        end
        State_kPullIn: ticks <= {3'd0, words_pull_in_i};
        State_kRun: ticks <= 15'd1024;
        State_kSlowDown: ticks <= {3'd0, words_slow_down_i};
        State_kRest: ticks <= {3'd0, words_rest_i};
        default: begin
          case (retries)
            4'd0: ticks <= 15'd4095;
            4'd1: ticks <= 15'd8190;
            4'd2: ticks <= 15'd16380;
            default: ticks <= 15'd32760;
          endcase
        end
      endcase
    end
    if (unequal_80 || !update_i) begin
      if (!equal_81) begin
        good <= 6'd0;
      end
      if (unequal_80) begin
        load_step <=
            state_next == State_kAccelerate ||
            (state == State_kObserve && state_next == State_kRun);
        if (wanted == State_kObserve) begin
          reverse <= command_reverse_i;
        end
      end else begin
        load_step <= 1'b0;
      end
    end else begin
      if (!good_i || (state == State_kObserve && (turns_reverse_i ^ turns_reverse))) begin
        good <= 6'd0;
      end else begin
        good <= good + 6'd1;
      end
      load_step <= 1'b0;
      turns_reverse <= turns_reverse_i;
    end
    fresh <= update_i;
    if (both_78 && state == State_kRun) begin
      retries <= 4'd0;
      brakes <= 8'd0;
      began <= 1'b0;
    end else begin
      case (wanted)
        State_kObserve: begin
          if (both_83) begin
            retries <= 4'd0;
          end
        end
        State_kRest: begin
          if (unequal_80) begin
            retries <= retries + 4'd1;
          end
        end
        default: ;
      endcase
      if (state == State_kRun) begin
        brakes <= 8'd0;
        began <= 1'b0;
      end else begin
        case (wanted)
          State_kObserve: begin
            if (state == State_kIdle) begin
              if (unequal_80) begin
                brakes <= 8'd0;
              end
              began <= unequal_80;
            end else begin
              began <= 1'b0;
            end
          end
          State_kBrake: begin
            if (unequal_80) begin
              brakes <= brakes + 8'd1;
            end
            began <= 1'b0;
          end
          default: began <= 1'b0;
        endcase
      end
    end
    if (state == State_kPullIn) begin
      if (commutate_i) begin
        if (lags_i) begin
          logic [10:0] choice_221;
          choice_221 = (boost < choice_228) ? boost[15:5] : 11'd0;  // line 221
          boost <= boost + {5'd0, choice_221};
        end else begin
          boost <= boost - {5'd0, boost[15:5]};
        end
      end
    end else begin
      boost <= choice_228;
    end
    failed <= unequal_80 && wanted == State_kRest;  // line 84
    clear_was <= command_clear_fault_i;  // line 79
    if (rst) begin
      state <= State_kIdle;
      reason <= Reason_kNone;
      ticks <= 15'd0;
      good <= 6'd0;
      fresh <= 1'b0;
      retries <= 4'd0;
      brakes <= 8'd0;
      boost <= 16'd0;
      load_step <= 1'b0;
      began <= 1'b0;
      failed <= 1'b0;
      reverse <= 1'b0;
      turns_reverse <= 1'b0;
      clear_was <= 1'b0;
    end
  end

  assign state_o = state;
  assign reason_o = reason;
  assign enable_o = either_2 || state == State_kSlowDown;
  assign pattern_o = pattern;
  assign reverse_o = reverse;
  assign running_o = running;
  assign mode_o = mode;
  assign duty_o = out_duty;
  assign stop_o = state == State_kSlowDown;
  assign watch_o = watch;
  assign loop_o = loop;
  assign load_step_o = load_step;
  assign step_o =
      (state == State_kAccelerate) ? {1'b0, {2{inverse_286}}} :
      reverse ? sector_i :
      (sector_i == 3'd0) ? 3'd5 :
      sector_i - 3'd1;
  assign turn_vco_o = either_3 || state == State_kRun || state == State_kSlowDown;
  assign gentle_o = gentle;
  assign began_o = began;
  assign failed_o = failed;

  // What nothing reads, for the linters.
  wire unused = &{1'b0, words_ramp_i, words_hand_over_i, words_window_i};
endmodule
