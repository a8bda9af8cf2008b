// speed_regulator: steplock::SpeedRegulator, printed by hlsgen from hls/sinusoidal/speed_regulator.hpp:44.
// A sample takes 16 clocks, and in no order fewer than 15: 92 operations, 8 products
// on 1 multiplier of 16 x 16 bits; 402 register bits, 197 of them between steps.
// Do not edit: change the C++ and print again.

module speed_regulator (
    input  logic        clk,
    input  logic        rst,  // synchronous, active high
    input  logic        enable_i,  // false: no current, the reference at 0
    input  logic        reverse_i,  // the wanted direction
    input  logic        slow_down_i,  // towards a stop
    input  logic [19:0] step_i,  // s0.19
    input  logic [19:0] emf_step_i,  // s0.19, the EMF over K_E
    input  logic [24:0] words_target_i,  // u0.25
    input  logic [14:0] words_slew_i,  // u0.25, per sample
    input  logic [14:0] words_filter_i,  // u0.15, per sample
    input  logic [14:0] words_k_p_i,  // u7.8
    input  logic [14:0] words_k_i_i,  // u-2.17, per sample
    input  logic [14:0] words_limit_i,  // u0.15, of the current
    input  logic [14:0] words_lock_i,  // u0.15: above, the estimate may be trusted
    input  logic [14:0] words_slow_i,  // u0.15: below, it may not
    input  logic [14:0] words_stop_i,  // u0.15: below, the drive lets go
    input  logic [14:0] words_emf_low_i,  // u2.13
    input  logic [14:0] words_emf_high_i,  // u2.13
    input  logic        start_i,  // begins a sample, unless busy
    output logic [15:0] current_o,  // s0.15, i_delta*
    output logic [15:0] speed_o,  // s0.15, smoothed
    output logic [15:0] reference_o,  // s0.15, in the wanted direction
    output logic        saturated_o,  // the current is limited
    output logic        fast_o,  // above `lock`
    output logic        slow_o,  // below `slow`
    output logic        stopping_o,  // below `stop`
    output logic        plausible_o,  // the EMF belongs to the speed
    output logic        done_o,  // one clock: the results are new
    output logic        busy_o,  // a start would be ignored
    output logic        missed_o  // one clock: a start was ignored
);
  logic [25:0] reference;  // s0.25
  logic [27:0] speed;  // s0.27
  logic [27:0] integral;  // s0.27, current
  logic [3:0] step;  // 0: waiting for a start
  logic [28:0] kept_0;  // in steps 1-1, 2-6 reference, 7-7, 12-12, 13-13 integral, 14-14 integral
  logic [25:0] kept_1;  // in steps 1-1
  logic [24:0] kept_2;  // in steps 1-1 target, 8-10, 11-11, 14-14 wanted
  logic [28:0] kept_3;  // in steps 1-1 way, 5-5, 6-7 speed
  logic [15:0] kept_4;  // in steps 1-1, 2-2, 4-4, 7-15
  logic [19:0] kept_5;  // in steps 1-1, 2-15
  logic [23:0] kept_6;  // in steps 1-14
  logic [15:0] kept_7;  // in steps 1-9, 11-11, 13-13, 15-15 current
  logic kept_8;  // in steps 6-6, 7-7, 8-14, 15-15
  logic kept_9;  // in steps 7-15
  logic kept_10;  // in steps 7-15
  logic kept_11;  // in steps 7-15
  logic kept_12;  // in steps 7-9, 10-15
  logic [4:0] kept_13;  // in steps 8-11, 13-13
  logic kept_14;  // in steps 9-9, 13-13
  logic kept_15;  // in steps 13-13
  logic [15:0] factor_a;  // of the shared multiplier
  logic [15:0] factor_b;  // of the shared multiplier
  logic [31:0] product;  // of the factors before
  logic [15:0] current_held;  // until the next is done
  logic [15:0] speed_held;  // until the next is done
  logic [15:0] reference_held;  // until the next is done
  logic saturated_held;  // until the next is done
  logic fast_held;  // until the next is done
  logic slow_held;  // until the next is done
  logic stopping_held;  // until the next is done
  logic plausible_held;  // until the next is done
  logic done;
  logic missed;

  wire [29:0] sum_81 = {kept_0[28], kept_0} + 30'd128;  // line 81
  wire [15:0] wide_82 = {{11{kept_13[4]}}, kept_13};  // line 82
  wire [19:0] sum_82 = {5'd0, kept_7[14:0]} + product[19:0];  // line 82
  wire [20:0] wide_69_4 = {emf_step_i[19], emf_step_i};  // line 69
  wire [20:0] choice_69_4 = reverse_i ? -wide_69_4 : wide_69_4;  // line 69
  wire [17:0] wide_113 = {{2{kept_7[15]}}, kept_7};  // line 113
  wire [34:0] joined_85 = {sum_82, kept_2[14:0]};  // line 85
  wire [35:0] sum_85 = {joined_85[34], joined_85} + 36'd256;  // line 85
  wire [31:0] product_next = $signed(factor_a) * $signed(factor_b);  // line 85

  always_ff @(posedge clk) begin
    case (step)
      4'd0, 4'd14: begin
        logic [15:0] difference_83;
        difference_83 = -{1'b0, words_limit_i};  // line 83
        case (step)
          4'd0: begin
            logic [24:0] joined_72;
            logic [24:0] target;
            logic [26:0] way;
            logic [20:0] wide_69;
            logic [20:0] choice_69;
            joined_72 = {words_stop_i - {2'd0, words_stop_i[14:2]}, 10'd0};  // line 72
            target = slow_down_i ? joined_72 : words_target_i;  // line 72
            way = {2'd0, target} - {reference[25], reference};  // line 73
            wide_69 = {step_i[19], step_i};  // line 69
            choice_69 = reverse_i ? -wide_69 : wide_69;  // line 69
            step <= {3'd0, start_i};
            kept_0 <= {3'd0, reference + {11'd0, words_slew_i}};
            kept_1 <= reference - {11'd0, words_slew_i};
            if (slow_down_i) begin
              kept_2 <= joined_72;
            end else begin
              kept_2 <= words_target_i;
            end
            kept_3 <= {2'd0, way};
            kept_4 <= -{1'b0, words_slew_i};
            if (!choice_69[20] && choice_69[19]) begin
              kept_5 <= 20'd524287;
            end else begin
              kept_5 <= choice_69[19:0];
            end
            kept_6 <= {{8{difference_83[15]}}, difference_83};
            if (choice_69_4[20] || !choice_69_4[19]) begin
              kept_7 <= choice_69_4[19:4];
            end else begin
              kept_7 <= 16'd32767;
            end
          end
          default: begin  // 4'd14
            logic below_83;
            logic below_83_2;
            below_83 = $signed({9'd0, words_limit_i}) < $signed(kept_2[23:0]);  // line 83
            below_83_2 = $signed(kept_2[23:0]) < $signed(kept_6);  // line 83
            if (enable_i) begin
              if (($signed(kept_2[23:0]) <= $signed({9'd0, words_limit_i}) || kept_8) &&
                  !(below_83_2 && kept_8)) begin
                integral <= kept_0[27:0];
              end
              kept_8 <= below_83 || below_83_2;
            end else begin
              integral <= 28'd0;
              kept_8 <= 1'b0;
            end
            step <= step + 4'd1;
            if (below_83) begin
              kept_7 <= {1'b0, words_limit_i};
            end else if (below_83_2) begin
              kept_7 <= difference_83;
            end else begin
              kept_7 <= kept_2[15:0];
            end
          end
        endcase
      end
      4'd1: begin
        logic below_74;
        logic [25:0] choice_81;
        logic below_74_2;
        logic [25:0] reference_2;
        logic [27:0] joined_79;
        logic [28:0] behind;
        below_74 = $signed(kept_3[26:0]) < $signed({{11{kept_4[15]}}, kept_4});  // line 74
        choice_81 = below_74 ? kept_1 : {1'b0, kept_2};  // line 81
        below_74_2 = $signed({12'd0, words_slew_i}) < $signed(kept_3[26:0]);  // line 74
        reference_2 = below_74_2 ? kept_0[25:0] : choice_81;  // line 81
        joined_79 = {kept_5, 8'd0};  // line 79
        behind = {joined_79[27], joined_79} - {speed[27], speed};  // line 79
        if (enable_i) begin
          if (below_74_2) begin
            reference <= kept_0[25:0];
            kept_5 <= {4'd0, kept_0[25:10]};
          end else begin
            if (below_74) begin
              reference <= kept_1;
            end else begin
              reference <= {1'b0, kept_2};
            end
            kept_5 <= {4'd0, choice_81[25:10]};
          end
        end else begin
          reference <= 26'd0;
          kept_5 <= 20'd0;
        end
        step <= step + 4'd1;
        kept_0 <= {3'd0, reference_2};
        kept_4 <= {2'd0, behind[28:15]};
        factor_a <= {1'b0, behind[14:0]};
        factor_b <= {1'b0, words_filter_i};
      end
      4'd2: begin
        step <= step + 4'd1;
        factor_a <= {{2{kept_4[13]}}, kept_4[13:0]};
        factor_b <= {1'b0, words_filter_i};
      end
      4'd3: begin
        step <= step + 4'd1;
        kept_4 <= {1'b0, product[29:15]};
      end
      4'd4: begin
        step <= step + 4'd1;
        kept_3 <= {14'd0, kept_4[14:0]} + product[28:0];
      end
      4'd5: begin
        logic [29:0] sum_80;
        logic [27:0] speed_2;
        sum_80 = {{2{speed[27]}}, speed} + {kept_3[28], kept_3};  // line 80
        speed_2 =  // line 80
            sum_80[29] ? ((sum_80[29:27] == 3'd7) ? sum_80[27:0] : 28'd134217728) :
            (sum_80[29:27] == 3'd0) ? sum_80[27:0] :
            28'd134217727;
        if (enable_i) begin
          if (sum_80[29]) begin
            if (sum_80[29:27] == 3'd7) begin
              speed <= sum_80[27:0];
            end else begin
              speed <= 28'd134217728;
            end
          end else if (sum_80[29:27] == 3'd0) begin
            speed <= sum_80[27:0];
          end else begin
            speed <= 28'd134217727;
          end
        end else begin
          speed <= 28'd0;
        end
        step <= step + 4'd1;
        kept_3 <= {1'b0, speed_2};
        kept_8 <= !speed_2[27];
      end
      4'd6: begin
        logic [27:0] joined_81;
        logic [28:0] difference_81;
        joined_81 = {kept_0[25:0], 2'd0};  // line 81
        difference_81 = {joined_81[27], joined_81} - {kept_3[27], kept_3[27:0]};  // line 81
        step <= step + 4'd1;
        kept_0 <= difference_81;
        if (enable_i) begin
          logic [16:0] wide_69_3;
          logic [16:0] choice_69_3;
          wide_69_3 = {kept_3[27], kept_3[27:12]};  // line 69
          choice_69_3 = reverse_i ? -wide_69_3 : wide_69_3;  // line 69
          if (choice_69_3[16] || !choice_69_3[15]) begin
            kept_4 <= choice_69_3[15:0];
          end else begin
            kept_4 <= 16'd32767;
          end
        end else begin
          kept_4 <= 16'd0;
        end
        kept_8 <= difference_81[28] && difference_81[27:7] != 21'd2097151;
        kept_9 <= enable_i && $signed({1'b0, words_lock_i}) < $signed(kept_3[27:12]);
        kept_10 <= enable_i && $signed(kept_3[27:12]) < $signed({1'b0, words_slow_i});
        kept_11 <= enable_i && $signed(kept_3[27:12]) < $signed({1'b0, words_stop_i});
        kept_12 <= kept_8 && kept_3[26:12] != 15'd0;
        factor_a <= kept_3[27:12];
        factor_b <= {1'b0, words_emf_low_i};
      end
      4'd7: begin
        logic [19:0] error;
        error =  // line 81
            kept_8 ? ((sum_81[29:27] == 3'd7) ? sum_81[27:8] : 20'd524288) :
            (sum_81[29:27] == 3'd0) ? sum_81[27:8] :
            20'd524287;
        step <= step + 4'd1;
        kept_2 <= {10'd0, error[14:0]};
        kept_8 <= error[19];
        kept_13 <= error[19:15];
        factor_a <= kept_3[27:12];
        factor_b <= {1'b0, words_emf_high_i};
      end
      4'd8: begin
        step <= step + 4'd1;
        kept_14 <= $signed(product[30:13]) < $signed(wide_113);
        factor_a <= {1'b0, kept_2[14:0]};
        factor_b <= {1'b0, words_k_i_i};
      end
      4'd9: begin
        step <= step + 4'd1;
        kept_12 <= enable_i && kept_12 && kept_14 && $signed(wide_113) < $signed(product[30:13]);
        factor_a <= wide_82;
        factor_b <= {1'b0, words_k_i_i};
      end
      4'd10: begin
        step <= step + 4'd1;
        kept_2 <= {10'd0, product[14:0]};
        kept_7 <= {1'b0, product[29:15]};
        factor_a <= {1'b0, kept_2[14:0]};
        factor_b <= {1'b0, words_k_p_i};
      end
      4'd11: begin
        step <= step + 4'd1;
        kept_0 <= {2'd0, sum_85[35:9]};
        factor_a <= wide_82;
        factor_b <= {1'b0, words_k_p_i};
      end
      4'd12, 4'd13: begin
        logic [26:0] joined_84;
        logic [28:0] difference_87;
        joined_84 = {words_limit_i, 12'd0};  // line 84
        difference_87 = -{2'd0, joined_84};  // line 87
        case (step)
          4'd12: begin
            logic [28:0] moved;
            moved = {integral[27], integral} + {{2{kept_0[26]}}, kept_0[26:0]};  // line 85
            step <= step + 4'd1;
            kept_0 <= {1'b0, moved[27:0]};
            kept_7 <= {1'b0, product[29:15]};
            kept_13 <= {2'd0, product[14:12]};
            kept_14 <= $signed(moved) < $signed(difference_87);
            kept_15 <= $signed({2'd0, joined_84}) < $signed(moved);
          end
          default: begin  // 4'd13
            logic [22:0] joined_82;
            logic [23:0] wanted;
            logic [27:0] integral_2;
            joined_82 = {sum_82, kept_13[2:0]};  // line 82
            wanted = {joined_82[22], joined_82} + {{8{integral[27]}}, integral[27:12]};  // line 82
            integral_2 =
                kept_15 ? {1'b0, joined_84} :
                kept_14 ? difference_87[27:0] :
                kept_0[27:0];
            step <= step + 4'd1;
            kept_0 <= {1'b0, integral_2};
            kept_2 <= {1'b0, wanted};
          end
        endcase
      end
      default: begin  // 4'd15
        step <= 4'd0;
        if (enable_i) begin
          logic [16:0] wide_69_2;
          logic [16:0] choice_69_2;
          wide_69_2 = {kept_7[15], kept_7};  // line 69
          choice_69_2 = reverse_i ? -wide_69_2 : wide_69_2;  // line 69
          if (choice_69_2[16] || !choice_69_2[15]) begin
            current_held <= choice_69_2[15:0];
          end else begin
            current_held <= 16'd32767;
          end
        end else begin
          current_held <= 16'd0;
        end
        speed_held <= kept_4;
        reference_held <= kept_5[15:0];
        saturated_held <= kept_8;
        fast_held <= kept_9;
        slow_held <= kept_10;
        stopping_held <= kept_11;
        plausible_held <= kept_12;
      end
    endcase
    product <= product_next;  // line 85
    done <= step == 4'd15;
    missed <= start_i && step != 4'd0;
    if (rst) begin
      reference <= 26'sd0;
      speed <= 28'sd0;
      integral <= 28'sd0;
      step <= 4'd0;
      kept_0 <= 29'd0;
      kept_1 <= 26'd0;
      kept_2 <= 25'd0;
      kept_3 <= 29'd0;
      kept_4 <= 16'd0;
      kept_5 <= 20'd0;
      kept_6 <= 24'd0;
      kept_7 <= 16'd0;
      kept_8 <= 1'b0;
      kept_9 <= 1'b0;
      kept_10 <= 1'b0;
      kept_11 <= 1'b0;
      kept_12 <= 1'b0;
      kept_13 <= 5'd0;
      kept_14 <= 1'b0;
      kept_15 <= 1'b0;
      factor_a <= 16'd0;
      factor_b <= 16'd0;
      product <= 32'd0;
      current_held <= 16'sd0;
      speed_held <= 16'sd0;
      reference_held <= 16'sd0;
      saturated_held <= 1'b0;
      fast_held <= 1'b0;
      slow_held <= 1'b0;
      stopping_held <= 1'b0;
      plausible_held <= 1'b0;
      done <= 1'b0;
      missed <= 1'b0;
    end
  end

  assign current_o = current_held;
  assign speed_o = speed_held;
  assign reference_o = reference_held;
  assign saturated_o = saturated_held;
  assign fast_o = fast_held;
  assign slow_o = slow_held;
  assign stopping_o = stopping_held;
  assign plausible_o = plausible_held;
  assign done_o = done;
  assign busy_o = step != 4'd0;
  assign missed_o = missed;

  // What nothing reads, for the linters.
  wire unused = &{1'b0, product[31], sum_81[7:0], choice_69_4[3:0], sum_85[8:0]};
endmodule
