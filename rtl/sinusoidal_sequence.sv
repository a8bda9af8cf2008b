// sinusoidal_sequence: steplock::SinusoidalSequence, printed by hlsgen from hls/sinusoidal/sinusoidal_sequence.hpp:26.
// Do not edit: change the C++ and print again.

module sinusoidal_sequence (
    input  logic        clk,
    input  logic        rst,  // synchronous, active high
    input  logic        command_configured_i,  // the words are valid; until then all six gates are off
    input  logic        command_run_i,
    input  logic        command_reverse_i,
    input  logic        command_brake_to_stop_i,  // else coast
    input  logic        command_clear_fault_i,  // a rising edge re-arms, once `run` is low and the cause is gone
    input  logic        fault_pin_i,
    input  logic        period_i,  // a PWM period begins
    input  logic        sampled_i,  // a sample has been worked through
    input  logic        measured_i,  // the converters' offsets stand
    input  logic        fast_i,  // the speed may be trusted
    input  logic        plausible_i,  // the EMF belongs to it
    input  logic        stopping_i,  // slower than the stop speed
    input  logic        found_i,  // the pilot pulses know the angle
    input  logic [3:0]  fatal_i,
    input  logic [3:0]  failed_i,
    input  logic        words_arbitrary_i,  // no pattern before the loop is closed
    input  logic        words_pilot_i,  // pilot pulses instead of the pattern: a salient rotor
    input  logic [14:0] words_hold_voltage_i,  // u0.15, of the pattern's leg, or of a pilot pulse's
    input  logic [19:0] words_pattern_i,  // each of its two halves; all pilot pulses at most
    input  logic [19:0] words_lock_i,  // the estimate has to be trusted for so long
    input  logic [19:0] words_give_up_i,  // no lock in this time is a failed try
    input  logic [19:0] words_brake_i,
    input  logic [19:0] words_rest_i,
    input  logic [3:0]  words_retries_i,
    output logic [3:0]  state_o,
    output logic [3:0]  reason_o,
    output logic        entered_o,  // one clock: the state is new
    output logic        reverse_o,  // the wanted direction
    output logic        calibrate_o,
    output logic        pilot_o,  // pulses are wanted
    output logic        hold_o,  // one leg alone
    output logic        hold_v_o,  // that is v
    output logic        regulate_o,  // the loop is closed
    output logic        estimate_o,  // the estimator has seen a whole period of it
    output logic        modulate_o,  // gates follow the PWM
    output logic        brake_o,  // all low sides on
    output logic        slow_down_o,
    output logic        locked_o,
    output logic [3:0]  tries_o  // that failed and were followed by another one, since `run` was obeyed
);
  localparam logic [3:0] SinusoidalReason_kNone = 4'd0;
  localparam logic [3:0] SinusoidalReason_kFaultPin = 4'd1;
  localparam logic [3:0] SinusoidalReason_kNoLock = 4'd7;
  localparam logic [3:0] SinusoidalReason_kNoDecay = 4'd8;
  localparam logic [3:0] SinusoidalState_kIdle = 4'd0;
  localparam logic [3:0] SinusoidalState_kCalibrate = 4'd1;
  localparam logic [3:0] SinusoidalState_kPilot = 4'd2;
  localparam logic [3:0] SinusoidalState_kPattern = 4'd3;
  localparam logic [3:0] SinusoidalState_kStarting = 4'd4;
  localparam logic [3:0] SinusoidalState_kRun = 4'd5;
  localparam logic [3:0] SinusoidalState_kSlowDown = 4'd6;
  localparam logic [3:0] SinusoidalState_kBrake = 4'd7;
  localparam logic [3:0] SinusoidalState_kRest = 4'd8;
  localparam logic [3:0] SinusoidalState_kFault = 4'd9;

  logic [3:0] state;
  logic [3:0] reason;
  logic [19:0] timer;  // periods left of the state
  logic [19:0] trust;  // periods in which the estimate has still to be trusted
  logic [3:0] tries;  // that failed
  logic [1:0] modulated;  // periods begun under the regulators
  logic regulated;  // their first on-times stand
  logic first_half;  // of the pattern
  logic reverse;
  logic entered;

  wire regulate =
      state == SinusoidalState_kStarting || state == SinusoidalState_kRun ||
      state == SinusoidalState_kSlowDown;
  wire both_132 = command_run_i && command_configured_i;  // line 132
  wire both_169 = timer == 20'd0 && first_half;  // line 169
  wire differ = command_reverse_i ^ reverse;
  wire either_133 = !both_132 || differ;  // line 133
  wire either_93 = state == SinusoidalState_kFault || command_configured_i;  // line 93
  wire either_93_2 = either_93 || state == SinusoidalState_kIdle;  // line 93
  wire both_91 = state != SinusoidalState_kFault && fatal_i != SinusoidalReason_kNone;  // line 91
  wire both_89 = state != SinusoidalState_kFault && fault_pin_i;  // line 89
  wire [19:0] choice_82 = period_i ? ((timer == 20'd0) ? 20'd0 : timer - 20'd1) : timer;  // line 82
  wire [19:0] choice_85 = (sampled_i && !(fast_i && plausible_i)) ? words_lock_i : trust;
  wire [19:0] choice_86 = period_i ? ((choice_85 == 20'd0) ? 20'd0 : choice_85 - 20'd1) : choice_85;
  wire [1:0] sum_83 = modulated + {1'b0, period_i && regulated && modulated != 2'd3};  // line 83
  wire either_84 = (sampled_i && regulate) || regulated;  // line 84
  wire both_5 = command_configured_i && failed_i != SinusoidalReason_kNone;
  wire either_133_2 = !command_run_i || differ;  // line 133

  always_ff @(posedge clk) begin
    if (both_89 || both_91) begin
      state <= SinusoidalState_kFault;
      timer <= choice_82;
      trust <= choice_86;
      modulated <= sum_83;
      regulated <= either_84;
    end else if (either_93_2) begin
      logic below_116;
      logic both;
      logic both_3;
      logic both_4;
      below_116 = tries < words_retries_i;  // line 116
      both = timer == 20'd0 && !first_half;
      both_3 = both_132 && measured_i && words_arbitrary_i;
      both_4 = both_132 && failed_i == SinusoidalReason_kNone && found_i;
      if (state == SinusoidalState_kIdle) begin
        if (both_132) begin
          state <= SinusoidalState_kCalibrate;
        end
      end else if (either_93) begin
        if (state == SinusoidalState_kCalibrate) begin
          if (both_132) begin
            if (measured_i) begin
              state <=
                  words_arbitrary_i ? SinusoidalState_kStarting :
                  words_pilot_i ? SinusoidalState_kPilot :
                  SinusoidalState_kPattern;
            end
          end else begin
            state <= SinusoidalState_kIdle;
          end
        end else begin
          logic [3:0] choice_164;
          logic [3:0] choice;
          choice_164 = below_116 ? SinusoidalState_kRest : SinusoidalState_kFault;  // line 164
          choice = (timer == 20'd0) ? choice_164 : state;
          if (state == SinusoidalState_kPilot) begin
            if (both_132) begin
              state <=
                  (failed_i == SinusoidalReason_kNone) ?
                  (found_i ? SinusoidalState_kStarting : choice) : choice_164;
            end else begin
              state <= SinusoidalState_kIdle;
            end
          end else if (state == SinusoidalState_kPattern) begin
            state <= both_132 ? (both ? SinusoidalState_kStarting : state) : SinusoidalState_kIdle;
          end else begin
            logic [3:0] choice_2;
            logic [3:0] choice_3;
            choice_2 =
                either_133 ?
                ((both_132 || command_brake_to_stop_i) ? SinusoidalState_kSlowDown :
                SinusoidalState_kIdle) : state;
            case (state)
              SinusoidalState_kStarting: choice_3 =
                  either_133 ? SinusoidalState_kBrake :
                  (failed_i == SinusoidalReason_kNone) ?
                  ((trust == 20'd0) ? SinusoidalState_kRun : choice) :
                  choice_164;
              SinusoidalState_kRun: choice_3 =
                  (failed_i == SinusoidalReason_kNone) ? choice_2 : choice_164;
              SinusoidalState_kSlowDown: choice_3 =
                  either_133 ? (stopping_i ? SinusoidalState_kBrake : state) : SinusoidalState_kRun;
              SinusoidalState_kBrake: choice_3 = (timer == 20'd0) ? SinusoidalState_kIdle : state;
              SinusoidalState_kRest: choice_3 =
                  both_132 ? ((timer == 20'd0) ? SinusoidalState_kCalibrate : state) :
                  SinusoidalState_kIdle;
              default: choice_3 =
                  (state == SinusoidalState_kFault &&
                  command_clear_fault_i && !(command_run_i || fault_pin_i)) ?
                  SinusoidalState_kIdle : state;
            endcase
            state <= choice_3;
          end
        end
      end else begin
        state <= SinusoidalState_kIdle;
      end
      if (state == SinusoidalState_kCalibrate) begin
        if (both_3) begin
          timer <= words_give_up_i;
          trust <= words_lock_i;
        end else begin
          if (both_132 && measured_i) begin
            if (words_arbitrary_i) begin
              timer <= words_give_up_i;
            end else begin
              timer <= words_pattern_i;
            end
          end else begin
            timer <= choice_82;
          end
          trust <= choice_86;
        end
      end else begin
        logic [19:0] choice_4;
        choice_4 = (timer == 20'd0) ? words_rest_i : choice_82;
        if (state == SinusoidalState_kPilot) begin
          if (both_4) begin
            timer <= words_give_up_i;
            trust <= words_lock_i;
          end else begin
            if (both_132) begin
              if (failed_i == SinusoidalReason_kNone) begin
                timer <= found_i ? words_give_up_i : choice_4;
              end else begin
                timer <= words_rest_i;
              end
            end else begin
              timer <= choice_82;
            end
            trust <= choice_86;
          end
        end else begin
          logic both_2;
          both_2 = both_132 && timer == 20'd0;
          if (state == SinusoidalState_kPattern && both_2 && !first_half) begin
            timer <= words_give_up_i;
            trust <= words_lock_i;
          end else begin
            if (state == SinusoidalState_kPattern) begin
              if (both_2) begin
                timer <= first_half ? words_pattern_i : words_give_up_i;
              end else begin
                timer <= choice_82;
              end
            end else if (state == SinusoidalState_kStarting) begin
              timer <=
                  either_133 ? words_brake_i :
                  (failed_i == SinusoidalReason_kNone) ?
                  ((trust == 20'd0) ? choice_82 : choice_4) :
                  words_rest_i;
            end else begin
              timer <=
                  (state == SinusoidalState_kRun) ?
                  ((failed_i == SinusoidalReason_kNone) ? choice_82 : words_rest_i) :
                  (state == SinusoidalState_kSlowDown && either_133 && stopping_i) ?
                  words_brake_i :
                  choice_82;
            end
            trust <= choice_86;
          end
        end
      end
      case (state)
        SinusoidalState_kIdle: begin
          if (both_132) begin
            tries <= 4'd0;
            reverse <= command_reverse_i;
          end
          modulated <= sum_83;
        end
        SinusoidalState_kCalibrate: begin
          if (both_3) begin
            modulated <= 2'd0;
            regulated <= 1'b0;
          end else begin
            modulated <= sum_83;
            if (measured_i) begin
              if (both_132) begin
                regulated <= !words_arbitrary_i && regulated;
              end
              first_half <= (both_132 && !words_arbitrary_i) || first_half;
            end
          end
        end
        SinusoidalState_kPilot, SinusoidalState_kStarting, SinusoidalState_kRun,
        SinusoidalState_kSlowDown: begin
          logic [3:0] sum_119;
          logic [3:0] choice_5;
          logic either_84_2;
          sum_119 = tries + {3'd0, below_116};  // line 119
          choice_5 = (timer == 20'd0) ? sum_119 : tries;
          either_84_2 = sampled_i || regulated;  // line 84
          case (state)
            SinusoidalState_kPilot: begin
              if (both_4) begin
                modulated <= 2'd0;
                regulated <= 1'b0;
              end else begin
                if (both_132) begin
                  if (failed_i == SinusoidalReason_kNone) begin
                    if (!found_i) begin
                      tries <= choice_5;
                    end
                    regulated <= !found_i && regulated;
                  end else begin
                    tries <= sum_119;
                  end
                end
                modulated <= sum_83;
              end
            end
            SinusoidalState_kStarting: begin
              if (command_configured_i && !either_133_2) begin
                if (failed_i == SinusoidalReason_kNone) begin
                  if (trust != 20'd0) begin
                    tries <= choice_5;
                  end
                end else begin
                  tries <= sum_119;
                end
              end
              modulated <= sum_83;
              regulated <= either_84_2;
            end
            SinusoidalState_kRun: begin
              if (both_5) begin
                tries <= sum_119;
              end
              modulated <= sum_83;
              regulated <= either_84_2;
            end
            default: begin  // SinusoidalState_kSlowDown
              modulated <= sum_83;
              regulated <= either_84_2;
            end
          endcase
        end
        SinusoidalState_kPattern: begin
          if (both_132) begin
            if (both) begin
              modulated <= 2'd0;
            end else begin
              modulated <= sum_83;
            end
            if (!both_169) begin
              regulated <= timer != 20'd0 && regulated;
            end
            first_half <= !both_169 && first_half;
          end else begin
            modulated <= sum_83;
          end
        end
        default: modulated <= sum_83;
      endcase
    end else begin
      state <= SinusoidalState_kIdle;
      timer <= choice_82;
      trust <= choice_86;
      modulated <= sum_83;
      regulated <= either_84;
    end
    if (both_89) begin
      reason <= SinusoidalReason_kFaultPin;
      entered <= 1'b1;
    end else if (both_91) begin
      reason <= fatal_i;
      entered <= 1'b1;
    end else begin
      logic choice_6;
      case (state)
        SinusoidalState_kIdle: choice_6 = both_132;
        SinusoidalState_kCalibrate: choice_6 = !both_132 || measured_i;
        SinusoidalState_kPilot: choice_6 =
            !both_132 || failed_i != SinusoidalReason_kNone || found_i || timer == 20'd0;
        SinusoidalState_kPattern: choice_6 = !both_132 || (!both_169 && timer == 20'd0);
        SinusoidalState_kStarting: choice_6 =
            either_133 || failed_i != SinusoidalReason_kNone || trust == 20'd0 || timer == 20'd0;
        SinusoidalState_kRun: choice_6 = failed_i != SinusoidalReason_kNone || either_133;
        SinusoidalState_kSlowDown: choice_6 = !either_133 || stopping_i;
        SinusoidalState_kBrake: choice_6 = timer == 20'd0;
        SinusoidalState_kRest: choice_6 = !both_132 || timer == 20'd0;
        default: choice_6 =
            state == SinusoidalState_kFault &&
            command_clear_fault_i && !command_run_i && !fault_pin_i;
      endcase
      if (state == SinusoidalState_kIdle) begin
        if (both_132) begin
          reason <= SinusoidalReason_kNone;
        end
      end else begin
        case (state)
          SinusoidalState_kPilot: begin
            if (command_configured_i && both_132) begin
              if (failed_i == SinusoidalReason_kNone) begin
                if (!found_i) begin
                  reason <= (timer == 20'd0) ? SinusoidalReason_kNoDecay : reason;
                end
              end else begin
                reason <= failed_i;
              end
            end
          end
          SinusoidalState_kStarting: begin
            if (command_configured_i && !either_133_2) begin
              if (failed_i == SinusoidalReason_kNone) begin
                reason <=
                    (trust == 20'd0) ? reason :
                    (timer == 20'd0) ? SinusoidalReason_kNoLock :
                    reason;
              end else begin
                reason <= failed_i;
              end
            end
          end
          SinusoidalState_kRun: begin
            if (both_5) begin
              reason <= failed_i;
            end
          end
          default: ;
        endcase
      end
      entered <= !either_93_2 || choice_6;
    end
    if (rst) begin
      state <= SinusoidalState_kIdle;
      reason <= SinusoidalReason_kNone;
      timer <= 20'd0;
      trust <= 20'd0;
      tries <= 4'd0;
      modulated <= 2'd0;
      regulated <= 1'b0;
      first_half <= 1'b0;
      reverse <= 1'b0;
      entered <= 1'b0;
    end
  end

  assign state_o = state;
  assign reason_o = reason;
  assign entered_o = entered;
  assign reverse_o = reverse;
  assign calibrate_o = state == SinusoidalState_kCalibrate;
  assign pilot_o = state == SinusoidalState_kPilot;
  assign hold_o = state == SinusoidalState_kPattern;
  assign hold_v_o = first_half;
  assign regulate_o = regulate;
  assign estimate_o = regulate && modulated[1];
  assign modulate_o = state == SinusoidalState_kPattern || (regulate && modulated != 2'd0);
  assign brake_o = state == SinusoidalState_kBrake;
  assign slow_down_o = state == SinusoidalState_kSlowDown;
  assign locked_o = regulate && state != SinusoidalState_kStarting;
  assign tries_o = tries;

  // What nothing reads, for the linters.
  wire unused = &{1'b0, words_hold_voltage_i};
endmodule
