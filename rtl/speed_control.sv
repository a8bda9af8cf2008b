// speed_control: steplock::SpeedControl, printed by hlsgen from hls/six_step/speed_control.hpp:37.
// Do not edit: change the C++ and print again.

module speed_control (
    input  logic        clk,
    input  logic        rst,  // synchronous, active high
    input  logic        tick_i,  // starts one update
    input  logic [1:0]  mode_i,  // where the duty comes from
    input  logic [15:0] fixed_duty_i,  // u1.15, for kFixed and kAboveBemf
    input  logic [25:0] frequency_i,  // u0.32, VCO turns per clock
    input  logic [25:0] target_i,  // u0.32, VCO turns per clock
    input  logic        limited_i,  // strobe: the current limit cut the pulse
    input  logic        hurries_i,  // freewheeling just hid the crossing of a rotor that leads
    input  logic [13:0] period_i,  // clocks per PWM period
    input  logic [15:0] slip_i,  // u1.15, above what speed and commutation take
    input  logic [25:0] words_target_i,  // u0.32
    input  logic [19:0] words_slew_i,  // u0.32 per tick
    input  logic [3:0]  words_shift_i,  // speeds are normalised: frequency >> shift fits 15 bits
    input  logic [15:0] words_kp_i,  // u4.12: duty per normalised speed error (s1.15 against u1.15)
    input  logic [15:0] words_ki_i,  // u0.16 per tick
    input  logic [15:0] words_bemf_i,  // u4.12: duty of mean voltage equal to the back-EMF, per speed
    input  logic [15:0] words_loaded_i,  // u4.12: the same, and of commutating the largest current
    input  logic [15:0] words_minimum_i,
    input  logic [15:0] words_maximum_i,
    input  logic [11:0] words_duty_slew_i,  // u1.15 per tick
    output logic [15:0] duty_o,  // u1.15
    output logic [13:0] on_clocks_o,  // clocks of on-time per period
    output logic        slips_o  // in speed control: more than slip above what the speed takes
);
  localparam logic [1:0] SpeedMode_kFixed = 2'd0;
  localparam logic [1:0] SpeedMode_kControl = 2'd2;

  logic [16:0] at_bits;  // public, for a set to be a port
  logic of_error;  // the product is the error's: kIntegral or kProportional
  logic starts;  // this is the first clock of a product
  logic control;  // the mode is kControl
  logic whole;  // the sum to come is the integral
  logic alone;  // and without a product
  logic [20:0] work;  // duty on its way
  logic clears;  // the integral is cleared, before it takes the work
  logic adds;  // it takes the addend
  logic [33:0] addend;  // the product, or the work
  logic [16:0] moved;  // the duty, one slew further
  logic [16:0] not_limit;  // complement of what this stage compares with
  logic [27:0] reference;  // u0.32, the slewed target
  logic [26:0] not_target;  // complement of the target, a clock ago
  logic passes;  // the reference passed it
  logic falls;  // it goes down: a flip-flop of its own, for want of time to ask !rises_
  logic rises;  // the reference went up
  logic [33:0] integral;  // u1.31: the duty and 16 bits more
  logic [15:0] duty;
  logic [13:0] on_clocks;
  logic slips;
  logic limited;  // the current limit cut a pulse since the last integral
  logic sums;  // this clock takes a sum
  logic low;  // it takes something where the work is below the bound
  logic high;  // it does where it is not
  logic low_was;  // a bound in the last clock, that is
  logic high_was;
  logic below;  // which found less
  logic at_high;  // integral or duty wanted to be higher than they may
  logic at_low;  // or lower

  wire [26:0] choice_112 = of_error ? reference[26:0] : {11'd0, at_bits[16] ? duty : 16'd0};
  wire [26:0] choice_115 =  // line 115
      of_error ? ~{1'b0, frequency_i} : {1'b0, at_bits[16] ? 26'd0 : frequency_i};
  wire [16:0] joined_84 = {at_bits[15:0], at_bits[16]};  // line 84
  wire [16:0] choice =
      control ? joined_84 :
      at_bits[3] ? 17'd4096 :
      at_bits[12] ? 17'd32768 :
      joined_84;

  wire [42:0] multiplier_product;
  wire multiplier_done;
  wire unused_multiplier_busy;
  wire multiplier_ends;
  serial_multiplier_27_16 multiplier (
      .clk(clk),
      .rst(rst),
      .start_i(starts),
      .a_i(choice_112 + choice_115),
      .b_i(at_bits[3] ? (control ? words_loaded_i : words_bemf_i) :
        at_bits[5] ? words_ki_i :
        at_bits[10] ? words_kp_i :
        {2'd0, period_i}),
      .shift_i(at_bits[16] ? 4'd0 : words_shift_i),
      .product_o(multiplier_product),
      .done_o(multiplier_done),
      .busy_o(unused_multiplier_busy),
      .ends_o(multiplier_ends)
  );

  wire [21:0] sum_157 = {1'b0, work ^ 21'h100000} + {5'd7, not_limit} + 22'd1;  // line 157
  wire either_158 = at_high || (high_was && !below);  // line 158
  wire both_67 = !(!at_bits[3] && !at_bits[5]) && at_bits[5];  // line 67
  wire [15:0] duty_next = at_bits[15] ? work[15:0] : duty;  // line 175
  wire either_211 = !at_bits[11] || hurries_i;  // line 211
  wire [12:0] differ_211 = {1'b0, words_duty_slew_i} ^ {13{either_211}};  // line 211
  wire [17:0] moved_2 = {2'd0, duty_next} + {{5{differ_211[12]}}, differ_211};  // line 211
  wire both_183 = !at_bits[8] && !at_bits[11] && (control || !at_bits[3]);  // line 183
  wire [16:0] choice_183 =  // line 183
      both_183 ? ((!at_bits[12] && !at_bits[13]) ? {1'b0, duty_next} : moved) :
      {1'b0, words_maximum_i};
  wire [16:0] choice_183_2 =  // line 183
      ((at_bits[10:7] & 4'h9) == 4'd0) ? choice_183 : {1'b0, words_minimum_i};
  wire [28:0] sum_129 = {1'b0, reference ^ 28'h8000000} + {2'd0, not_target} + 29'd1;  // line 129
  wire either_191 = at_bits[6] || !multiplier_ends;  // line 191
  wire choice_191 = either_191 ? at_bits[6] : at_bits[10];  // line 191
  wire inverse = !(either_191 || !at_bits[3]);
  wire sums_next = inverse || choice_191;
  wire choice_192 = (at_bits[13] || !multiplier_done) ? at_bits[13] : at_bits[10];  // line 192
  wire either = (control && at_bits[12]) || (multiplier_done && !control && at_bits[3]);

  always_ff @(posedge clk) begin
    if (at_bits[0]) begin
      if (tick_i) begin
        at_bits <= choice;
      end
      falls <= sum_129[28];
      rises <= !sum_129[28];
    end else if ((!(of_error || at_bits[16]) && !at_bits[3]) || multiplier_done) begin
      at_bits <= choice;
    end
    of_error <= at_bits[4] || at_bits[9] || (of_error && !multiplier_done);
    starts <= (at_bits[15:2] & 14'h2085) != 14'd0;  // line 79
    control <= mode_i == SpeedMode_kControl;  // line 77
    whole <= (at_bits[10:6] & 5'h11) != 5'd0;  // line 75
    alone <= mode_i == SpeedMode_kFixed || at_bits[6];  // line 76
    if (sum_157[21] ? high : low) begin
      if (sums) begin
        logic [17:0] base;
        logic [20:0] base_2;
        logic [19:0] choice_150;
        base = whole ? integral[33:16] : {2'd0, control ? slip_i : fixed_duty_i};  // line 149
        base_2 = {{3{base[17]}}, base};  // line 149
        choice_150 = alone ? 20'd0 : multiplier_product[31:12];  // line 150
        work <= base_2 + {choice_150[19], choice_150};
      end else begin
        work <= {4'd0, ~not_limit};
      end
    end
    clears <= (at_bits[10] && starts && (at_low || either_158)) || (at_bits[15] && !control);
    if (clears) begin
      adds <= 1'b1;
      addend <= {work[17:0], 16'd0};
      integral <= 34'd0;
    end else begin
      if (multiplier_done) begin
        logic choice_168;
        choice_168 = multiplier_product[31] ? at_low : at_high || limited;  // line 168
        adds <= both_67 && !choice_168;
        addend <= {{2{multiplier_product[31]}}, multiplier_product[31:0]};
      end else begin
        adds <= 1'b0;
      end
      if (adds) begin
        integral <= integral + addend;
      end
    end
    if (moved_2[17]) begin
      moved <= 17'd0;
    end else begin
      moved <= moved_2[16:0];
    end
    not_limit <= ~choice_183_2;  // line 183
    if (at_bits[1]) begin
      logic [20:0] moved_3;
      moved_3 = {1'b0, rises ? words_slew_i : 20'd0} | (falls ? ~{1'b0, words_slew_i} : 21'd0);
      reference <= reference + {{7{moved_3[20]}}, moved_3};
    end else if (!at_bits[2] || control) begin
      if (passes) begin
        reference <= {2'd0, ~not_target[25:0]};
      end
    end else begin
      reference <= {2'd0, frequency_i};
    end
    not_target <= ~{1'b0, target_i};  // line 145
    passes <= at_bits[2] && control && (rises ^ !sum_129[28]);  // line 140
    duty <= duty_next;  // line 175
    if (multiplier_done && at_bits[16]) begin
      on_clocks <= multiplier_product[28:15];
    end
    slips <= (!at_bits[15] || control) && (at_bits[4] ? !sum_157[21] : slips);  // line 175
    if (limited_i || !limited) begin
      limited <= limited_i;
    end else begin
      limited <= !(both_67 && multiplier_done) && control;
    end
    sums <= sums_next;
    low <= inverse || choice_191 || at_bits[7] || choice_192;
    high <= sums_next || (at_bits[11:8] & 4'h9) != 4'd0 || either;
    low_was <= low && !sums;  // line 189
    high_was <= high && !sums;  // line 190
    below <= !sum_157[21];  // line 157
    at_high <= !at_bits[7] && either_158;  // line 181
    at_low <= !at_bits[7] && (at_low || (low_was && below));  // line 73
    if (rst) begin
      at_bits <= 17'd1;
      of_error <= 1'b0;
      starts <= 1'b0;
      control <= 1'b0;
      whole <= 1'b0;
      alone <= 1'b0;
      work <= 21'sd0;
      clears <= 1'b0;
      adds <= 1'b0;
      addend <= 34'sd0;
      moved <= 17'd0;
      not_limit <= 17'd0;
      reference <= 28'sd0;
      not_target <= 27'd134217727;
      passes <= 1'b0;
      falls <= 1'b0;
      rises <= 1'b0;
      integral <= 34'sd0;
      duty <= 16'd0;
      on_clocks <= 14'd0;
      slips <= 1'b0;
      limited <= 1'b0;
      sums <= 1'b0;
      low <= 1'b0;
      high <= 1'b0;
      low_was <= 1'b0;
      high_was <= 1'b0;
      below <= 1'b0;
      at_high <= 1'b0;
      at_low <= 1'b0;
    end
  end

  assign duty_o = duty;
  assign on_clocks_o = on_clocks;
  assign slips_o = slips;

  // What nothing reads, for the linters.
  wire unused = &{1'b0, words_target_i, multiplier_product[42:32], sum_157[20:0], sum_129[27:0]};
endmodule
