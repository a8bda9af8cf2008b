// sinusoidal_control: steplock::SinusoidalControl, printed by hlsgen from hls/sinusoidal/sinusoidal_control.hpp:28.
// A sample takes 476 clocks, and in no order fewer than 476: 700 operations, 89 products, 6 entries of tables
// as 471 instructions on 1 multiplier of 31 x 16 bits and one adder of 44; 467 register bits,
// 111 words of memory of 32 bits. Early outputs are new after 231 clocks.
// Do not edit: change the C++ and print again.

module sinusoidal_control (
    input  logic        clk,
    input  logic        rst,  // synchronous, active high
    input  logic        estimate_i,  // false: the angle is `initial`, the speed 0
    input  logic        regulate_i,  // the loop is closed
    input  logic        locked_i,  // a slow estimate is to be believed
    input  logic        reverse_i,  // the wanted direction
    input  logic        slow_down_i,  // towards a stop
    input  logic        hold_i,  // one leg alone
    input  logic        hold_v_i,  // that leg is v, else u
    input  logic        pilot_i,  // pulses: a leg's on-time without regard to what its current may be
    input  logic        search_i,  // `a` and `b` are the currents that are turned
    input  logic [15:0] a_i,  // s0.15
    input  logic [15:0] b_i,  // s0.15
    input  logic [23:0] initial_i,  // u0.24
    input  logic [15:0] i_u_i,  // s0.15
    input  logic [15:0] i_v_i,  // s0.15
    input  logic [11:0] v_dc_i,  // u0.12
    input  logic [13:0] ended_on_u_i,  // clocks
    input  logic [13:0] ended_on_v_i,  // clocks
    input  logic [13:0] ended_on_w_i,  // clocks
    input  logic [13:0] bridge_period_i,  // clocks; 478 at least, a sample's
    input  logic [13:0] bridge_minimum_i,  // clocks; shorter on or off times become 0 % or 100 %
    input  logic [7:0]  bridge_dead_time_i,  // clocks; the guard's floor wins
    input  logic [11:0] bridge_lost_i,  // u8.4 clocks that a leg loses by it, with its diode's drop
    input  logic        bridge_compensate_i,  // the on-times make up for it
    input  logic        bridge_sine_i,  // no zero component
    input  logic [14:0] bridge_inverse_i,  // u0.25: 1 / (3 period)
    input  logic        estimator_voltage_i,  // the voltage model's estimate, else the current model's
    input  logic        estimator_average_i,  // voltage model: the mean of 8 samples
    input  logic [14:0] estimator_decay_i,  // u0.15, per sample
    input  logic [14:0] estimator_gain_i,  // u2.13, current per voltage
    input  logic [14:0] estimator_k_theta_i,  // u1.14, turns per current; K_SP L of the voltage model is the same
    input  logic [14:0] estimator_k_e_i,  // u2.13, voltage per current
    input  logic [14:0] estimator_k_speed_i,  // u-2.17, turns per voltage
    input  logic [14:0] estimator_k_emf_i,  // u0.15, turns per current
    input  logic [14:0] estimator_k_si_i,  // u-8.23, turns per current
    input  logic [24:0] speed_target_i,  // u0.25
    input  logic [14:0] speed_slew_i,  // u0.25, per sample
    input  logic [14:0] speed_filter_i,  // u0.15, per sample
    input  logic [14:0] speed_k_p_i,  // u7.8
    input  logic [14:0] speed_k_i_i,  // u-2.17, per sample
    input  logic [14:0] speed_limit_i,  // u0.15, of the current
    input  logic [14:0] speed_lock_i,  // u0.15: above, the estimate may be trusted
    input  logic [14:0] speed_slow_i,  // u0.15: below, it may not
    input  logic [14:0] speed_stop_i,  // u0.15: below, the drive lets go
    input  logic [14:0] speed_emf_low_i,  // u2.13
    input  logic [14:0] speed_emf_high_i,  // u2.13
    input  logic [15:0] control_set_gamma_i,  // s0.15
    input  logic [14:0] control_k_p_i,  // u3.12
    input  logic [14:0] control_k_i_i,  // u0.15, per sample
    input  logic [14:0] control_inductance_i,  // u5.10, voltage per current and speed
    input  logic [14:0] control_emf_i,  // u5.10, voltage per speed
    input  logic [14:0] control_limit_i,  // u0.15, of the dc voltage
    input  logic [14:0] hold_voltage_i,  // u0.15
    input  logic        start_i,  // begins a sample, unless busy
    output logic [13:0] early_on_u_o,  // clocks
    output logic [13:0] early_on_v_o,  // clocks
    output logic [13:0] early_on_w_o,  // clocks
    output logic [23:0] angle_o,  // u0.24, at this sample
    output logic [15:0] i_gamma_o,  // s0.15
    output logic [15:0] i_delta_o,  // s0.15
    output logic        limited_o,  // the voltage would have been longer
    output logic [15:0] speed_current_o,  // s0.15, i_delta*
    output logic [15:0] speed_speed_o,  // s0.15, smoothed
    output logic [15:0] speed_reference_o,  // s0.15, in the wanted direction
    output logic        speed_saturated_o,  // the current is limited
    output logic        speed_fast_o,  // above `lock`
    output logic        speed_slow_o,  // below `slow`
    output logic        speed_stopping_o,  // below `stop`
    output logic        speed_plausible_o,  // the EMF belongs to the speed
    output logic        done_o,  // one clock: the results are new
    output logic        busy_o,  // a start would be ignored
    output logic        missed_o  // one clock: a start was ignored
);
  logic [8:0] step;  // 0: waiting for a start; the program's address
  logic active;  // the word is the program's
  logic fresh;  // no sample since the reset: registers read as such
  logic [31:0] result;  // in its format
  logic [25:0] port;  // an input, held from start to done
  logic condition;  // of a choice
  logic [46:0] product;  // of two factors
  logic [43:0] sum;  // of two numbers
  logic [13:0] early_on_u_new;  // of this sample
  logic [13:0] early_on_v_new;  // of this sample
  logic [13:0] early_on_w_new;  // of this sample
  logic [23:0] angle_new;  // of this sample
  logic [15:0] i_gamma_new;  // of this sample
  logic [15:0] i_delta_new;  // of this sample
  logic limited_new;  // of this sample
  logic [15:0] speed_current_new;  // of this sample
  logic [15:0] speed_speed_new;  // of this sample
  logic [15:0] speed_reference_new;  // of this sample
  logic speed_saturated_new;  // of this sample
  logic speed_fast_new;  // of this sample
  logic speed_slow_new;  // of this sample
  logic speed_stopping_new;  // of this sample
  logic speed_plausible_new;  // of this sample
  logic [13:0] early_on_u_held;  // until the next is done
  logic [13:0] early_on_v_held;  // until the next is done
  logic [13:0] early_on_w_held;  // until the next is done
  logic [23:0] angle_held;  // until the next is done
  logic [15:0] i_gamma_held;  // until the next is done
  logic [15:0] i_delta_held;  // until the next is done
  logic limited_held;  // until the next is done
  logic [15:0] speed_current_held;  // until the next is done
  logic [15:0] speed_speed_held;  // until the next is done
  logic [15:0] speed_reference_held;  // until the next is done
  logic speed_saturated_held;  // until the next is done
  logic speed_fast_held;  // until the next is done
  logic speed_slow_held;  // until the next is done
  logic speed_stopping_held;  // until the next is done
  logic speed_plausible_held;  // until the next is done
  logic done;
  logic missed;

  wire [75:0] program__data;
  sinusoidal_control_program program_ (
      .clk(clk),
      .rst(rst),
      .address_i(step),
      .data_o(program__data)
  );

  wire both = program__data[64] && active;

  wire [31:0] numbers_a_data;
  sinusoidal_control_numbers numbers_a (
      .clk(clk),
      .rst(rst),
      .address_i({program__data[6:1], program__data[0] || (program__data[7] && fresh)}),
      .write_i(both),
      .write_address_i(program__data[71:65]),
      .write_data_i(result),
      .data_o(numbers_a_data)
  );

  wire [31:0] numbers_b_data;
  sinusoidal_control_numbers numbers_b (
      .clk(clk),
      .rst(rst),
      .address_i({program__data[14:9], program__data[8] || (program__data[15] && fresh)}),
      .write_i(both),
      .write_address_i(program__data[71:65]),
      .write_data_i(result),
      .data_o(numbers_b_data)
  );

  wire [31:0] numbers_c_data;
  sinusoidal_control_numbers numbers_c (
      .clk(clk),
      .rst(rst),
      .address_i({program__data[22:17], program__data[16] || (program__data[23] && fresh)}),
      .write_i(both),
      .write_address_i(program__data[71:65]),
      .write_data_i(result),
      .data_o(numbers_c_data)
  );

  wire [31:0] numbers_d_data;
  sinusoidal_control_numbers numbers_d (
      .clk(clk),
      .rst(rst),
      .address_i({program__data[30:25], program__data[24] || (program__data[31] && fresh)}),
      .write_i(both),
      .write_address_i(program__data[71:65]),
      .write_data_i(result),
      .data_o(numbers_d_data)
  );

  wire [14:0] table__data;
  sinusoidal_control_table table_ (
      .clk(clk),
      .rst(rst),
      .address_i(result[7:0]),
      .data_o(table__data)
  );

  wire [30:0] choice_15 = program__data[38] ? result[30:0] : numbers_c_data[30:0];
  wire [15:0] choice_16 = program__data[39] ? port[15:0] : numbers_d_data[15:0];
  wire [46:0] product_next = $signed(choice_15) * $signed(choice_16);
  wire choice_17 =
      program__data[51] ? (program__data[50] ? port[0] : sum[43]) :
      program__data[50] ? result[0] :
      condition;
  wire differ = choice_17 ^ program__data[52];
  wire both_2 = program__data[40] && (!program__data[49] || differ);
  wire both_3 = program__data[43] && (!program__data[49] || !differ);
  wire [31:0] choice_18 =
      program__data[41] ? (program__data[42] ? sum[31:0] : result) : numbers_a_data;
  wire [25:0] choice_19 = program__data[45] ? {11'd0, table__data} : port;
  wire [43:0] choice_20 =
      program__data[44] ?
      (program__data[46] ? {{18{choice_19[25]}}, choice_19} :
      program__data[45] ? {{12{result[31]}}, result} :
      product[43:0]) : {{12{numbers_b_data[31]}}, numbers_b_data};
  wire [31:0] both_4 = choice_18 & {32{both_2}};
  wire [44:0] sum_2 =
      {{12{both_4[31]}}, both_4, 1'b1} +
      {(choice_20 & {44{both_3}}) ^ {44{program__data[47]}}, program__data[48]};
  wire [43:0] shifted = $signed(sum) >>> program__data[57:53];
  wire [4:0] part = program__data[62:58];
  wire either = shifted[43:17] == 27'd0 || shifted[43:17] == 27'd134217727;
  wire either_2 = shifted[43:27] == 17'd0 || shifted[43:27] == 17'd131071;

  logic [31:0] entry;  // low_bits
  always_comb begin
    case (part)
      5'd0: entry = 32'd4294967295;
      5'd1: entry = 32'd1;
      5'd2: entry = 32'd31;
      5'd3: entry = 32'd63;
      5'd4: entry = 32'd255;
      5'd5: entry = 32'd1023;
      5'd6: entry = 32'd8191;
      5'd7, 5'd10, 5'd25, 5'd26: entry = 32'd32767;
      5'd8: entry = 32'd16383;
      5'd9: entry = 32'd65535;
      5'd11, 5'd13, 5'd27: entry = 32'd131071;
      5'd12, 5'd15: entry = 32'd262143;
      5'd14, 5'd17, 5'd28: entry = 32'd524287;
      5'd16, 5'd18: entry = 32'd1048575;
      5'd19, 5'd22: entry = 32'd16777215;
      5'd20: entry = 32'd8388607;
      5'd21, 5'd23: entry = 32'd33554431;
      5'd24, 5'd29: entry = 32'd134217727;
      default: entry = 32'd0;
    endcase
  end

  wire inverse = !shifted[43];
  wire choice_21 =
      program__data[58] ? either : shifted[43:15] == 29'd0 || shifted[43:15] == 29'd536870911;
  wire choice_22 =
      program__data[58] ? either_2 : shifted[43:19] == 25'd0 || shifted[43:19] == 25'd33554431;
  wire choice_23 =
      program__data[60] ? program__data[59] || choice_22 :
      program__data[59] ? choice_21 :
      !program__data[58] || shifted[43:15] == 29'd0;
  wire [31:0] choice_24 =
      (!program__data[62] || !program__data[61] || choice_23) ? shifted[31:0] : {32{inverse}};
  wire choice_25 =
      program__data[60] ?
      (program__data[59] ? program__data[58] && shifted[18] : program__data[58] && shifted[17]) :
      program__data[59] ? !program__data[58] && shifted[15] :
      !program__data[58] && shifted[14];
  wire choice_26 =
      program__data[61] ?
      (program__data[60] ? !program__data[59] && shifted[43] :
      program__data[59] ? shifted[43] :
      !program__data[58] && shifted[27]) :
      program__data[60] ?
      (program__data[59] ? (program__data[58] ? shifted[25] : shifted[24]) :
      !program__data[58] && shifted[23]) :
      program__data[59] ? !program__data[58] && shifted[20] :
      program__data[58] && shifted[19];
  wire choice_27 =
      program__data[62] ? choice_26 :
      program__data[61] ? choice_25 :
      program__data[60] ? program__data[59] && !program__data[58] && shifted[13] :
      program__data[59] ? (program__data[58] ? shifted[6] : shifted[5]) :
      !program__data[58] && shifted[43];
  wire [27:0] both_5 = ~entry[27:0] & {28{choice_27}};
  wire [31:0] either_3 = (entry & choice_24) | {{4{both_5[27]}}, both_5};
  wire choice_28 =
      program__data[58] ? sum[43] ^ program__data[63] : (sum == 44'd0) ^ program__data[63];
  wire both_6 = program__data[59] && choice_28;
  wire [3:0] part_2 = program__data[75:72];

  always_ff @(posedge clk) begin
    if (step == 9'd0) begin
      step <= {8'd0, start_i};
    end else if (step == 9'd475) begin
      step <= 9'd0;
    end else begin
      step <= step + 9'd1;
    end
    active <= step != 9'd0;
    fresh <= fresh && step != 9'd475;
    result <=
        either_3 | {31'd0, program__data[62] && program__data[61] && program__data[60] && both_6};
    if (program__data[37]) begin
      if (program__data[36]) begin
        logic [14:0] choice_8;
        choice_8 =
            program__data[33] ? hold_voltage_i :
            program__data[32] ? control_limit_i :
            control_emf_i;
        port <= {11'd0, choice_8};
      end else if (program__data[35]) begin
        logic [14:0] choice_6;
        logic [15:0] choice_7;
        logic [15:0] wide_2;
        logic [15:0] choice_12;
        choice_6 =
            program__data[33] ? (program__data[32] ? speed_emf_high_i : speed_emf_low_i) :
            program__data[32] ? speed_stop_i :
            speed_slow_i;
        choice_7 =
            program__data[33] ? {1'b0, program__data[32] ? control_inductance_i : control_k_i_i} :
            program__data[32] ? {1'b0, control_k_p_i} :
            control_set_gamma_i;
        wide_2 = {1'b0, choice_6};
        choice_12 = program__data[34] ? choice_7 : wide_2;
        port <= {{10{choice_12[15]}}, choice_12};
      end else begin
        logic [14:0] choice_5;
        logic [24:0] choice_11;
        choice_5 =
            program__data[33] ? (program__data[32] ? speed_lock_i : speed_limit_i) :
            program__data[32] ? speed_k_i_i :
            speed_k_p_i;
        choice_11 =
            program__data[34] ? {10'd0, choice_5} :
            program__data[33] ? {10'd0, program__data[32] ? speed_filter_i : speed_slew_i} :
            program__data[32] ? speed_target_i :
            {10'd0, estimator_k_si_i};
        port <= {1'b0, choice_11};
      end
    end else begin
      logic [15:0] choice;
      logic [15:0] choice_2;
      logic [13:0] choice_3;
      logic [14:0] choice_4;
      logic choice_9;
      logic [24:0] choice_10;
      logic [14:0] wide;
      logic [14:0] choice_13;
      logic [24:0] choice_14;
      choice = program__data[32] ? a_i : {15'd0, search_i};
      choice_2 =
          program__data[33] ? {2'd0, program__data[32] ? ended_on_u_i : {2'd0, v_dc_i}} :
          program__data[32] ? i_v_i :
          i_u_i;
      choice_3 =
          program__data[33] ? (program__data[32] ? bridge_minimum_i : bridge_period_i) :
          program__data[32] ? ended_on_w_i :
          ended_on_v_i;
      choice_4 =
          program__data[33] ? (program__data[32] ? bridge_inverse_i : {14'd0, bridge_sine_i}) :
          {3'd0, program__data[32] ? {11'd0, bridge_compensate_i} : bridge_lost_i};
      choice_9 =
          program__data[34] ?
          (program__data[33] ? (program__data[32] ? pilot_i : hold_v_i) :
          program__data[32] ? hold_i :
          slow_down_i) :
          program__data[33] ? (program__data[32] ? reverse_i : locked_i) :
          program__data[32] ? regulate_i :
          estimate_i;
      choice_10 =
          program__data[34] ? {{9{choice_2[15]}}, choice_2} :
          program__data[33] ? (program__data[32] ? {1'b0, initial_i} : {{9{b_i[15]}}, b_i}) :
          {{9{choice[15]}}, choice};
      wide = {1'b0, choice_3};
      choice_13 =
          program__data[35] ?
          (program__data[34] ?
          (program__data[33] ? (program__data[32] ? estimator_k_emf_i : estimator_k_speed_i) :
          program__data[32] ? estimator_k_e_i :
          estimator_k_theta_i) :
          program__data[33] ? (program__data[32] ? estimator_gain_i : estimator_decay_i) :
          {14'd0, program__data[32] ? estimator_average_i : estimator_voltage_i}) :
          program__data[34] ? choice_4 :
          wide;
      choice_14 =
          program__data[36] ? {10'd0, choice_13} :
          program__data[35] ? choice_10 :
          {24'd0, choice_9};
      port <= {choice_14[24], choice_14};
    end
    condition <= choice_15[0];
    product <= product_next;
    sum <= sum_2[44:1];
    case (part_2)
      4'd0: ;
      4'd1: early_on_u_new <= result[13:0];
      4'd2: early_on_v_new <= result[13:0];
      4'd3: early_on_w_new <= result[13:0];
      4'd4: angle_new <= result[23:0];
      4'd5: i_gamma_new <= result[15:0];
      4'd6: i_delta_new <= result[15:0];
      4'd7: limited_new <= result[0];
      4'd8: speed_current_new <= result[15:0];
      4'd9: speed_speed_new <= result[15:0];
      4'd10: speed_reference_new <= result[15:0];
      4'd11: speed_saturated_new <= result[0];
      4'd12: speed_fast_new <= result[0];
      4'd13: speed_slow_new <= result[0];
      4'd14: speed_stopping_new <= result[0];
      default: speed_plausible_new <= result[0];
    endcase
    if (step == 9'd230) begin
      early_on_u_held <= early_on_u_new;
      early_on_v_held <= early_on_v_new;
      early_on_w_held <= early_on_w_new;
    end
    if (step == 9'd475) begin
      angle_held <= angle_new;
      i_gamma_held <= i_gamma_new;
      i_delta_held <= i_delta_new;
      limited_held <= limited_new;
      speed_current_held <= speed_current_new;
      speed_speed_held <= speed_speed_new;
      speed_reference_held <= speed_reference_new;
      speed_saturated_held <= speed_saturated_new;
      speed_fast_held <= speed_fast_new;
      speed_slow_held <= speed_slow_new;
      speed_stopping_held <= speed_stopping_new;
      speed_plausible_held <= speed_plausible_new;
    end
    done <= step == 9'd475;
    missed <= start_i && step != 9'd0;
    if (rst) begin
      step <= 9'd0;
      active <= 1'b0;
      fresh <= 1'b1;
      result <= 32'd0;
      port <= 26'd0;
      condition <= 1'b0;
      product <= 47'd0;
      sum <= 44'd0;
      early_on_u_new <= 14'd0;
      early_on_v_new <= 14'd0;
      early_on_w_new <= 14'd0;
      angle_new <= 24'd0;
      i_gamma_new <= 16'd0;
      i_delta_new <= 16'd0;
      limited_new <= 1'b0;
      speed_current_new <= 16'd0;
      speed_speed_new <= 16'd0;
      speed_reference_new <= 16'd0;
      speed_saturated_new <= 1'b0;
      speed_fast_new <= 1'b0;
      speed_slow_new <= 1'b0;
      speed_stopping_new <= 1'b0;
      speed_plausible_new <= 1'b0;
      early_on_u_held <= 14'd0;
      early_on_v_held <= 14'd0;
      early_on_w_held <= 14'd0;
      angle_held <= 24'd0;
      i_gamma_held <= 16'sd0;
      i_delta_held <= 16'sd0;
      limited_held <= 1'b0;
      speed_current_held <= 16'sd0;
      speed_speed_held <= 16'sd0;
      speed_reference_held <= 16'sd0;
      speed_saturated_held <= 1'b0;
      speed_fast_held <= 1'b0;
      speed_slow_held <= 1'b0;
      speed_stopping_held <= 1'b0;
      speed_plausible_held <= 1'b0;
      done <= 1'b0;
      missed <= 1'b0;
    end
  end

  assign early_on_u_o = early_on_u_held;
  assign early_on_v_o = early_on_v_held;
  assign early_on_w_o = early_on_w_held;
  assign angle_o = angle_held;
  assign i_gamma_o = i_gamma_held;
  assign i_delta_o = i_delta_held;
  assign limited_o = limited_held;
  assign speed_current_o = speed_current_held;
  assign speed_speed_o = speed_speed_held;
  assign speed_reference_o = speed_reference_held;
  assign speed_saturated_o = speed_saturated_held;
  assign speed_fast_o = speed_fast_held;
  assign speed_slow_o = speed_slow_held;
  assign speed_stopping_o = speed_stopping_held;
  assign speed_plausible_o = speed_plausible_held;
  assign done_o = done;
  assign busy_o = step != 9'd0;
  assign missed_o = missed;

  // What nothing reads, for the linters.
  wire unused =
      &{1'b0, bridge_dead_time_i, product[46:44], numbers_c_data[31], numbers_d_data[31:16],
      sum_2[0]};
endmodule
