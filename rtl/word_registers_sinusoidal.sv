// word_registers_sinusoidal: steplock::WordRegisters<steplock::Sinusoidal>, printed by hlsgen from hls/bus/word_registers.hpp:73.
// Do not edit: change the C++ and print again.

module word_registers_sinusoidal (
    input  logic        clk,
    input  logic        rst,  // synchronous, active high
    input  logic        request_write_i,
    input  logic        request_read_i,
    input  logic [9:0]  request_index_i,
    input  logic [31:0] request_data_i,
    input  logic [3:0]  request_strobes_i,  // bytes of `data` that count
    input  logic        stopped_i,  // stopped and keyed words may change
    input  logic        boundary_i,  // strobe: shadowed words are taken over
    output logic [13:0] words_bridge_period_o,  // clocks; 478 at least, a sample's
    output logic [13:0] words_bridge_minimum_o,  // clocks; shorter on or off times become 0 % or 100 %
    output logic [7:0]  words_bridge_dead_time_o,  // clocks; the guard's floor wins
    output logic [11:0] words_bridge_lost_o,  // u8.4 clocks that a leg loses by it, with its diode's drop
    output logic        words_bridge_compensate_o,  // the on-times make up for it
    output logic        words_bridge_sine_o,  // no zero component
    output logic [14:0] words_bridge_inverse_o,  // u0.25: 1 / (3 period)
    output logic        words_estimator_voltage_o,  // the voltage model's estimate, else the current model's
    output logic        words_estimator_average_o,  // voltage model: the mean of 8 samples
    output logic [14:0] words_estimator_decay_o,  // u0.15, per sample
    output logic [14:0] words_estimator_gain_o,  // u2.13, current per voltage
    output logic [14:0] words_estimator_k_theta_o,  // u1.14, turns per current; K_SP L of the voltage model is the same
    output logic [14:0] words_estimator_k_e_o,  // u2.13, voltage per current
    output logic [14:0] words_estimator_k_speed_o,  // u-2.17, turns per voltage
    output logic [14:0] words_estimator_k_emf_o,  // u0.15, turns per current
    output logic [14:0] words_estimator_k_si_o,  // u-8.23, turns per current
    output logic [24:0] words_speed_target_o,  // u0.25
    output logic [14:0] words_speed_slew_o,  // u0.25, per sample
    output logic [14:0] words_speed_filter_o,  // u0.15, per sample
    output logic [14:0] words_speed_k_p_o,  // u7.8
    output logic [14:0] words_speed_k_i_o,  // u-2.17, per sample
    output logic [14:0] words_speed_limit_o,  // u0.15, of the current
    output logic [14:0] words_speed_lock_o,  // u0.15: above, the estimate may be trusted
    output logic [14:0] words_speed_slow_o,  // u0.15: below, it may not
    output logic [14:0] words_speed_stop_o,  // u0.15: below, the drive lets go
    output logic [14:0] words_speed_emf_low_o,  // u2.13
    output logic [14:0] words_speed_emf_high_o,  // u2.13
    output logic [15:0] words_control_set_gamma_o,  // s0.15
    output logic [14:0] words_control_k_p_o,  // u3.12
    output logic [14:0] words_control_k_i_o,  // u0.15, per sample
    output logic [14:0] words_control_inductance_o,  // u5.10, voltage per current and speed
    output logic [14:0] words_control_emf_o,  // u5.10, voltage per speed
    output logic [14:0] words_control_limit_o,  // u0.15, of the dc voltage
    output logic        words_sequence_arbitrary_o,  // no pattern before the loop is closed
    output logic        words_sequence_pilot_o,  // pilot pulses instead of the pattern: a salient rotor
    output logic [14:0] words_sequence_hold_voltage_o,  // u0.15, of the pattern's leg, or of a pilot pulse's
    output logic [19:0] words_sequence_pattern_o,  // each of its two halves; all pilot pulses at most
    output logic [19:0] words_sequence_lock_o,  // the estimate has to be trusted for so long
    output logic [19:0] words_sequence_give_up_o,  // no lock in this time is a failed try
    output logic [19:0] words_sequence_brake_o,
    output logic [19:0] words_sequence_rest_o,
    output logic [3:0]  words_sequence_retries_o,
    output logic [5:0]  words_pilot_short_periods_o,  // 0 counts as 1
    output logic [5:0]  words_pilot_long_periods_o,  // 0 counts as 1
    output logic [4:0]  words_pilot_rounds_o,  // of six short pulses; even
    output logic [14:0] words_pilot_decayed_o,  // u0.15: below, a current is gone
    output logic [14:0] words_pilot_saliency_o,  // u0.15: a smaller sum is no position
    output logic [14:0] words_pilot_polarity_o,  // u0.15: a smaller difference of the long peaks is no polarity
    output logic [14:0] words_fault_over_current_o,  // u0.15, any phase
    output logic [19:0] words_fault_saturated_o,  // a regulator at its limit for more than this; 0: no test
    output logic [19:0] words_fault_slow_o,  // slow for more than this longer than not; 0: no test
    output logic [19:0] words_fault_emf_o,  // an EMF that does not belong to the speed for more; 0: no test
    output logic [3:0]  words_fault_lost_samples_o,  // in a row; 0: no test
    output logic [31:0] data_o,  // answer to the last read: 0 if it was of no register kept here
    output logic        hole_o,  // no register stands there
    output logic        refused_o,  // the map does not allow this write
    output logic        unlocked_o,  // the lock is open
    output logic        no_period_o  // with this PWM period the bridge has to stay off
);
  logic [13:0] words_bridge_period;  // clocks; 478 at least, a sample's
  logic [13:0] words_bridge_minimum;  // clocks; shorter on or off times become 0 % or 100 %
  logic [7:0] words_bridge_dead_time;  // clocks; the guard's floor wins
  logic [11:0] words_bridge_lost;  // u8.4 clocks that a leg loses by it, with its diode's drop
  logic words_bridge_compensate;  // the on-times make up for it
  logic words_bridge_sine;  // no zero component
  logic [14:0] words_bridge_inverse;  // u0.25: 1 / (3 period)
  logic words_estimator_voltage;  // the voltage model's estimate, else the current model's
  logic words_estimator_average;  // voltage model: the mean of 8 samples
  logic [14:0] words_estimator_decay;  // u0.15, per sample
  logic [14:0] words_estimator_gain;  // u2.13, current per voltage
  logic [14:0] words_estimator_k_theta;  // u1.14, turns per current; K_SP L of the voltage model is the same
  logic [14:0] words_estimator_k_e;  // u2.13, voltage per current
  logic [14:0] words_estimator_k_speed;  // u-2.17, turns per voltage
  logic [14:0] words_estimator_k_emf;  // u0.15, turns per current
  logic [14:0] words_estimator_k_si;  // u-8.23, turns per current
  logic [24:0] words_speed_target;  // u0.25
  logic [14:0] words_speed_slew;  // u0.25, per sample
  logic [14:0] words_speed_filter;  // u0.15, per sample
  logic [14:0] words_speed_k_p;  // u7.8
  logic [14:0] words_speed_k_i;  // u-2.17, per sample
  logic [14:0] words_speed_limit;  // u0.15, of the current
  logic [14:0] words_speed_lock;  // u0.15: above, the estimate may be trusted
  logic [14:0] words_speed_slow;  // u0.15: below, it may not
  logic [14:0] words_speed_stop;  // u0.15: below, the drive lets go
  logic [14:0] words_speed_emf_low;  // u2.13
  logic [14:0] words_speed_emf_high;  // u2.13
  logic [15:0] words_control_set_gamma;  // s0.15
  logic [14:0] words_control_k_p;  // u3.12
  logic [14:0] words_control_k_i;  // u0.15, per sample
  logic [14:0] words_control_inductance;  // u5.10, voltage per current and speed
  logic [14:0] words_control_emf;  // u5.10, voltage per speed
  logic [14:0] words_control_limit;  // u0.15, of the dc voltage
  logic words_sequence_arbitrary;  // no pattern before the loop is closed
  logic words_sequence_pilot;  // pilot pulses instead of the pattern: a salient rotor
  logic [14:0] words_sequence_hold_voltage;  // u0.15, of the pattern's leg, or of a pilot pulse's
  logic [19:0] words_sequence_pattern;  // each of its two halves; all pilot pulses at most
  logic [19:0] words_sequence_lock;  // the estimate has to be trusted for so long
  logic [19:0] words_sequence_give_up;  // no lock in this time is a failed try
  logic [19:0] words_sequence_brake;
  logic [19:0] words_sequence_rest;
  logic [3:0] words_sequence_retries;
  logic [5:0] words_pilot_short_periods;  // 0 counts as 1
  logic [5:0] words_pilot_long_periods;  // 0 counts as 1
  logic [4:0] words_pilot_rounds;  // of six short pulses; even
  logic [14:0] words_pilot_decayed;  // u0.15: below, a current is gone
  logic [14:0] words_pilot_saliency;  // u0.15: a smaller sum is no position
  logic [14:0] words_pilot_polarity;  // u0.15: a smaller difference of the long peaks is no polarity
  logic [14:0] words_fault_over_current;  // u0.15, any phase
  logic [19:0] words_fault_saturated;  // a regulator at its limit for more than this; 0: no test
  logic [19:0] words_fault_slow;  // slow for more than this longer than not; 0: no test
  logic [19:0] words_fault_emf;  // an EMF that does not belong to the speed for more; 0: no test
  logic [3:0] words_fault_lost_samples;  // in a row; 0: no test
  logic [24:0] staged_speed_target;  // u0.25
  logic unlocked;
  logic written_0;  // since the reset
  logic written_1;  // since the reset
  logic written_2;  // since the reset
  logic written_3;  // since the reset
  logic written_4;  // since the reset
  logic written_5;  // since the reset
  logic written_6;  // since the reset
  logic written_7;  // since the reset
  logic written_8;  // since the reset
  logic written_9;  // since the reset
  logic written_10;  // since the reset
  logic written_11;  // since the reset
  logic written_12;  // since the reset
  logic written_13;  // since the reset
  logic written_14;  // since the reset
  logic written_15;  // since the reset
  logic written_16;  // since the reset
  logic written_17;  // since the reset
  logic written_18;  // since the reset
  logic written_19;  // since the reset
  logic written_20;  // since the reset
  logic written_21;  // since the reset
  logic written_22;  // since the reset
  logic written_23;  // since the reset
  logic written_24;  // since the reset
  logic written_25;  // since the reset
  logic written_26;  // since the reset
  logic written_27;  // since the reset
  logic written_28;  // since the reset
  logic written_29;  // since the reset
  logic shows;  // the last read was of the map

  wire [5:0] part_195 = request_index_i[5:0];  // line 195
  wire [4:0] part_189 = request_index_i[4:0];  // line 189
  wire choice_189 =  // line 189
      request_index_i[2] ?
      (request_index_i[1] ? (request_index_i[0] ? written_15 : written_14) :
      request_index_i[0] ? written_13 :
      written_12) :
      request_index_i[1] ? (request_index_i[0] ? written_11 : written_10) :
      request_index_i[0] ? written_9 :
      written_8;
  wire choice_189_2 =  // line 189
      request_index_i[3] ? choice_189 :
      request_index_i[2] ?
      (request_index_i[1] ? (request_index_i[0] ? written_7 : written_6) :
      request_index_i[0] ? written_5 :
      written_4) :
      request_index_i[1] ? (request_index_i[0] ? written_3 : written_2) :
      request_index_i[0] ? written_1 :
      written_0;
  wire choice_189_3 =  // line 189
      request_index_i[2] ?
      (request_index_i[1] ? (request_index_i[0] ? written_23 : written_22) :
      request_index_i[0] ? written_21 :
      written_20) :
      request_index_i[1] ? (request_index_i[0] ? written_19 : written_18) :
      request_index_i[0] ? written_17 :
      written_16;
  wire choice_189_4 =  // line 189
      request_index_i[2] ? !request_index_i[1] && (request_index_i[0] ? written_29 : written_28) :
      request_index_i[1] ? (request_index_i[0] ? written_27 : written_26) :
      request_index_i[0] ? written_25 :
      written_24;
  wire choice_189_5 =  // line 189
      request_index_i[4] ? (request_index_i[3] ? choice_189_4 : choice_189_3) : choice_189_2;
  wire both_99 = request_index_i[5] && choice_189_5;  // line 99

  logic [2:0] entry_143;  // kRules
  always_comb begin
    case (part_195)
      6'd0, 6'd1, 6'd2, 6'd4, 6'd12, 6'd13, 6'd14, 6'd15, 6'd16: entry_143 = 3'd1;
      6'd3, 6'd5, 6'd6, 6'd7, 6'd8, 6'd10, 6'd11, 6'd51: entry_143 = 3'd2;
      6'd9, 6'd33, 6'd58, 6'd59, 6'd60, 6'd61: entry_143 = 3'd4;
      6'd32, 6'd34, 6'd35, 6'd36, 6'd37, 6'd38, 6'd39, 6'd40, 6'd41, 6'd42, 6'd43, 6'd44,
      6'd45, 6'd46, 6'd47, 6'd48, 6'd49, 6'd50, 6'd52, 6'd53, 6'd54, 6'd55, 6'd56, 6'd57: entry_143 =
          3'd3;
      default: entry_143 = 3'd0;
    endcase
  end

  wire both = request_index_i[9:6] == 4'd0 && entry_143 == 3'd4 && stopped_i && unlocked;
  wire choice = (request_index_i[9:6] == 4'd0 && entry_143 == 3'd3) ? stopped_i : both;
  wire either = (request_index_i[9:6] == 4'd0 && entry_143 == 3'd2) || choice;
  wire both_97 = request_write_i && either;  // line 97
  wire [3:0] lanes = both_99 ? request_strobes_i : 4'd15;  // line 192
  wire [8:0] either_190 =  // line 190
      {1'b0, {8{request_strobes_i[0]}}} | (request_strobes_i[1] ? 9'd256 : 9'd0);
  wire [16:0] either_190_2 =  // line 190
      {1'b0, {7{either_190[8]}}, either_190} | (request_strobes_i[2] ? 17'd65536 : 17'd0);
  wire [24:0] mask =  // line 190
      {1'b0, {7{either_190_2[16]}}, either_190_2} | (request_strobes_i[3] ? 25'd16777216 : 25'd0);
  wire [30:0] key = request_data_i[30:0] & {{6{mask[24]}}, mask};  // line 191

  logic [30:0] entry_191;  // kFieldBits
  always_comb begin
    case (part_189)
      5'd0: entry_191 = 31'd50348031;
      5'd1: entry_191 = 31'd16728063;
      5'd2: entry_191 = 31'd4095;
      5'd3, 5'd25: entry_191 = 31'd32767;
      5'd4: entry_191 = 31'd2147418115;
      5'd5, 5'd6, 5'd7, 5'd9, 5'd10, 5'd18, 5'd20, 5'd21, 5'd22, 5'd23, 5'd24: entry_191 =
          31'd2147450879;
      5'd8: entry_191 = 31'd2147483647;
      5'd11: entry_191 = 31'd2147418355;
      5'd12, 5'd13, 5'd14, 5'd15, 5'd16, 5'd27, 5'd28, 5'd29: entry_191 = 31'd1048575;
      5'd17: entry_191 = 31'd2047807;
      5'd19: entry_191 = 31'd33554431;
      5'd26: entry_191 = 31'd1015807;
      default: entry_191 = 31'd0;
    endcase
  end

  wire [30:0] data = key & entry_191;  // line 191

  wire [31:0] mirror_data;
  word_mirror_sinusoidal mirror (
      .clk(clk),
      .rst(rst),
      .read_i(request_read_i),
      .address_i({1'b0, part_195} | (both_99 ? 7'd0 : 7'd64)),
      .write_i(both_97 ? lanes : 4'd0),
      .write_address_i({1'b0, part_195}),
      .write_data_i({1'b0, data}),
      .data_o(mirror_data)
  );

  always_ff @(posedge clk) begin
    if (both_97) begin
      logic [24:0] inverse_198;
      logic [14:0] wide_181;
      inverse_198 = ~mask;  // line 198
      wide_181 = {{6{inverse_198[24]}}, inverse_198[24:16]};  // line 181
      if (request_index_i == 10'd32) begin
        words_bridge_period <= key[13:0] | (words_bridge_period & inverse_198[13:0]);
        words_bridge_compensate <= key[24] || (words_bridge_compensate && inverse_198[24]);
        words_bridge_sine <= key[25] || (words_bridge_sine && inverse_198[24]);
      end
      if (request_index_i == 10'd33) begin
        words_bridge_minimum <= key[13:0] | (words_bridge_minimum & inverse_198[13:0]);
        words_bridge_dead_time <= key[23:16] | (words_bridge_dead_time & inverse_198[23:16]);
      end
      if (request_index_i == 10'd34) begin
        words_bridge_lost <= key[11:0] | (words_bridge_lost & inverse_198[11:0]);
      end
      if (request_index_i == 10'd35) begin
        words_bridge_inverse <= key[14:0] | (words_bridge_inverse & inverse_198[14:0]);
      end
      if (request_index_i == 10'd36) begin
        words_estimator_voltage <= key[0] || (words_estimator_voltage && inverse_198[0]);
        words_estimator_average <= key[1] || (words_estimator_average && inverse_198[1]);
        words_estimator_decay <= key[30:16] | (words_estimator_decay & wide_181);
      end
      if (request_index_i == 10'd37) begin
        words_estimator_gain <= key[14:0] | (words_estimator_gain & inverse_198[14:0]);
        words_estimator_k_theta <= key[30:16] | (words_estimator_k_theta & wide_181);
      end
      if (request_index_i == 10'd38) begin
        words_estimator_k_e <= key[14:0] | (words_estimator_k_e & inverse_198[14:0]);
        words_estimator_k_emf <= key[30:16] | (words_estimator_k_emf & wide_181);
      end
      if (request_index_i == 10'd39) begin
        words_estimator_k_speed <= key[14:0] | (words_estimator_k_speed & inverse_198[14:0]);
        words_estimator_k_si <= key[30:16] | (words_estimator_k_si & wide_181);
      end
      if (request_index_i == 10'd52) begin
        words_speed_slew <= key[14:0] | (words_speed_slew & inverse_198[14:0]);
        words_speed_filter <= key[30:16] | (words_speed_filter & wide_181);
      end
      if (request_index_i == 10'd53) begin
        words_speed_k_p <= key[14:0] | (words_speed_k_p & inverse_198[14:0]);
        words_speed_k_i <= key[30:16] | (words_speed_k_i & wide_181);
      end
      if (request_index_i == 10'd54) begin
        words_speed_limit <= key[14:0] | (words_speed_limit & inverse_198[14:0]);
        words_speed_lock <= key[30:16] | (words_speed_lock & wide_181);
      end
      if (request_index_i == 10'd55) begin
        words_speed_slow <= key[14:0] | (words_speed_slow & inverse_198[14:0]);
        words_speed_stop <= key[30:16] | (words_speed_stop & wide_181);
      end
      if (request_index_i == 10'd56) begin
        words_speed_emf_low <= key[14:0] | (words_speed_emf_low & inverse_198[14:0]);
        words_speed_emf_high <= key[30:16] | (words_speed_emf_high & wide_181);
      end
      if (request_index_i == 10'd40) begin
        words_control_set_gamma <= key[15:0] | (words_control_set_gamma & inverse_198[15:0]);
        words_control_limit <= key[30:16] | (words_control_limit & wide_181);
      end
      if (request_index_i == 10'd41) begin
        words_control_k_p <= key[14:0] | (words_control_k_p & inverse_198[14:0]);
        words_control_k_i <= key[30:16] | (words_control_k_i & wide_181);
      end
      if (request_index_i == 10'd42) begin
        words_control_inductance <= key[14:0] | (words_control_inductance & inverse_198[14:0]);
        words_control_emf <= key[30:16] | (words_control_emf & wide_181);
      end
      if (request_index_i == 10'd43) begin
        words_sequence_arbitrary <= key[0] || (words_sequence_arbitrary && inverse_198[0]);
        words_sequence_pilot <= key[1] || (words_sequence_pilot && inverse_198[1]);
        words_sequence_hold_voltage <= key[30:16] | (words_sequence_hold_voltage & wide_181);
        words_sequence_retries <= key[7:4] | (words_sequence_retries & inverse_198[7:4]);
      end
      if (request_index_i == 10'd44) begin
        words_sequence_pattern <= key[19:0] | (words_sequence_pattern & inverse_198[19:0]);
      end
      if (request_index_i == 10'd45) begin
        words_sequence_lock <= key[19:0] | (words_sequence_lock & inverse_198[19:0]);
      end
      if (request_index_i == 10'd46) begin
        words_sequence_give_up <= key[19:0] | (words_sequence_give_up & inverse_198[19:0]);
      end
      if (request_index_i == 10'd48) begin
        words_sequence_brake <= key[19:0] | (words_sequence_brake & inverse_198[19:0]);
      end
      if (request_index_i == 10'd47) begin
        words_sequence_rest <= key[19:0] | (words_sequence_rest & inverse_198[19:0]);
      end
      if (request_index_i == 10'd49) begin
        words_pilot_short_periods <= key[5:0] | (words_pilot_short_periods & inverse_198[5:0]);
        words_pilot_long_periods <= key[13:8] | (words_pilot_long_periods & inverse_198[13:8]);
        words_pilot_rounds <= key[20:16] | (words_pilot_rounds & inverse_198[20:16]);
      end
      if (request_index_i == 10'd50) begin
        words_pilot_decayed <= key[14:0] | (words_pilot_decayed & inverse_198[14:0]);
        words_pilot_saliency <= key[30:16] | (words_pilot_saliency & wide_181);
      end
      if (request_index_i == 10'd57) begin
        words_pilot_polarity <= key[14:0] | (words_pilot_polarity & inverse_198[14:0]);
      end
      if (request_index_i == 10'd58) begin
        words_fault_over_current <= key[14:0] | (words_fault_over_current & inverse_198[14:0]);
        words_fault_lost_samples <= key[19:16] | (words_fault_lost_samples & inverse_198[19:16]);
      end
      if (request_index_i == 10'd59) begin
        words_fault_saturated <= key[19:0] | (words_fault_saturated & inverse_198[19:0]);
      end
      if (request_index_i == 10'd60) begin
        words_fault_slow <= key[19:0] | (words_fault_slow & inverse_198[19:0]);
      end
      if (request_index_i == 10'd61) begin
        words_fault_emf <= key[19:0] | (words_fault_emf & inverse_198[19:0]);
      end
      if (request_index_i == 10'd51) begin
        staged_speed_target <= key[24:0] | (staged_speed_target & inverse_198);
      end
      if (request_index_i == 10'd8) begin
        unlocked <= key[15:0] == 16'd49374;
      end
      written_0 <= request_index_i == 10'd32 || written_0;
      written_1 <= request_index_i == 10'd33 || written_1;
      written_2 <= request_index_i == 10'd34 || written_2;
      written_3 <= request_index_i == 10'd35 || written_3;
      written_4 <= request_index_i == 10'd36 || written_4;
      written_5 <= request_index_i == 10'd37 || written_5;
      written_6 <= request_index_i == 10'd38 || written_6;
      written_7 <= request_index_i == 10'd39 || written_7;
      written_8 <= request_index_i == 10'd40 || written_8;
      written_9 <= request_index_i == 10'd41 || written_9;
      written_10 <= request_index_i == 10'd42 || written_10;
      written_11 <= request_index_i == 10'd43 || written_11;
      written_12 <= request_index_i == 10'd44 || written_12;
      written_13 <= request_index_i == 10'd45 || written_13;
      written_14 <= request_index_i == 10'd46 || written_14;
      written_15 <= request_index_i == 10'd47 || written_15;
      written_16 <= request_index_i == 10'd48 || written_16;
      written_17 <= request_index_i == 10'd49 || written_17;
      written_18 <= request_index_i == 10'd50 || written_18;
      written_19 <= request_index_i == 10'd51 || written_19;
      written_20 <= request_index_i == 10'd52 || written_20;
      written_21 <= request_index_i == 10'd53 || written_21;
      written_22 <= request_index_i == 10'd54 || written_22;
      written_23 <= request_index_i == 10'd55 || written_23;
      written_24 <= request_index_i == 10'd56 || written_24;
      written_25 <= request_index_i == 10'd57 || written_25;
      written_26 <= request_index_i == 10'd58 || written_26;
      written_27 <= request_index_i == 10'd59 || written_27;
      written_28 <= request_index_i == 10'd60 || written_28;
      written_29 <= request_index_i == 10'd61 || written_29;
    end
    if (boundary_i || stopped_i) begin
      words_speed_target <= staged_speed_target;
    end
    if (request_read_i) begin
      shows <= request_index_i[9:6] == 4'd0;
    end
    if (rst) begin
      words_bridge_period <= 14'd0;
      words_bridge_minimum <= 14'd0;
      words_bridge_dead_time <= 8'd0;
      words_bridge_lost <= 12'd0;
      words_bridge_compensate <= 1'b0;
      words_bridge_sine <= 1'b0;
      words_bridge_inverse <= 15'd0;
      words_estimator_voltage <= 1'b0;
      words_estimator_average <= 1'b0;
      words_estimator_decay <= 15'd0;
      words_estimator_gain <= 15'd0;
      words_estimator_k_theta <= 15'd0;
      words_estimator_k_e <= 15'd0;
      words_estimator_k_speed <= 15'd0;
      words_estimator_k_emf <= 15'd0;
      words_estimator_k_si <= 15'd0;
      words_speed_target <= 25'd0;
      words_speed_slew <= 15'd0;
      words_speed_filter <= 15'd0;
      words_speed_k_p <= 15'd0;
      words_speed_k_i <= 15'd0;
      words_speed_limit <= 15'd0;
      words_speed_lock <= 15'd0;
      words_speed_slow <= 15'd0;
      words_speed_stop <= 15'd0;
      words_speed_emf_low <= 15'd0;
      words_speed_emf_high <= 15'd0;
      words_control_set_gamma <= 16'sd0;
      words_control_k_p <= 15'd0;
      words_control_k_i <= 15'd0;
      words_control_inductance <= 15'd0;
      words_control_emf <= 15'd0;
      words_control_limit <= 15'd0;
      words_sequence_arbitrary <= 1'b0;
      words_sequence_pilot <= 1'b0;
      words_sequence_hold_voltage <= 15'd0;
      words_sequence_pattern <= 20'd0;
      words_sequence_lock <= 20'd0;
      words_sequence_give_up <= 20'd0;
      words_sequence_brake <= 20'd0;
      words_sequence_rest <= 20'd0;
      words_sequence_retries <= 4'd0;
      words_pilot_short_periods <= 6'd0;
      words_pilot_long_periods <= 6'd0;
      words_pilot_rounds <= 5'd0;
      words_pilot_decayed <= 15'd0;
      words_pilot_saliency <= 15'd0;
      words_pilot_polarity <= 15'd0;
      words_fault_over_current <= 15'd0;
      words_fault_saturated <= 20'd0;
      words_fault_slow <= 20'd0;
      words_fault_emf <= 20'd0;
      words_fault_lost_samples <= 4'd0;
      staged_speed_target <= 25'd0;
      unlocked <= 1'b0;
      written_0 <= 1'b0;
      written_1 <= 1'b0;
      written_2 <= 1'b0;
      written_3 <= 1'b0;
      written_4 <= 1'b0;
      written_5 <= 1'b0;
      written_6 <= 1'b0;
      written_7 <= 1'b0;
      written_8 <= 1'b0;
      written_9 <= 1'b0;
      written_10 <= 1'b0;
      written_11 <= 1'b0;
      written_12 <= 1'b0;
      written_13 <= 1'b0;
      written_14 <= 1'b0;
      written_15 <= 1'b0;
      written_16 <= 1'b0;
      written_17 <= 1'b0;
      written_18 <= 1'b0;
      written_19 <= 1'b0;
      written_20 <= 1'b0;
      written_21 <= 1'b0;
      written_22 <= 1'b0;
      written_23 <= 1'b0;
      written_24 <= 1'b0;
      written_25 <= 1'b0;
      written_26 <= 1'b0;
      written_27 <= 1'b0;
      written_28 <= 1'b0;
      written_29 <= 1'b0;
      shows <= 1'b0;
    end
  end

  assign words_bridge_period_o = words_bridge_period;
  assign words_bridge_minimum_o = words_bridge_minimum;
  assign words_bridge_dead_time_o = words_bridge_dead_time;
  assign words_bridge_lost_o = words_bridge_lost;
  assign words_bridge_compensate_o = words_bridge_compensate;
  assign words_bridge_sine_o = words_bridge_sine;
  assign words_bridge_inverse_o = words_bridge_inverse;
  assign words_estimator_voltage_o = words_estimator_voltage;
  assign words_estimator_average_o = words_estimator_average;
  assign words_estimator_decay_o = words_estimator_decay;
  assign words_estimator_gain_o = words_estimator_gain;
  assign words_estimator_k_theta_o = words_estimator_k_theta;
  assign words_estimator_k_e_o = words_estimator_k_e;
  assign words_estimator_k_speed_o = words_estimator_k_speed;
  assign words_estimator_k_emf_o = words_estimator_k_emf;
  assign words_estimator_k_si_o = words_estimator_k_si;
  assign words_speed_target_o = words_speed_target;
  assign words_speed_slew_o = words_speed_slew;
  assign words_speed_filter_o = words_speed_filter;
  assign words_speed_k_p_o = words_speed_k_p;
  assign words_speed_k_i_o = words_speed_k_i;
  assign words_speed_limit_o = words_speed_limit;
  assign words_speed_lock_o = words_speed_lock;
  assign words_speed_slow_o = words_speed_slow;
  assign words_speed_stop_o = words_speed_stop;
  assign words_speed_emf_low_o = words_speed_emf_low;
  assign words_speed_emf_high_o = words_speed_emf_high;
  assign words_control_set_gamma_o = words_control_set_gamma;
  assign words_control_k_p_o = words_control_k_p;
  assign words_control_k_i_o = words_control_k_i;
  assign words_control_inductance_o = words_control_inductance;
  assign words_control_emf_o = words_control_emf;
  assign words_control_limit_o = words_control_limit;
  assign words_sequence_arbitrary_o = words_sequence_arbitrary;
  assign words_sequence_pilot_o = words_sequence_pilot;
  assign words_sequence_hold_voltage_o = words_sequence_hold_voltage;
  assign words_sequence_pattern_o = words_sequence_pattern;
  assign words_sequence_lock_o = words_sequence_lock;
  assign words_sequence_give_up_o = words_sequence_give_up;
  assign words_sequence_brake_o = words_sequence_brake;
  assign words_sequence_rest_o = words_sequence_rest;
  assign words_sequence_retries_o = words_sequence_retries;
  assign words_pilot_short_periods_o = words_pilot_short_periods;
  assign words_pilot_long_periods_o = words_pilot_long_periods;
  assign words_pilot_rounds_o = words_pilot_rounds;
  assign words_pilot_decayed_o = words_pilot_decayed;
  assign words_pilot_saliency_o = words_pilot_saliency;
  assign words_pilot_polarity_o = words_pilot_polarity;
  assign words_fault_over_current_o = words_fault_over_current;
  assign words_fault_saturated_o = words_fault_saturated;
  assign words_fault_slow_o = words_fault_slow;
  assign words_fault_emf_o = words_fault_emf;
  assign words_fault_lost_samples_o = words_fault_lost_samples;
  assign data_o = shows ? mirror_data : 32'd0;
  assign hole_o = request_index_i[9:6] != 4'd0 || entry_143 == 3'd0;
  assign refused_o = !either;
  assign unlocked_o = unlocked;
  assign no_period_o = words_bridge_period[13:1] < 13'd239;

  // What nothing reads, for the linters.
  wire unused = &{1'b0, request_data_i[31]};
endmodule
