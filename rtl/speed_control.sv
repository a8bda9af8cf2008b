// speed_control: steplock::SpeedControl, printed by hlsgen from hls/six_step/speed_control.hpp:36.
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
  logic [20:0] work;  // duty on its way; 0 while idle; from kSlew to kReach the slew
  logic [27:0] reference;  // u0.32, the slewed target
  logic rises;  // the reference went up
  logic [33:0] integral;  // u1.31: the duty and 16 bits more
  logic [15:0] duty;
  logic [13:0] on_clocks;
  logic slips;
  logic limited;  // the current limit cut a pulse since the last integral
  logic at_high;  // integral or duty wanted to be higher than they may
  logic at_low;  // or lower

  wire either = stage == Stage_kProportional || stage == Stage_kIntegral;
  wire [15:0] choice_106 = (stage == Stage_kOnClocks) ? duty : 16'd0;  // line 106
  wire [26:0] choice_63 = either ? reference[26:0] : {11'd0, choice_106};  // line 63
  wire [25:0] choice_109 = (stage == Stage_kOnClocks) ? 26'd0 : frequency_i;  // line 109
  wire [26:0] choice_63_2 = either ? ~{1'b0, frequency_i} : {1'b0, choice_109};  // line 63

  logic [15:0] choice_64;  // line 64
  always_comb begin
    case (stage)
      Stage_kBemf: choice_64 = (mode_i == SpeedMode_kControl) ? words_loaded_i : words_bemf_i;
      Stage_kIntegral: choice_64 = words_ki_i;
      Stage_kProportional: choice_64 = words_kp_i;
      default: choice_64 = {2'd0, period_i};
    endcase
  end

  wire [42:0] multiplier_product;
  wire multiplier_done;
  wire unused_multiplier_busy;
  serial_multiplier_27_16 multiplier (
      .clk(clk),
      .rst(rst),
      .start_i((either || stage == Stage_kOnClocks || stage == Stage_kBemf) && !started),
      .a_i(choice_63 + choice_63_2),
      .b_i(choice_64),
      .shift_i((stage == Stage_kOnClocks) ? 4'd0 : words_shift_i),
      .product_o(multiplier_product),
      .done_o(multiplier_done),
      .busy_o(unused_multiplier_busy)
  );

  wire [33:0] joined_180 = {work[17:0], 16'd0};  // line 180

  always_ff @(posedge clk) begin
    case (stage)
      Stage_kIdle: begin
        if (tick_i) begin
          stage <= Stage_kSlew;
        end
      end
      Stage_kSlew, Stage_kReach: begin
        logic [27:0] moved;
        logic [25:0] goal;
        logic below_164;
        moved = reference + {{7{work[20]}}, work};  // line 163
        goal = (mode_i == SpeedMode_kControl) ? target_i : frequency_i;  // line 161
        below_164 = $signed(moved) < $signed({2'd0, goal});  // line 164
        case (stage)
          Stage_kSlew: begin
            stage <= stage + 5'd1;
            if (below_164) begin
              work <= {1'b0, words_slew_i};
            end else begin
              work <= ~{1'b0, words_slew_i};
            end
            rises <= below_164;
          end
          default: begin  // Stage_kReach
            stage <= stage + 5'd1;
            if (mode_i == SpeedMode_kControl && !(below_164 ^ rises)) begin
              reference <= moved;
            end else begin
              reference <= {2'd0, goal};
            end
          end
        endcase
      end
      Stage_kBemf, Stage_kProportional: begin
        logic [15:0] choice_140;
        logic either_140;
        logic [17:0] base;
        logic [20:0] base_2;
        logic [19:0] choice_130;
        logic [20:0] sum_130;
        choice_140 = (mode_i == SpeedMode_kControl) ? slip_i : fixed_duty_i;  // line 140
        either_140 = stage == Stage_kProportional || stage == Stage_kWhole;  // line 140
        base = either_140 ? integral[33:16] : {2'd0, choice_140};  // line 140
        base_2 = {{3{base[17]}}, base};  // line 140
        choice_130 =  // line 130
            (mode_i == SpeedMode_kFixed || stage == Stage_kWhole) ? 20'd0 :
            multiplier_product[31:12];
        sum_130 = base_2 + {choice_130[19], choice_130};  // line 130
        case (stage)
          Stage_kBemf: begin
            if (multiplier_done) begin
              if (mode_i == SpeedMode_kControl) begin
                stage <= stage + 5'd1;
              end else begin
                stage <= Stage_kHigh;
              end
              work <= sum_130;
            end
            started <= !multiplier_done;
          end
          default: begin  // Stage_kProportional
            if (multiplier_done) begin
              stage <= stage + 5'd1;
              work <= sum_130;
            end
            started <= !multiplier_done;
          end
        endcase
      end
      Stage_kSlip, Stage_kWholeLow, Stage_kLow, Stage_kWholeHigh, Stage_kHigh, Stage_kUp,
      Stage_kDown: begin
        logic [17:0] limit;
        logic [17:0] limit_2;
        logic [12:0] slew;
        logic [12:0] choice_148;
        logic [12:0] slew_2;
        logic [17:0] slew_3;
        logic [17:0] limit_3;
        logic [17:0] limit_4;  // line 148
        logic [20:0] wide_149;
        logic below_149;
        logic at_most_153;
        logic either_192;
        logic [20:0] wide_149_2;
        logic either_193;
        logic [20:0] wide_149_3;
        limit = {2'd0, words_minimum_i};  // line 200
        limit_2 = {2'd0, words_maximum_i};  // line 202
        slew = ~{1'b0, words_duty_slew_i};  // line 208
        choice_148 = (stage == Stage_kDown || stage == Stage_kUp) ? slew : 13'd0;  // line 148
        slew_2 = (stage != Stage_kUp || hurries_i) ? choice_148 : {1'b0, words_duty_slew_i};
        slew_3 = {{5{slew_2[12]}}, slew_2};  // line 148
        limit_3 = slew_3 + {2'd0, duty};  // line 210
        case (stage)
          Stage_kWholeLow, Stage_kLow: limit_4 = limit;
          Stage_kWholeHigh, Stage_kHigh: limit_4 = limit_2;
          default: limit_4 = limit_3;
        endcase
        wide_149 = {{3{limit_4[17]}}, limit_4};  // line 149
        below_149 = $signed(work) < $signed(wide_149);  // line 149
        at_most_153 = $signed(wide_149) <= $signed(work);  // line 153
        either_192 = at_low || below_149;  // line 192
        wide_149_2 = {{3{limit_2[17]}}, limit_2};  // line 149
        either_193 = at_high || at_most_153;  // line 193
        wide_149_3 = {{3{limit_3[17]}}, limit_3};  // line 149
        case (stage)
          Stage_kSlip: begin
            stage <= stage + 5'd1;
            slips <= below_149;
          end
          Stage_kWholeLow, Stage_kLow: begin
            stage <= stage + 5'd1;
            if (below_149) begin
              work <= {{3{limit[17]}}, limit};
            end
            at_low <= either_192;
          end
          Stage_kWholeHigh: begin
            stage <= stage + 5'd1;
            if (at_most_153) begin
              work <= wide_149_2;
            end
            at_high <= either_193;
          end
          Stage_kHigh: begin
            if (mode_i == SpeedMode_kControl) begin
              stage <= stage + 5'd1;
            end else begin
              stage <= Stage_kDuty;
            end
            if (at_most_153) begin
              work <= wide_149_2;
            end
            at_high <= either_193;
          end
          Stage_kUp: begin
            stage <= stage + 5'd1;
            if (at_most_153) begin
              work <= wide_149_3;
            end
            at_high <= either_193;
          end
          default: begin  // Stage_kDown
            stage <= stage + 5'd1;
            if (below_149) begin
              work <= wide_149_3;
            end
            at_low <= either_192;
          end
        endcase
      end
      Stage_kIntegral: begin
        if (multiplier_done) begin
          stage <= stage + 5'd1;
          if (!(multiplier_product[31] ? at_low : at_high || limited)) begin
            integral <= integral + {{2{multiplier_product[31]}}, multiplier_product[31:0]};
          end
        end
        started <= !multiplier_done;
      end
      Stage_kWhole: begin
        stage <= stage + 5'd1;
        work <= {{3{integral[33]}}, integral[33:16]};
        at_high <= 1'b0;
        at_low <= 1'b0;
      end
      Stage_kKeep: begin
        stage <= stage + 5'd1;
        if (at_low || at_high) begin
          integral <= joined_180;
        end
      end
      Stage_kDuty: begin
        stage <= stage + 5'd1;
        work <= 21'd0;
        if (mode_i != SpeedMode_kControl) begin
          integral <= joined_180;
        end
        duty <= work[15:0];
        slips <= mode_i == SpeedMode_kControl && slips;
      end
      Stage_kOnClocks: begin
        if (multiplier_done) begin
          stage <= Stage_kIdle;
          on_clocks <= multiplier_product[28:15];
        end
        started <= !multiplier_done;
      end
      default: stage <= Stage_kIdle;
    endcase
    limited <=
        limited_i ||
        (limited && !(stage == Stage_kIntegral && multiplier_done) && mode_i == SpeedMode_kControl);
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
    end
  end

  assign duty_o = duty;
  assign on_clocks_o = on_clocks;
  assign slips_o = slips;

  // What nothing reads, for the linters.
  wire unused = &{1'b0, words_target_i, multiplier_product[42:32]};
endmodule
