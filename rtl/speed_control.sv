// speed_control: steplock::SpeedControl, printed by hlsgen from hls/six_step/speed_control.hpp:30.
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
    input  logic [25:0] words_target_i,  // u0.32
    input  logic [19:0] words_slew_i,  // u0.32 per tick
    input  logic [3:0]  words_shift_i,  // speeds are normalised: frequency >> shift fits 15 bits
    input  logic [15:0] words_kp_i,  // u4.12: duty per normalised speed error (s1.15 against u1.15)
    input  logic [15:0] words_ki_i,  // u0.16 per tick
    input  logic [15:0] words_bemf_i,  // u4.12: duty whose mean voltage equals the back-EMF, per normalised speed
    input  logic [15:0] words_minimum_i,
    input  logic [15:0] words_maximum_i,
    input  logic [11:0] words_duty_slew_i,  // u1.15 per tick
    output logic [15:0] duty_o,  // u1.15
    output logic [15:0] bemf_duty_o,  // u1.15, mean voltage equal to the back-EMF
    output logic [13:0] on_clocks_o  // clocks of on-time per period
);
  localparam logic [1:0] SpeedMode_kAboveBemf = 2'd1;
  localparam logic [1:0] SpeedMode_kControl = 2'd2;
  localparam logic [2:0] Stage_kIdle = 3'd0;
  localparam logic [2:0] Stage_kBemf = 3'd1;
  localparam logic [2:0] Stage_kIntegral = 3'd2;
  localparam logic [2:0] Stage_kProportional = 3'd3;
  localparam logic [2:0] Stage_kOnClocks = 3'd4;

  logic [2:0] stage;
  logic started;  // the stage's product is under way
  logic [3:0] shifts;  // still to do, one a clock: cheaper than a barrel shifter
  logic [26:0] operand;  // speed, speed error or duty
  logic [25:0] reference;  // u0.32, the slewed target
  logic [31:0] integral;  // u1.31: the duty and 16 bits more
  logic [15:0] duty;
  logic [15:0] bemf_duty;
  logic [13:0] on_clocks;
  logic limited;  // the current limit cut a pulse since the last tick
  logic at_high;  // the duty wanted to be higher than it may
  logic at_low;

  wire [26:0] choice_54 = ($signed(operand) < 27'sd65535) ? operand : 27'd65535;  // line 54

  logic [15:0] choice_55;
  logic [2:0] choice;
  always_comb begin
    case (stage)
      Stage_kBemf: begin
        choice_55 = words_bemf_i;
        choice = (mode_i == SpeedMode_kControl) ? Stage_kIntegral : Stage_kOnClocks;
      end
      Stage_kIntegral: begin
        choice_55 = words_ki_i;
        choice = Stage_kProportional;
      end
      Stage_kProportional: begin
        choice_55 = words_kp_i;
        choice = Stage_kOnClocks;
      end
      default: begin
        choice_55 = {2'd0, period_i};
        choice = Stage_kIdle;
      end
    endcase
  end

  wire [32:0] multiplier_product;
  wire multiplier_done;
  wire unused_multiplier_busy;
  serial_multiplier_17_16 multiplier (
      .clk(clk),
      .rst(rst),
      .start_i(stage != Stage_kIdle && shifts == 4'd0 && !started),
      .a_i(($signed(choice_54) < -27'sd65536) ? 17'd65536 : choice_54[16:0]),
      .b_i(choice_55),
      .product_o(multiplier_product),
      .done_o(multiplier_done),
      .busy_o(unused_multiplier_busy)
  );

  wire both = started && multiplier_done;
  wire both_2 = shifts == 4'd0 && both;
  wire [21:0] wide_130 = {multiplier_product[32], multiplier_product[32:12]};  // line 130
  wire [21:0] sum = {6'd0, fixed_duty_i} + wide_130;  // line 130
  wire [15:0] duty_2 =  // line 112
      (mode_i == SpeedMode_kAboveBemf) ? (($signed({6'd0, words_maximum_i}) < $signed(sum)) ?
      words_maximum_i : sum[15:0]) : fixed_duty_i;
  wire [15:0] moved = duty + {4'd0, words_duty_slew_i};  // line 166
  wire [15:0] moved_2 = duty - {4'd0, words_duty_slew_i};  // line 167
  wire [21:0] wanted = {6'd0, integral[31:16]} + wide_130;  // line 157
  wire below_158 = $signed(wanted) < $signed({6'd0, words_minimum_i});  // line 158
  wire below_158_2 = $signed({6'd0, words_maximum_i}) < $signed(wanted);  // line 158
  wire [15:0] bounded =  // line 158
      below_158 ? words_minimum_i :
      below_158_2 ? words_maximum_i : wanted[15:0];
  wire [16:0] move = {1'b0, bounded} - {1'b0, duty};  // line 161
  wire [17:0] sum_163 = {move[16], move} + {6'd0, words_duty_slew_i};  // line 163
  wire below_162 = $signed({5'd0, words_duty_slew_i}) < $signed(move);  // line 162
  wire [15:0] moved_3 =  // line 120
      below_162 ? moved :
      sum_163[17] ? moved_2 : bounded;
  wire [26:0] distance = {1'b0, target_i} - {1'b0, reference};  // line 89
  wire [27:0] sum_92 = {distance[26], distance} + {8'd0, words_slew_i};  // line 92
  wire [33:0] sum_2 = {2'd0, integral} + {multiplier_product[32], multiplier_product};  // line 151
  wire [31:0] highest = {words_maximum_i, 16'd0};  // line 152
  wire either_56 = limited_i || limited;  // line 56
  wire choice_148 = operand[26] ? at_low : at_high || either_56;  // line 148
  wire both_3 =
      multiplier_done && !(stage == Stage_kBemf || stage == Stage_kIntegral || stage ==
      Stage_kProportional);

  always_ff @(posedge clk) begin
    if (rst) begin
      stage <= Stage_kIdle;
      started <= 1'b0;
      shifts <= 4'd0;
      operand <= 27'sd0;
      reference <= 26'd0;
      integral <= 32'd0;
      duty <= 16'd0;
      bemf_duty <= 16'd0;
      on_clocks <= 14'd0;
      limited <= 1'b0;
      at_high <= 1'b0;
      at_low <= 1'b0;
    end else begin
      if (stage == Stage_kIdle) begin
        stage <= {2'd0, tick_i};
        if (tick_i) begin
          shifts <= words_shift_i;
          operand <= {1'b0, frequency_i};
        end
        limited <= either_56;
      end else begin
        if (both_2) begin
          stage <= choice;
          if (stage == Stage_kBemf) begin
            if (mode_i != SpeedMode_kControl) begin
              integral <= {duty_2, 16'd0};
              duty <= duty_2;
            end
            limited <= mode_i == SpeedMode_kControl && either_56;
            at_high <= mode_i == SpeedMode_kControl && at_high;
            at_low <= mode_i == SpeedMode_kControl && at_low;
          end else begin
            if (stage == Stage_kIntegral && !choice_148) begin
              if (sum_2[33]) begin
                integral <= 32'd0;
              end else if ({2'd0, highest} < sum_2) begin
                integral <= highest;
              end else begin
                integral <= sum_2[31:0];
              end
            end
            if (stage == Stage_kProportional) begin
              duty <= moved_3;
              at_high <= below_162 || below_158_2;
              at_low <= sum_163[17] || below_158;
            end
            limited <= stage != Stage_kIntegral && either_56;
          end
        end else begin
          limited <= either_56;
        end
        if (shifts == 4'd0) begin
          started <= !started || !multiplier_done;
          if (started && multiplier_done && stage == Stage_kBemf && mode_i ==
              SpeedMode_kControl) begin
            shifts <= words_shift_i;
          end else begin
            shifts <= 4'd0;
          end
          if (both) begin
            if (stage == Stage_kBemf) begin
              if (mode_i == SpeedMode_kControl) begin
                operand <= {1'b0, reference} - {1'b0, frequency_i};
              end else begin
                operand <= {11'd0, duty_2};
              end
            end else if (stage == Stage_kProportional) begin
              operand <= {11'd0, moved_3};
            end
          end
        end else begin
          shifts <= shifts - 4'd1;
          operand <= {operand[26], operand[26:1]};
        end
        if (shifts == 4'd0 && started && multiplier_done && stage == Stage_kBemf) begin
          if (multiplier_product[32]) begin
            bemf_duty <= 16'd0;
          end else if ($signed(multiplier_product) > 33'sd268435455) begin
            bemf_duty <= 16'd65535;
          end else begin
            bemf_duty <= multiplier_product[27:12];
          end
        end
        if (shifts == 4'd0 && started && both_3) begin
          if (multiplier_product[32]) begin
            on_clocks <= 14'd0;
          end else if (multiplier_product > 33'd536870911) begin
            on_clocks <= 14'd16383;
          end else begin
            on_clocks <= multiplier_product[28:15];
          end
        end
      end
      if (stage == Stage_kIdle && tick_i) begin
        if (mode_i == SpeedMode_kControl) begin
          if ($signed({7'd0, words_slew_i}) < $signed(distance)) begin
            reference <= reference + {6'd0, words_slew_i};
          end else if (sum_92[27]) begin
            reference <= reference - {6'd0, words_slew_i};
          end else begin
            reference <= target_i;
          end
        end else begin
          reference <= frequency_i;
        end
      end
    end
  end

  assign duty_o = duty;
  assign bemf_duty_o = bemf_duty;
  assign on_clocks_o = on_clocks;

  // What nothing reads, for the linters.
  wire unused = &{1'b0, words_target_i, sum_163[16:0], sum_92[26:0]};
endmodule
