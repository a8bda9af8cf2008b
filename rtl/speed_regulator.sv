// speed_regulator: steplock::SpeedRegulator, printed by hlsgen from hls/sinusoidal/speed_regulator.hpp:43.
// A sample takes 14 clocks, and in no order fewer than 13: 88 operations, 8 products
// on 1 multiplier of 16 x 16 bits; 410 register bits, 205 of them between steps.
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
  logic [29:0] kept_0;  // in steps 1-1, 2-6 reference, 7-8
  logic [25:0] kept_1;  // in steps 1-1, 9-9, 10-10 wanted, 11-11
  logic [24:0] kept_2;  // in steps 1-1 target, 7-13
  logic [28:0] kept_3;  // in steps 1-1 way, 5-5, 6-11 speed, 12-12 moved
  logic [15:0] kept_4;  // in steps 1-1, 2-2, 4-4, 7-9, 11-11 current, 12-13
  logic [19:0] kept_5;  // in steps 1-1, 2-13
  logic [15:0] kept_6;  // in steps 1-13
  logic [28:0] kept_7;  // in steps 1-12
  logic kept_8;  // in steps 6-6, 7-13
  logic kept_9;  // in steps 7-13
  logic kept_10;  // in steps 7-13
  logic kept_11;  // in steps 7-13
  logic kept_12;  // in steps 7-10, 11-13
  logic [2:0] kept_13;  // in steps 9-9, 11-12, 13-13
  logic [5:0] kept_14;  // in steps 11-11
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

  wire [27:0] joined_80 = {kept_0[25:0], 2'd0};  // line 80
  wire [28:0] difference_80 = {joined_80[27], joined_80} - {kept_3[27], kept_3[27:0]};  // line 80
  wire [15:0] wide_81 = {{11{kept_4[4]}}, kept_4[4:0]};  // line 81
  wire [20:0] wide_68_4 = {emf_step_i[19], emf_step_i};  // line 68
  wire [20:0] choice_68_4 = reverse_i ? -wide_68_4 : wide_68_4;  // line 68
  wire [17:0] wide_112 = {{2{kept_6[15]}}, kept_6};  // line 112
  wire [26:0] joined_83 = {words_limit_i, 12'd0};  // line 83
  wire [31:0] product_next = $signed(factor_a) * $signed(factor_b);  // line 84
  wire [25:0] wide = {11'd0, product[29:15]};

  always_ff @(posedge clk) begin
    case (step)
      4'd0: begin
        logic [24:0] joined_71;
        logic [24:0] target;
        logic [26:0] way;
        logic [20:0] wide_68;
        logic [20:0] choice_68;
        joined_71 = {words_stop_i - {2'd0, words_stop_i[14:2]}, 10'd0};  // line 71
        target = slow_down_i ? joined_71 : words_target_i;  // line 71
        way = {2'd0, target} - {reference[25], reference};  // line 72
        wide_68 = {step_i[19], step_i};  // line 68
        choice_68 = reverse_i ? -wide_68 : wide_68;  // line 68
        step <= {3'd0, start_i};
        kept_0 <= {4'd0, reference + {11'd0, words_slew_i}};
        kept_1 <= reference - {11'd0, words_slew_i};
        if (slow_down_i) begin
          kept_2 <= joined_71;
        end else begin
          kept_2 <= words_target_i;
        end
        kept_3 <= {2'd0, way};
        kept_4 <= -{1'b0, words_slew_i};
        if (!choice_68[20] && choice_68[19]) begin
          kept_5 <= 20'd524287;
        end else begin
          kept_5 <= choice_68[19:0];
        end
        if (choice_68_4[20] || !choice_68_4[19]) begin
          kept_6 <= choice_68_4[19:4];
        end else begin
          kept_6 <= 16'd32767;
        end
        kept_7 <= -{2'd0, joined_83};
      end
      4'd1: begin
        logic below_73;
        logic [25:0] choice_80;
        logic below_73_2;
        logic [25:0] reference_2;
        logic [27:0] joined_78;
        logic [28:0] behind;
        below_73 = $signed(kept_3[26:0]) < $signed({{11{kept_4[15]}}, kept_4});  // line 73
        choice_80 = below_73 ? kept_1 : {1'b0, kept_2};  // line 80
        below_73_2 = $signed({12'd0, words_slew_i}) < $signed(kept_3[26:0]);  // line 73
        reference_2 = below_73_2 ? kept_0[25:0] : choice_80;  // line 80
        joined_78 = {kept_5, 8'd0};  // line 78
        behind = {joined_78[27], joined_78} - {speed[27], speed};  // line 78
        if (enable_i) begin
          if (below_73_2) begin
            reference <= kept_0[25:0];
            kept_5 <= {4'd0, kept_0[25:10]};
          end else begin
            if (below_73) begin
              reference <= kept_1;
            end else begin
              reference <= {1'b0, kept_2};
            end
            kept_5 <= {4'd0, choice_80[25:10]};
          end
        end else begin
          reference <= 26'd0;
          kept_5 <= 20'd0;
        end
        step <= step + 4'd1;
        kept_0 <= {4'd0, reference_2};
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
        logic [29:0] sum_79;
        logic [27:0] speed_2;
        sum_79 = {{2{speed[27]}}, speed} + {kept_3[28], kept_3};  // line 79
        speed_2 =  // line 79
            sum_79[29] ? ((sum_79[29:27] == 3'd7) ? sum_79[27:0] : 28'd134217728) :
            (sum_79[29:27] == 3'd0) ? sum_79[27:0] :
            28'd134217727;
        if (enable_i) begin
          if (sum_79[29]) begin
            if (sum_79[29:27] == 3'd7) begin
              speed <= sum_79[27:0];
            end else begin
              speed <= 28'd134217728;
            end
          end else if (sum_79[29:27] == 3'd0) begin
            speed <= sum_79[27:0];
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
        logic [19:0] error;
        logic [16:0] wide_68_3;
        logic [16:0] choice_68_3;
        logic [15:0] choice;
        error =  // line 80
            difference_80[28] ?
            ((difference_80[28:27] == 2'd3) ? difference_80[27:8] : 20'd524288) :
            (difference_80[28:27] == 2'd0) ? difference_80[27:8] :
            20'd524287;
        wide_68_3 = {kept_3[27], kept_3[27:12]};  // line 68
        choice_68_3 = reverse_i ? -wide_68_3 : wide_68_3;  // line 68
        choice =
            enable_i ? ((choice_68_3[16] || !choice_68_3[15]) ? choice_68_3[15:0] : 16'd32767) :
            16'd0;
        step <= step + 4'd1;
        kept_0 <= {15'd0, error[14:0]};
        kept_2 <= {9'd0, choice};
        kept_4 <= {11'd0, error[19:15]};
        kept_8 <= enable_i && $signed({1'b0, words_lock_i}) < $signed(kept_3[27:12]);
        kept_9 <= enable_i && $signed(kept_3[27:12]) < $signed({1'b0, words_slow_i});
        kept_10 <= enable_i && $signed(kept_3[27:12]) < $signed({1'b0, words_stop_i});
        kept_11 <= kept_8 && kept_3[26:12] != 15'd0;
        kept_12 <= error[19];
        factor_a <= {1'b0, error[14:0]};
        factor_b <= {1'b0, words_k_p_i};
      end
      4'd7: begin
        step <= step + 4'd1;
        factor_a <= wide_81;
        factor_b <= {1'b0, words_k_p_i};
      end
      4'd8: begin
        step <= step + 4'd1;
        kept_1 <= wide;
        kept_13 <= product[14:12];
        factor_a <= kept_0[15:0];
        factor_b <= {1'b0, words_k_i_i};
      end
      4'd9, 4'd11: begin
        logic [19:0] sum_81;
        sum_81 = {5'd0, kept_1[14:0]} + product[19:0];  // line 81
        case (step)
          4'd9: begin
            logic [22:0] joined_81;
            logic [23:0] wanted;
            joined_81 = {sum_81, kept_13};  // line 81
            wanted = {joined_81[22], joined_81} + {{8{integral[27]}}, integral[27:12]};  // line 81
            step <= step + 4'd1;
            kept_1 <= {2'd0, wanted};
            factor_a <= wide_81;
            factor_b <= {1'b0, words_k_i_i};
          end
          default: begin  // 4'd11
            logic [25:0] joined_84;
            joined_84 = {sum_81, kept_14};  // line 84
            step <= step + 4'd1;
            kept_3 <= {integral[27], integral} + {{3{joined_84[25]}}, joined_84};
            if (enable_i) begin
              logic [16:0] wide_68_2;
              logic [16:0] choice_68_2;
              wide_68_2 = {kept_4[15], kept_4};  // line 68
              choice_68_2 = reverse_i ? -wide_68_2 : wide_68_2;  // line 68
              if (choice_68_2[16] || !choice_68_2[15]) begin
                kept_4 <= choice_68_2[15:0];
              end else begin
                kept_4 <= 16'd32767;
              end
            end else begin
              kept_4 <= 16'd0;
            end
            factor_a <= kept_3[27:12];
            factor_b <= {1'b0, words_emf_high_i};
          end
        endcase
      end
      4'd10: begin
        logic [15:0] difference_82;
        logic below_82;
        difference_82 = -{1'b0, words_limit_i};  // line 82
        below_82 = $signed(kept_1[23:0]) < $signed({{8{difference_82[15]}}, difference_82});
        step <= step + 4'd1;
        kept_1 <= wide;
        if ($signed({9'd0, words_limit_i}) < $signed(kept_1[23:0])) begin
          kept_4 <= {1'b0, words_limit_i};
          kept_12 <= enable_i;
        end else begin
          if (below_82) begin
            kept_4 <= difference_82;
          end else begin
            kept_4 <= kept_1[15:0];
          end
          kept_12 <= enable_i && below_82;
        end
        kept_13 <=
            {2'd0,
            ($signed(kept_1[23:0]) <= $signed({9'd0, words_limit_i}) || kept_12) &&
            !(below_82 && kept_12)};
        kept_14 <= product[14:9];
        factor_a <= kept_3[27:12];
        factor_b <= {1'b0, words_emf_low_i};
      end
      4'd12: begin
        if (enable_i) begin
          if (kept_13[0]) begin
            if ($signed({2'd0, joined_83}) < $signed(kept_3)) begin
              integral <= {1'b0, joined_83};
            end else if ($signed(kept_3) < $signed(kept_7)) begin
              integral <= kept_7[27:0];
            end else begin
              integral <= kept_3[27:0];
            end
          end
        end else begin
          integral <= 28'd0;
        end
        step <= step + 4'd1;
        kept_13 <= {2'd0, $signed(product[30:13]) < $signed(wide_112)};
      end
      4'd13: begin
        step <= 4'd0;
        current_held <= kept_4;
        speed_held <= kept_2[15:0];
        reference_held <= kept_5[15:0];
        saturated_held <= kept_12;
        fast_held <= kept_8;
        slow_held <= kept_9;
        stopping_held <= kept_10;
        plausible_held <=
            enable_i && kept_11 && kept_13[0] && $signed(wide_112) < $signed(product[30:13]);
      end
      default: step <= step + 4'd1;
    endcase
    product <= product_next;  // line 84
    done <= step == 4'd13;
    missed <= start_i && step != 4'd0;
    if (rst) begin
      reference <= 26'sd0;
      speed <= 28'sd0;
      integral <= 28'sd0;
      step <= 4'd0;
      kept_0 <= 30'd0;
      kept_1 <= 26'd0;
      kept_2 <= 25'd0;
      kept_3 <= 29'd0;
      kept_4 <= 16'd0;
      kept_5 <= 20'd0;
      kept_6 <= 16'd0;
      kept_7 <= 29'd0;
      kept_8 <= 1'b0;
      kept_9 <= 1'b0;
      kept_10 <= 1'b0;
      kept_11 <= 1'b0;
      kept_12 <= 1'b0;
      kept_13 <= 3'd0;
      kept_14 <= 6'd0;
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
  wire unused = &{1'b0, kept_0[29:26], product[31], difference_80[7:0], choice_68_4[3:0]};
endmodule
