// sinusoidal_bare: steplock::SinusoidalBare, printed by hlsgen from hls/sinusoidal/sinusoidal_bare.hpp:34.
// Do not edit: change the C++ and print again.

module sinusoidal_bare (
    input  logic        clk,
    input  logic        rst,  // synchronous, active high
    input  logic        pins_fault_i,  // active high
    input  logic        pins_miso_i,  // from the converter's DOUT
    input  logic        controls_run_i,
    input  logic        controls_reverse_i,
    input  logic [1:0]  controls_speed_i,  // 0 to 3: a quarter to the whole of the set speed
    input  logic        brake_to_stop_i,  // else coast; fixed at synthesis, as are the words
    input  logic [5:0]  converter_half_i,  // clocks of half an sclk period; 0: off
    input  logic [7:0]  converter_quiet_i,  // clocks of cs_n high between frames; less than 4 counts as 4
    input  logic [2:0]  converter_u_i,  // channel of the current of phase u
    input  logic [2:0]  converter_v_i,  // channel of the current of phase v
    input  logic [2:0]  converter_dc_i,  // channel of the dc voltage
    input  logic        converter_twice_i,  // the range is twice the reference, not once
    input  logic [13:0] words_bridge_period_i,  // clocks; 478 at least, a sample's
    input  logic [13:0] words_bridge_minimum_i,  // clocks; shorter on or off times become 0 % or 100 %
    input  logic [7:0]  words_bridge_dead_time_i,  // clocks; the guard's floor wins
    input  logic [11:0] words_bridge_lost_i,  // u8.4 clocks that a leg loses by it, with its diode's drop
    input  logic        words_bridge_compensate_i,  // the on-times make up for it
    input  logic        words_bridge_sine_i,  // no zero component
    input  logic [14:0] words_bridge_inverse_i,  // u0.25: 1 / (3 period)
    input  logic        words_estimator_voltage_i,  // the voltage model's estimate, else the current model's
    input  logic        words_estimator_average_i,  // voltage model: the mean of 8 samples
    input  logic [14:0] words_estimator_decay_i,  // u0.15, per sample
    input  logic [14:0] words_estimator_gain_i,  // u2.13, current per voltage
    input  logic [14:0] words_estimator_k_theta_i,  // u1.14, turns per current; K_SP L of the voltage model is the same
    input  logic [14:0] words_estimator_k_e_i,  // u2.13, voltage per current
    input  logic [14:0] words_estimator_k_speed_i,  // u-2.17, turns per voltage
    input  logic [14:0] words_estimator_k_emf_i,  // u0.15, turns per current
    input  logic [14:0] words_estimator_k_si_i,  // u-8.23, turns per current
    input  logic [24:0] words_speed_target_i,  // u0.25
    input  logic [14:0] words_speed_slew_i,  // u0.25, per sample
    input  logic [14:0] words_speed_filter_i,  // u0.15, per sample
    input  logic [14:0] words_speed_k_p_i,  // u7.8
    input  logic [14:0] words_speed_k_i_i,  // u-2.17, per sample
    input  logic [14:0] words_speed_limit_i,  // u0.15, of the current
    input  logic [14:0] words_speed_lock_i,  // u0.15: above, the estimate may be trusted
    input  logic [14:0] words_speed_slow_i,  // u0.15: below, it may not
    input  logic [14:0] words_speed_stop_i,  // u0.15: below, the drive lets go
    input  logic [14:0] words_speed_emf_low_i,  // u2.13
    input  logic [14:0] words_speed_emf_high_i,  // u2.13
    input  logic [15:0] words_control_set_gamma_i,  // s0.15
    input  logic [14:0] words_control_k_p_i,  // u3.12
    input  logic [14:0] words_control_k_i_i,  // u0.15, per sample
    input  logic [14:0] words_control_inductance_i,  // u5.10, voltage per current and speed
    input  logic [14:0] words_control_emf_i,  // u5.10, voltage per speed
    input  logic [14:0] words_control_limit_i,  // u0.15, of the dc voltage
    input  logic        words_sequence_arbitrary_i,  // no pattern before the loop is closed
    input  logic        words_sequence_pilot_i,  // pilot pulses instead of the pattern: a salient rotor
    input  logic [14:0] words_sequence_hold_voltage_i,  // u0.15, of the pattern's leg, or of a pilot pulse's
    input  logic [19:0] words_sequence_pattern_i,  // each of its two halves; all pilot pulses at most
    input  logic [19:0] words_sequence_lock_i,  // the estimate has to be trusted for so long
    input  logic [19:0] words_sequence_give_up_i,  // no lock in this time is a failed try
    input  logic [19:0] words_sequence_brake_i,
    input  logic [19:0] words_sequence_rest_i,
    input  logic [3:0]  words_sequence_retries_i,
    input  logic [5:0]  words_pilot_short_periods_i,  // 0 counts as 1
    input  logic [5:0]  words_pilot_long_periods_i,  // 0 counts as 1
    input  logic [4:0]  words_pilot_rounds_i,  // of six short pulses; even
    input  logic [14:0] words_pilot_decayed_i,  // u0.15: below, a current is gone
    input  logic [14:0] words_pilot_saliency_i,  // u0.15: a smaller sum is no position
    input  logic [14:0] words_pilot_polarity_i,  // u0.15: a smaller difference of the long peaks is no polarity
    input  logic [14:0] words_fault_over_current_i,  // u0.15, any phase
    input  logic [19:0] words_fault_saturated_i,  // a regulator at its limit for more than this; 0: no test
    input  logic [19:0] words_fault_slow_i,  // slow for more than this longer than not; 0: no test
    input  logic [19:0] words_fault_emf_i,  // an EMF that does not belong to the speed for more; 0: no test
    input  logic [3:0]  words_fault_lost_samples_i,  // in a row; 0: no test
    output logic        gates_uh_o,  // phase U, high side
    output logic        gates_ul_o,  // phase U, low side
    output logic        gates_vh_o,  // phase V, high side
    output logic        gates_vl_o,  // phase V, low side
    output logic        gates_wh_o,  // phase W, high side
    output logic        gates_wl_o,  // phase W, low side
    output logic        cs_n_o,  // to the converter
    output logic        sclk_o,
    output logic        mosi_o,
    output logic        locked_o,  // running, the estimate is claimed to be right
    output logic        fault_o,  // latched
    output logic        turn_o  // a tachometer, one period per electrical turn while the loop is closed
);
  (* ASYNC_REG = "TRUE", syn_preserve = 1,
     altera_attribute = "-name SYNCHRONIZER_IDENTIFICATION FORCED" *)
  logic
      first_run,
      first_reverse;
  (* ASYNC_REG = "TRUE", syn_preserve = 1,
     altera_attribute = "-name SYNCHRONIZER_IDENTIFICATION FORCED" *)
  logic [1:0] first_speed;  // 0 to 3: a quarter to the whole of the set speed
  (* ASYNC_REG = "TRUE", syn_preserve = 1,
     altera_attribute = "-name SYNCHRONIZER_IDENTIFICATION FORCED" *)
  logic
      second_run,
      second_reverse;
  (* ASYNC_REG = "TRUE", syn_preserve = 1,
     altera_attribute = "-name SYNCHRONIZER_IDENTIFICATION FORCED" *)
  logic [1:0] second_speed;  // 0 to 3: a quarter to the whole of the set speed
  logic taken_run;
  logic taken_reverse;
  logic [1:0] taken_speed;  // 0 to 3: a quarter to the whole of the set speed
  logic [7:0] bounce;
  logic sampled;  // a period has begun

  wire converter_cs_n;
  wire converter_sclk;
  wire converter_mosi;
  wire converter_codes_valid;
  wire [11:0] converter_codes_u;
  wire [11:0] converter_codes_v;
  wire [11:0] converter_codes_dc;
  wire unused_converter_ready;
  wire unused_converter_missed;
  wire unused_converter_error;
  spi_adc converter (
      .clk(clk),
      .rst(rst),
      .sample_i(sampled),
      .miso_i(pins_miso_i),
      .words_half_i(converter_half_i),
      .words_quiet_i(converter_quiet_i),
      .words_u_i(converter_u_i),
      .words_v_i(converter_v_i),
      .words_dc_i(converter_dc_i),
      .words_twice_i(converter_twice_i),
      .cs_n_o(converter_cs_n),
      .sclk_o(converter_sclk),
      .mosi_o(converter_mosi),
      .codes_valid_o(converter_codes_valid),
      .codes_u_o(converter_codes_u),
      .codes_v_o(converter_codes_v),
      .codes_dc_o(converter_codes_dc),
      .ready_o(unused_converter_ready),
      .missed_o(unused_converter_missed),
      .error_o(unused_converter_error)
  );

  wire both_73 = sampled && bounce == 8'd0;  // line 73
  wire [24:0] half = {1'b0, words_speed_target_i[24:1]};  // line 106
  wire [24:0] quarter = {2'd0, words_speed_target_i[24:2]};  // line 107
  wire [24:0] sum = half + quarter;

  logic [24:0] part;  // line 111
  always_comb begin
    case (taken_speed)
      2'd2: part = sum;
      2'd1: part = half;
      2'd0: part = quarter;
      default: part = words_speed_target_i;
    endcase
  end

  wire [24:0] lock = {words_speed_lock_i, 10'd0};  // line 112
  wire [26:0] sum_113 =  // line 113
      {1'b0, {1'b0, lock} + {5'd0, words_speed_lock_i, 6'd0}} + {7'd0, words_speed_lock_i, 5'd0};
  wire [24:0] least = (sum_113[26:25] == 2'd0) ? sum_113[24:0] : 25'd33554431;  // line 113
  wire [24:0] words_speed_target = (part < least) ? least : part;  // line 114

  wire drive_gates_uh;
  wire drive_gates_ul;
  wire drive_gates_vh;
  wire drive_gates_vl;
  wire drive_gates_wh;
  wire drive_gates_wl;
  wire [3:0] drive_state;
  wire [3:0] unused_drive_reason;
  wire drive_sample;
  wire drive_locked;
  wire drive_estimating;
  wire unused_drive_done;
  wire unused_drive_busy;
  wire unused_drive_reverse;
  wire [3:0] unused_drive_tries;
  wire [23:0] drive_angle;
  wire [23:0] unused_drive_initial;
  wire [15:0] unused_drive_speed;
  wire [15:0] unused_drive_reference;
  wire [15:0] unused_drive_i_gamma;
  wire [15:0] unused_drive_i_delta;
  wire [15:0] unused_drive_wanted;
  wire [11:0] unused_drive_v_dc;
  wire [13:0] unused_drive_on_u;
  wire [13:0] unused_drive_on_v;
  wire [13:0] unused_drive_on_w;
  sinusoidal_top drive (
      .clk(clk),
      .rst(rst),
      .fault_i(pins_fault_i),
      .codes_valid_i(converter_codes_valid),
      .codes_u_i(converter_codes_u),
      .codes_v_i(converter_codes_v),
      .codes_dc_i(converter_codes_dc),
      .command_configured_i(1'b1),
      .command_run_i(taken_run && second_run),
      .command_reverse_i(taken_reverse),
      .command_brake_to_stop_i(brake_to_stop_i),
      .command_clear_fault_i(both_73),
      .words_bridge_period_i(words_bridge_period_i),
      .words_bridge_minimum_i(words_bridge_minimum_i),
      .words_bridge_dead_time_i(words_bridge_dead_time_i),
      .words_bridge_lost_i(words_bridge_lost_i),
      .words_bridge_compensate_i(words_bridge_compensate_i),
      .words_bridge_sine_i(words_bridge_sine_i),
      .words_bridge_inverse_i(words_bridge_inverse_i),
      .words_estimator_voltage_i(words_estimator_voltage_i),
      .words_estimator_average_i(words_estimator_average_i),
      .words_estimator_decay_i(words_estimator_decay_i),
      .words_estimator_gain_i(words_estimator_gain_i),
      .words_estimator_k_theta_i(words_estimator_k_theta_i),
      .words_estimator_k_e_i(words_estimator_k_e_i),
      .words_estimator_k_speed_i(words_estimator_k_speed_i),
      .words_estimator_k_emf_i(words_estimator_k_emf_i),
      .words_estimator_k_si_i(words_estimator_k_si_i),
      .words_speed_target_i(words_speed_target),
      .words_speed_slew_i(words_speed_slew_i),
      .words_speed_filter_i(words_speed_filter_i),
      .words_speed_k_p_i(words_speed_k_p_i),
      .words_speed_k_i_i(words_speed_k_i_i),
      .words_speed_limit_i(words_speed_limit_i),
      .words_speed_lock_i(words_speed_lock_i),
      .words_speed_slow_i(words_speed_slow_i),
      .words_speed_stop_i(words_speed_stop_i),
      .words_speed_emf_low_i(words_speed_emf_low_i),
      .words_speed_emf_high_i(words_speed_emf_high_i),
      .words_control_set_gamma_i(words_control_set_gamma_i),
      .words_control_k_p_i(words_control_k_p_i),
      .words_control_k_i_i(words_control_k_i_i),
      .words_control_inductance_i(words_control_inductance_i),
      .words_control_emf_i(words_control_emf_i),
      .words_control_limit_i(words_control_limit_i),
      .words_sequence_arbitrary_i(words_sequence_arbitrary_i),
      .words_sequence_pilot_i(words_sequence_pilot_i),
      .words_sequence_hold_voltage_i(words_sequence_hold_voltage_i),
      .words_sequence_pattern_i(words_sequence_pattern_i),
      .words_sequence_lock_i(words_sequence_lock_i),
      .words_sequence_give_up_i(words_sequence_give_up_i),
      .words_sequence_brake_i(words_sequence_brake_i),
      .words_sequence_rest_i(words_sequence_rest_i),
      .words_sequence_retries_i(words_sequence_retries_i),
      .words_pilot_short_periods_i(words_pilot_short_periods_i),
      .words_pilot_long_periods_i(words_pilot_long_periods_i),
      .words_pilot_rounds_i(words_pilot_rounds_i),
      .words_pilot_decayed_i(words_pilot_decayed_i),
      .words_pilot_saliency_i(words_pilot_saliency_i),
      .words_pilot_polarity_i(words_pilot_polarity_i),
      .words_fault_over_current_i(words_fault_over_current_i),
      .words_fault_saturated_i(words_fault_saturated_i),
      .words_fault_slow_i(words_fault_slow_i),
      .words_fault_emf_i(words_fault_emf_i),
      .words_fault_lost_samples_i(words_fault_lost_samples_i),
      .gates_uh_o(drive_gates_uh),
      .gates_ul_o(drive_gates_ul),
      .gates_vh_o(drive_gates_vh),
      .gates_vl_o(drive_gates_vl),
      .gates_wh_o(drive_gates_wh),
      .gates_wl_o(drive_gates_wl),
      .state_o(drive_state),
      .reason_o(unused_drive_reason),
      .sample_o(drive_sample),
      .locked_o(drive_locked),
      .estimating_o(drive_estimating),
      .done_o(unused_drive_done),
      .busy_o(unused_drive_busy),
      .reverse_o(unused_drive_reverse),
      .tries_o(unused_drive_tries),
      .angle_o(drive_angle),
      .initial_o(unused_drive_initial),
      .speed_o(unused_drive_speed),
      .reference_o(unused_drive_reference),
      .i_gamma_o(unused_drive_i_gamma),
      .i_delta_o(unused_drive_i_delta),
      .wanted_o(unused_drive_wanted),
      .v_dc_o(unused_drive_v_dc),
      .on_u_o(unused_drive_on_u),
      .on_v_o(unused_drive_on_v),
      .on_w_o(unused_drive_on_w)
  );

  always_ff @(posedge clk) begin
    first_run <= controls_run_i;
    first_reverse <= controls_reverse_i;
    first_speed <= controls_speed_i;
    second_run <= first_run;
    second_reverse <= first_reverse;
    second_speed <= first_speed;
    taken_run <= (both_73 ? second_run : taken_run) && second_run;  // line 85
    if (sampled) begin
      if (bounce == 8'd0) begin
        taken_reverse <= second_reverse;
        taken_speed <= second_speed;
      end
      bounce <= bounce + 8'd1;
    end
    sampled <= drive_sample;
    if (rst) begin
      first_run <= 1'b0;
      first_reverse <= 1'b0;
      first_speed <= 2'd0;
      second_run <= 1'b0;
      second_reverse <= 1'b0;
      second_speed <= 2'd0;
      taken_run <= 1'b0;
      taken_reverse <= 1'b0;
      taken_speed <= 2'd0;
      bounce <= 8'd0;
      sampled <= 1'b0;
    end
  end

  assign gates_uh_o = drive_gates_uh;
  assign gates_ul_o = drive_gates_ul;
  assign gates_vh_o = drive_gates_vh;
  assign gates_vl_o = drive_gates_vl;
  assign gates_wh_o = drive_gates_wh;
  assign gates_wl_o = drive_gates_wl;
  assign cs_n_o = converter_cs_n;
  assign sclk_o = converter_sclk;
  assign mosi_o = converter_mosi;
  assign locked_o = drive_locked;
  assign fault_o = drive_state == 4'd9;
  assign turn_o = drive_estimating && drive_angle[23];

  // What nothing reads, for the linters.
  wire unused = &{1'b0, drive_angle[22:0]};
endmodule
