// speed_control: steplock::SpeedControl, printed by hlsgen from hls/six_step/speed_control.hpp:33.
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
  localparam logic [4:0] Stage_kIdle = 5'd0;
  localparam logic [4:0] Stage_kSlew = 5'd1;
  localparam logic [4:0] Stage_kReach = 5'd2;
  localparam logic [4:0] Stage_kBemf = 5'd3;
  localparam logic [4:0] Stage_kSlip = 5'd4;
  localparam logic [4:0] Stage_kIntegral = 5'd5;
  localparam logic [4:0] Stage_kWhole = 5'd6;
  localparam logic [4:0] Stage_kWholeLow = 5'd7;
  localparam logic [4:0] Stage_kWholeHigh = 5'd8;
  localparam logic [4:0] Stage_kKeep = 5'd9;
  localparam logic [4:0] Stage_kProportional = 5'd10;
  localparam logic [4:0] Stage_kLow = 5'd11;
  localparam logic [4:0] Stage_kHigh = 5'd12;
  localparam logic [4:0] Stage_kUp = 5'd13;
  localparam logic [4:0] Stage_kDown = 5'd14;
  localparam logic [4:0] Stage_kDuty = 5'd15;
  localparam logic [4:0] Stage_kOnClocks = 5'd16;

  logic [4:0] stage;
  logic started;  // the stage's product is under way
  logic [20:0] work;  // duty on its way
  logic [27:0] reference;  // u0.32, the slewed target; for one clock it may pass it
  logic rises;  // the reference went up
  logic [33:0] integral;  // u1.31: the duty and 16 bits more
  logic [15:0] duty;
  logic [13:0] on_clocks;
  logic slips;
  logic limited;  // the current limit cut a pulse since the last integral
  logic at_high;  // integral or duty wanted to be higher than they may
  logic at_low;  // or lower

  wire either = stage == Stage_kProportional || stage == Stage_kIntegral;
  wire either_2 = either || stage == Stage_kOnClocks || stage == Stage_kBemf;
  wire [15:0] choice_62 = (stage == Stage_kOnClocks) ? duty : 16'd0;  // line 62
  wire [26:0] choice = either ? reference[26:0] : {11'd0, choice_62};
  wire [25:0] choice_65 = (stage == Stage_kOnClocks) ? 26'd0 : frequency_i;  // line 65
  wire [26:0] choice_2 = either ? ~{1'b0, frequency_i} : {1'b0, choice_65};
  wire [26:0] a = choice + choice_2;  // line 63

  logic [15:0] choice_69;  // line 69
  always_comb begin
    case (stage)
      Stage_kBemf: choice_69 = (mode_i == SpeedMode_kControl) ? words_loaded_i : words_bemf_i;
      Stage_kIntegral: choice_69 = words_ki_i;
      Stage_kProportional: choice_69 = words_kp_i;
      default: choice_69 = {2'd0, period_i};
    endcase
  end

  wire [4:0] choice_96 = stage[4] ? Stage_kIdle : stage + 5'd1;  // line 96
  wire [4:0] choice_3 =
      (stage != Stage_kBemf || mode_i == SpeedMode_kControl) ? choice_96 : Stage_kHigh;

  wire [42:0] multiplier_product;
  wire multiplier_done;
  wire unused_multiplier_busy;
  serial_multiplier_27_16 multiplier (
      .clk(clk),
      .rst(rst),
      .start_i(either_2 && !started),
      .a_i(a),
      .b_i(choice_69),
      .shift_i((stage == Stage_kOnClocks) ? 4'd0 : words_shift_i),
      .product_o(multiplier_product),
      .done_o(multiplier_done),
      .busy_o(unused_multiplier_busy)
  );

  logic [4:0] stage_next;
  always_comb begin
    case (stage)
      Stage_kProportional, Stage_kIntegral, Stage_kOnClocks, Stage_kBemf: stage_next =
          multiplier_done ? choice_3 : stage;
      Stage_kIdle: stage_next = tick_i ? Stage_kSlew : stage;
      default: stage_next =
          (stage != Stage_kHigh || mode_i == SpeedMode_kControl) ? choice_96 : Stage_kDuty;
    endcase
  end

  logic started_next;
  always_comb begin
    case (stage)
      Stage_kProportional, Stage_kIntegral, Stage_kOnClocks, Stage_kBemf: started_next =
          !multiplier_done;
      default: started_next = started;
    endcase
  end

  wire [20:0] base = {{3{integral[33]}}, integral[33:16]};  // line 113
  wire [15:0] choice_127 = (mode_i == SpeedMode_kControl) ? slip_i : fixed_duty_i;  // line 127
  wire either_127 = stage == Stage_kProportional || stage == Stage_kWhole;  // line 127
  wire [17:0] base_2 = either_127 ? integral[33:16] : {2'd0, choice_127};  // line 127
  wire [20:0] base_3 = {{3{base_2[17]}}, base_2};  // line 127
  wire [19:0] choice_117 =  // line 117
      (mode_i == SpeedMode_kFixed || stage == Stage_kWhole) ? 20'd0 : multiplier_product[31:12];
  wire both = multiplier_done && !(stage == Stage_kIntegral || stage == Stage_kOnClocks);
  wire [20:0] choice_4 = both ? base_3 + {choice_117[19], choice_117} : work;
  wire [12:0] slew = ~{1'b0, words_duty_slew_i};  // line 191
  wire [12:0] slew_2 =  // line 135
      (stage == Stage_kUp) ? {1'b0, words_duty_slew_i} :
      (stage == Stage_kDown) ? slew :
      13'd0;
  wire [17:0] slew_3 = {{5{slew_2[12]}}, slew_2};  // line 135
  wire [17:0] limit = slew_3 + {2'd0, duty};  // line 193

  logic [17:0] limit_2;  // line 135
  always_comb begin
    case (stage)
      Stage_kWholeLow, Stage_kLow: limit_2 = {2'd0, words_minimum_i};
      Stage_kWholeHigh, Stage_kHigh: limit_2 = {2'd0, words_maximum_i};
      default: limit_2 = limit;
    endcase
  end

  wire [20:0] wide_136 = {{3{limit_2[17]}}, limit_2};  // line 136
  wire below_136 = $signed(work) < $signed(wide_136);  // line 136
  wire both_76 =  // line 76
      (stage == Stage_kWholeLow || stage == Stage_kLow || stage == Stage_kDown) && below_136;
  wire either_76 = stage == Stage_kWholeHigh || stage == Stage_kHigh || stage == Stage_kUp;
  wire both_76_2 = either_76 && $signed(wide_136) <= $signed(work);  // line 76

  logic [20:0] work_next;
  always_comb begin
    case (stage)
      Stage_kProportional, Stage_kIntegral, Stage_kOnClocks, Stage_kBemf: work_next = choice_4;
      Stage_kWhole: work_next = base;
      default: work_next = (both_76 || both_76_2) ? wide_136 : work;
    endcase
  end

  wire [25:0] goal = (mode_i == SpeedMode_kControl) ? target_i : frequency_i;  // line 148
  wire below_149 = $signed(reference) < $signed({2'd0, goal});  // line 149
  wire at_most_151 = $signed({2'd0, goal}) <= $signed(reference);  // line 151
  wire [20:0] slew_4 = {1'b0, words_slew_i} ^ {21{at_most_151}};  // line 151
  wire [27:0] slew_5 = {{7{slew_4[20]}}, slew_4};  // line 151
  wire both_2 = stage == Stage_kReach && (mode_i != SpeedMode_kControl || (below_149 ^ rises));

  logic [27:0] reference_next;
  logic rises_next;
  always_comb begin
    case (stage)
      Stage_kProportional, Stage_kIntegral, Stage_kOnClocks, Stage_kBemf, Stage_kIdle: begin
        reference_next = reference;
        rises_next = rises;
      end
      Stage_kSlew: begin
        reference_next = reference + slew_5;
        rises_next = below_149;
      end
      default: begin
        reference_next = both_2 ? {2'd0, goal} : reference;
        rises_next = rises;
      end
    endcase
  end

  wire choice_122 = multiplier_product[31] ? at_low : at_high || limited;  // line 122
  wire both_3 = multiplier_done && stage == Stage_kIntegral && !choice_122;
  wire [33:0] choice_5 =
      both_3 ? integral + {{2{multiplier_product[31]}}, multiplier_product[31:0]} : integral;
  wire [33:0] joined_166 = {work[17:0], 16'd0};  // line 166

  logic [33:0] integral_next;
  always_comb begin
    case (stage)
      Stage_kProportional, Stage_kIntegral, Stage_kOnClocks, Stage_kBemf: integral_next = choice_5;
      Stage_kIdle: integral_next = integral;
      Stage_kKeep: integral_next = (at_low || at_high) ? joined_166 : integral;
      default: integral_next =
          (stage == Stage_kDuty && mode_i != SpeedMode_kControl) ? joined_166 : integral;
    endcase
  end

  wire [15:0] part_169 = work[15:0];  // line 169

  logic [15:0] duty_next;
  always_comb begin
    case (stage)
      Stage_kDuty: duty_next = part_169;
      default: duty_next = duty;
    endcase
  end

  logic slips_next;
  always_comb begin
    case (stage)
      Stage_kSlip: slips_next = below_136;
      Stage_kDuty: slips_next = mode_i == SpeedMode_kControl && slips;
      default: slips_next = slips;
    endcase
  end

  logic at_high_next;
  logic at_low_next;
  always_comb begin
    case (stage)
      Stage_kProportional, Stage_kIntegral, Stage_kOnClocks, Stage_kBemf, Stage_kIdle: begin
        at_high_next = at_high;
        at_low_next = at_low;
      end
      default: begin
        at_high_next = (stage != Stage_kWhole && at_high) || both_76_2;
        at_low_next = (stage != Stage_kWhole && at_low) || both_76;
      end
    endcase
  end

  always_ff @(posedge clk) begin
    if (rst) begin
      stage <= Stage_kIdle;
      started <= 1'b0;
      work <= 21'sd0;
      reference <= 28'sd0;
      rises <= 1'b0;
      integral <= 34'sd0;
      duty <= 16'd0;
      on_clocks <= 14'd0;
      slips <= 1'b0;
      limited <= 1'b0;
      at_high <= 1'b0;
      at_low <= 1'b0;
    end else begin
      stage <= stage_next;
      started <= started_next;
      work <= work_next;
      reference <= reference_next;
      rises <= rises_next;
      integral <= integral_next;
      duty <= duty_next;
      if (either_2 && multiplier_done && stage == Stage_kOnClocks) begin
        on_clocks <= multiplier_product[28:15];
      end
      slips <= slips_next;
      limited <=
          limited_i ||
          (limited && !(stage == Stage_kIntegral && multiplier_done) &&
          mode_i == SpeedMode_kControl);
      at_high <= at_high_next;
      at_low <= at_low_next;
    end
  end

  assign duty_o = duty;
  assign on_clocks_o = on_clocks;
  assign slips_o = slips;

  // What nothing reads, for the linters.
  wire unused = &{1'b0, words_target_i, multiplier_product[42:32]};
endmodule
