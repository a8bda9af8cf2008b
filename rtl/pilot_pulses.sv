// pilot_pulses: steplock::PilotPulses, printed by hlsgen from hls/sinusoidal/pilot_pulses.hpp:35.
// Do not edit: change the C++ and print again.

module pilot_pulses (
    input  logic        clk,
    input  logic        rst,  // synchronous, active high
    input  logic        rest_i,  // all from its begin
    input  logic        enable_i,  // pulses are wanted
    input  logic        period_i,  // a PWM period begins
    input  logic        taken_i,  // a sample has been taken
    input  logic        sampled_i,  // it has been worked through
    input  logic        over_i,  // a current in it is beyond its limit: with `waiting`, `decayed`
    input  logic [15:0] i_gamma_i,  // s0.15, of that sample or of `a` and `b`, seen from `angle`
    input  logic        backward_i,  // i_delta of the same is negative
    input  logic [5:0]  words_short_periods_i,  // 0 counts as 1
    input  logic [5:0]  words_long_periods_i,  // 0 counts as 1
    input  logic [4:0]  words_rounds_i,  // of six short pulses; even
    input  logic [14:0] words_decayed_i,  // u0.15: below, a current is gone
    input  logic [14:0] words_saliency_i,  // u0.15: a smaller sum is no position
    input  logic [14:0] words_polarity_i,  // u0.15: a smaller difference of the long peaks is no polarity
    output logic        pulse_o,  // gates are wanted: the legs below chopped, the others low
    output logic        high_u_o,
    output logic        high_v_o,
    output logic        high_w_o,
    output logic        waiting_o,  // gates are off, and the current has to decay
    output logic        search_o,  // `a` and `b` are to be turned by `angle`
    output logic [15:0] a_o,  // s0.15
    output logic [15:0] b_o,  // s0.15
    output logic [23:0] angle_o,  // u0.24
    output logic        found_o,  // it is the rotor's
    output logic [3:0]  failed_o
);
  localparam logic [2:0] Phase_kShort = 3'd0;
  localparam logic [2:0] Phase_kSearch = 3'd1;
  localparam logic [2:0] Phase_kLong = 3'd2;
  localparam logic [2:0] Phase_kJudge = 3'd3;
  localparam logic [2:0] Phase_kFound = 3'd4;
  localparam logic [3:0] SinusoidalReason_kNone = 4'd0;
  localparam logic [3:0] SinusoidalReason_kLostSample = 4'd3;
  localparam logic [3:0] SinusoidalReason_kNoSaliency = 4'd9;
  localparam logic [3:0] SinusoidalReason_kNoPolarity = 4'd10;

  logic [2:0] phase;
  logic [3:0] failed;
  logic [15:0] a;  // s0.15, modulo
  logic [15:0] b;  // s0.15, modulo
  logic [12:0] angle;  // u0.13, half a turn is the polarity
  logic [11:0] step;  // the bit of it in question
  logic [4:0] round;  // of short pulses; of the long ones, the second
  logic [1:0] winding;  // u, v, w
  logic reversed;
  logic [5:0] left;  // periods of the pulse
  logic pulsing;
  logic peak;  // its end's sample is to be taken
  logic due;  // and to be worked through
  logic quiet;  // the last sample showed no current
  logic ready;  // nor did the one before

  wire inverse_66 = !(pulsing || peak || due);  // line 66
  wire [23:0] twice = {angle[11:0], 12'd0};  // line 108
  wire [23:0] out_angle = {angle, 11'd0};  // line 110
  wire [1:0] choice_111 = (phase == Phase_kShort) ? {!round[0], 1'b0} : 2'd1;  // line 111
  wire [1:0] choice_112 = (phase != Phase_kShort || round[0]) ? 2'd2 : 2'd1;  // line 112
  wire equal_112 = winding == choice_112;  // line 112
  wire [15:0] third =  // line 114
      (winding == choice_111) ? 16'd21845 :
      equal_112 ? 16'd43690 :
      16'd0;
  wire [15:0] choice_115 = (reversed ^ (phase != Phase_kShort && round[0])) ? 16'd32768 : 16'd0;
  wire [15:0] differ_115 = third ^ choice_115;  // line 115
  wire [23:0] out_angle_2 = {differ_115, 8'd0};  // line 115

  logic [23:0] out_angle_3;  // line 75
  always_comb begin
    case (phase)
      Phase_kSearch: out_angle_3 = twice;
      Phase_kFound, Phase_kJudge: out_angle_3 = out_angle;
      default: out_angle_3 = out_angle_2;
    endcase
  end

  wire [16:0] sum_180 = {2'd0, words_polarity_i} + {a[15], a};  // line 180

  always_ff @(posedge clk) begin
    if (rest_i) begin
      phase <= Phase_kShort;
      failed <= SinusoidalReason_kNone;
      a <= 16'd0;
      b <= 16'd0;
      angle <= 13'd0;
      step <= 12'd0;
      round <= 5'd0;
      winding <= 2'd0;
      reversed <= 1'b0;
      left <= 6'd0;
      pulsing <= 1'b0;
      peak <= 1'b0;
      due <= 1'b0;
      quiet <= 1'b0;
      ready <= 1'b0;
    end else if (enable_i) begin
      logic [4:0] sum_146;
      logic equal_150;
      logic both_142;
      logic [2:0] choice;
      logic either_182;
      logic both_89;
      logic both_87;
      logic both_84;
      logic [2:0] choice_2;
      logic both_125;
      logic [3:0] choice_3;
      logic both_92;
      logic both;
      logic either_4;
      logic either_5;
      logic both_2;
      logic choice_4;
      sum_146 = round + 5'd1;  // line 146
      equal_150 = sum_146 == words_rounds_i;  // line 150
      both_142 = reversed && winding == 2'd2;  // line 142
      choice =
          (phase == Phase_kShort) ?
          (both_142 ? (equal_150 ? Phase_kSearch : phase) : Phase_kShort) :
          (round == 5'd1) ? Phase_kJudge :
          phase;
      either_182 = $signed({1'b0, words_polarity_i}) < $signed(a) || sum_180[16];  // line 182
      both_89 = phase == Phase_kJudge && ready;  // line 89
      both_87 = sampled_i && phase == Phase_kSearch;  // line 87
      both_84 = sampled_i && due;  // line 84
      choice_2 =
          both_84 ? choice :
          both_87 ? ((step[11:1] == 11'd0) ? Phase_kLong : Phase_kSearch) :
          (both_89 && either_182) ? Phase_kFound :
          phase;
      both_125 = !taken_i && peak;  // line 125
      choice_3 =
          both_84 ? failed :
          both_87 ?
          ((step[11:1] == 11'd0 && $signed(i_gamma_i) < $signed({1'b0, words_saliency_i})) ?
          SinusoidalReason_kNoSaliency : failed) :
          (both_89 && !either_182) ? SinusoidalReason_kNoPolarity :
          failed;
      both_92 = quiet && !over_i;  // line 92
      both = sampled_i && inverse_66;
      either_4 = both_84 || both_87;
      either_5 = both_84 || both_87 || both_89;
      both_2 = sampled_i && !(peak || due);
      choice_4 = either_4 ? ready : both_89 || (both_2 ? both_92 : ready);
      phase <= choice_2;
      if (period_i && both_125) begin
        failed <= SinusoidalReason_kLostSample;
        peak <= 1'b1;
      end else begin
        failed <= choice_3;
        if (period_i && pulsing) begin
          peak <= left[5:1] == 5'd0 || both_125;
        end else begin
          peak <= both_125;
        end
      end
      if (both_84) begin
        logic [15:0] sum;
        sum = a + i_gamma_i;  // line 85
        if (phase == Phase_kShort) begin
          if (both_142) begin
            a <= b;
            b <= sum;
            if (equal_150) begin
              angle <= 13'd2048;
              step <= 12'd2048;
            end
            round <= sum_146;
            winding <= 2'd0;
          end else begin
            a <= sum;
            if (reversed) begin
              if (winding == 2'd2) begin
                winding <= 2'd0;
              end else begin
                winding <= winding + 2'd1;
              end
            end
          end
        end else begin
          a <= sum;
          round <= 5'd1;
        end
        reversed <= !reversed;
      end else begin
        case (phase)
          Phase_kSearch: begin
            if (sampled_i) begin
              logic [12:0] sure;
              logic [12:0] either_160;
              sure = angle ^ {1'b0, backward_i ? step : 12'd0};  // line 159
              either_160 = sure | {2'd0, step[11:1]};  // line 160
              if (step[11:1] == 11'd0) begin
                logic either;
                logic either_2;
                logic either_3;
                either =
                    either_160[11:8] == 4'd15 || either_160[11:8] == 4'd14 ||
                    either_160[11:8] == 4'd13;
                either_2 =
                    either || either_160[11:8] == 4'd12 || either_160[11:8] == 4'd11 ||
                    either_160[11:8] == 4'd10;
                either_3 =
                    either_2 || either_160[11:8] == 4'd9 || either_160[11:8] == 4'd8 ||
                    either_160[11:8] == 4'd2;
                a <= 16'd0;
                round <= 5'd0;
                if (either_160[11:8] + 4'd3 < 4'd6) begin
                  winding <= 2'd0;
                end else begin
                  winding <= either_160[11] ? 2'd1 : 2'd2;
                end
                reversed <=
                    !(either_3 || either_160[11:8] == 4'd1 || either_160[11:8] == 4'd0) ||
                    either_160[11:8] > 4'd12;
              end
              angle <= either_160;
              step <= {1'b0, step[11:1]};
            end
          end
          Phase_kJudge: begin
            if (ready && sum_180[16]) begin
              angle <= {1'b1, angle[11:0]};
            end
          end
          default: ;
        endcase
      end
      if (period_i) begin
        if (pulsing) begin
          if (left[5:1] != 5'd0) begin
            left <= left - 6'd1;
          end
          pulsing <= left[5:1] != 5'd0;
          if (!either_4) begin
            ready <= both_89 || ready;
          end
        end else begin
          if (phase == Phase_kShort) begin
            left <= words_short_periods_i;
          end else begin
            left <= words_long_periods_i;
          end
          pulsing <=
              choice_4 && choice_2 != Phase_kFound &&
              !both_125 && choice_3 == SinusoidalReason_kNone;
          ready <= 1'b0;
        end
      end else if (!either_4) begin
        ready <= both_89 || (both ? both_92 : ready);
      end
      due <= (taken_i && peak) || (!sampled_i && due);
      if (period_i && !pulsing) begin
        logic choice_5;
        choice_5 =
            either_5 ? quiet :
            both_2 ? !over_i :
            quiet;
        quiet <= !choice_4 && choice_5;
      end else if (!either_5 && both) begin
        quiet <= !over_i;
      end
    end
    if (rst) begin
      phase <= Phase_kShort;
      failed <= SinusoidalReason_kNone;
      a <= 16'sd0;
      b <= 16'sd0;
      angle <= 13'd0;
      step <= 12'd0;
      round <= 5'd0;
      winding <= 2'd0;
      reversed <= 1'b0;
      left <= 6'd0;
      pulsing <= 1'b0;
      peak <= 1'b0;
      due <= 1'b0;
      quiet <= 1'b0;
      ready <= 1'b0;
    end
  end

  assign pulse_o = pulsing;
  assign high_u_o = (winding == 2'd0) ^ reversed;
  assign high_v_o = (winding == 2'd1) ^ reversed;
  assign high_w_o = (winding == 2'd2) ^ reversed;
  assign waiting_o = enable_i && inverse_66;
  assign search_o = phase == Phase_kSearch;
  assign a_o = a;
  assign b_o = b;
  assign angle_o = out_angle_3;
  assign found_o = phase == Phase_kFound;
  assign failed_o = failed;

  // What nothing reads, for the linters.
  wire unused = &{1'b0, words_decayed_i, sum_180[15:0]};
endmodule
