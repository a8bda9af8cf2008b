// space_vector: steplock::SpaceVector, printed by hlsgen from hls/sinusoidal/space_vector.hpp:31.
// A sample takes 16 clocks, and in no order fewer than 16: 143 operations, 12 products
// on 1 multiplier of 16 x 16 bits; 280 register bits, 153 of them between steps.
// Do not edit: change the C++ and print again.

module space_vector (
    input  logic        clk,
    input  logic        rst,  // synchronous, active high
    input  logic [15:0] v_alpha_i,  // s0.15
    input  logic [15:0] v_beta_i,  // s0.15
    input  logic [15:0] i_u_i,  // s0.15, for their signs: wanted currents, or measured ones
    input  logic [15:0] i_v_i,  // s0.15
    input  logic [11:0] v_dc_i,  // u0.12
    input  logic [13:0] period_i,  // clocks
    input  logic [13:0] minimum_i,  // clocks
    input  logic [11:0] dead_i,  // u8.4 clocks; 0: nothing to make up for
    input  logic        sine_i,  // no zero component
    input  logic        hold_i,  // one leg alone
    input  logic        hold_v_i,  // that leg is v, else u
    input  logic [14:0] hold_voltage_i,  // u0.15
    input  logic        start_i,  // begins a sample, unless busy
    output logic [13:0] on_u_o,  // clocks
    output logic [13:0] on_v_o,  // clocks
    output logic [13:0] on_w_o,  // clocks
    output logic        done_o,  // one clock: the results are new
    output logic        busy_o,  // a start would be ignored
    output logic        missed_o  // one clock: a start was ignored
);
  logic [14:0] inverse;  // u3.12, 1 / v_dc
  logic [3:0] step;  // 0: waiting for a start
  logic [16:0] kept_0;  // in steps 1-13, 15-15
  logic [18:0] kept_1;  // in steps 1-2, 3-5, 6-7 voltage, 9-9 share, 10-10 share, 11-11 share, 13-13, 14-14, 15-15
  logic [17:0] kept_2;  // in steps 1-3, 4-4 b, 5-5 common, 6-12
  logic [15:0] kept_3;  // in steps 1-1, 2-5, 6-6 voltage, 8-13, 14-14, 15-15
  logic [17:0] kept_4;  // in steps 1-1, 3-3, 4-5 w, 6-8
  logic kept_5;  // in steps 1-1, 13-13, 14-14, 15-15
  logic [17:0] kept_6;  // in steps 4-4 b
  logic [14:0] kept_7;  // in steps 4-4, 5-11, 13-13, 14-15
  logic [30:0] kept_8;  // in steps 7-8, 12-12, 13-13, 14-14
  logic [15:0] factor_a;  // of the shared multiplier
  logic [15:0] factor_b;  // of the shared multiplier
  logic [31:0] product;  // of the factors before
  logic [13:0] on_u_held;  // until the next is done
  logic [13:0] on_v_held;  // until the next is done
  logic [13:0] on_w_held;  // until the next is done
  logic done;
  logic missed;

  wire [32:0] sum_61 = {product[31], product} + 33'd16384;  // line 61
  wire [17:0] u = {{2{v_alpha_i[15]}}, v_alpha_i};  // line 62
  wire [17:0] least = ($signed(kept_2) < $signed(u)) ? kept_2 : u;  // line 79
  wire [17:0] greatest = ($signed(kept_6) < $signed(u)) ? u : kept_6;  // line 80
  wire [18:0] sum_64 = {least[17], least} + {greatest[17], greatest};  // line 64
  wire [31:0] difference_56 = 32'd268435456 - {2'd0, product[29:0]};  // line 56
  wire [28:0] sum_57 = product[28:0] + 29'd8192;  // line 57
  wire [31:0] sum_83 = {product[30], product[30:0]} + 32'd2048;  // line 83
  wire [21:0] sum_86_2 = {kept_8[20], kept_8[20:0]} + 22'd8;  // line 86
  wire [15:0] i_w = kept_5 ? kept_3 : kept_4[15:0];  // line 65
  wire both_86 = i_w[15] && i_w[14:4] != 11'd2047;  // line 86
  wire [15:0] choice_86_5 = both_86 ? 16'd65520 : i_w;  // line 86
  wire [31:0] product_next = $signed(factor_a) * $signed(factor_b);  // line 86

  always_ff @(posedge clk) begin
    case (step)
      4'd0: begin
        logic [15:0] choice_86;
        logic [15:0] choice_86_2;
        logic [15:0] choice_86_3;
        logic [15:0] choice_86_4;
        logic [16:0] sum_65;
        logic [17:0] difference_65;
        logic [2:0] part_65;
        choice_86 = (i_u_i[15] && i_u_i[14:4] != 11'd2047) ? 16'd65520 : i_u_i;  // line 86
        choice_86_2 = (choice_86[15] || choice_86[14:4] == 11'd0) ? choice_86 : 16'd16;  // line 86
        choice_86_3 = (i_v_i[15] && i_v_i[14:4] != 11'd2047) ? 16'd65520 : i_v_i;  // line 86
        choice_86_4 = (choice_86_3[15] || choice_86_3[14:4] == 11'd0) ? choice_86_3 : 16'd16;
        sum_65 = {i_u_i[15], i_u_i} + {i_v_i[15], i_v_i};  // line 65
        difference_65 = -{sum_65[16], sum_65};  // line 65
        part_65 = difference_65[17:15];  // line 65
        step <= {3'd0, start_i};
        if (hold_i) begin
          kept_0 <= 17'd0;
        end else begin
          kept_0 <= {period_i, 3'd0};
        end
        kept_1 <= {3'd0, choice_86_2};
        kept_2 <= {2'd0, choice_86_4};
        case (part_65)
          3'd0: begin
            kept_3 <= 16'd32768;
            kept_4 <= {2'd0, difference_65[15:0]};
          end
          3'd7: begin
            kept_3 <= difference_65[15:0];
            kept_4 <= 18'd32767;
          end
          default: begin
            kept_3 <= 16'd32768;
            kept_4 <= 18'd32767;
          end
        endcase
        kept_5 <= !sum_65[16] && sum_65[15:0] != 16'd0;
        factor_a <= v_beta_i;
        factor_b <= 16'd28378;
      end
      4'd1: begin
        logic [14:0] v_dc;
        v_dc = {v_dc_i, 3'd0};  // line 55
        step <= step + 4'd1;
        if (choice_86_5[15] || choice_86_5[14:4] == 11'd0) begin
          if (both_86) begin
            kept_3 <= 16'd65520;
          end else if (!kept_5) begin
            kept_3 <= kept_4[15:0];
          end
        end else begin
          kept_3 <= 16'd16;
        end
        factor_a <= {1'b0, v_dc};
        factor_b <= {1'b0, inverse};
      end
      4'd2: begin
        logic [17:0] wide_62;
        wide_62 = {{3{v_alpha_i[15]}}, v_alpha_i[15:1]};  // line 62
        step <= step + 4'd1;
        kept_1 <= {1'b0, sum_61[32:15] - wide_62};
        kept_4 <= sum_61[32:15] + wide_62;
        factor_a <= kept_1[15:0];
        factor_b <= {4'd0, dead_i};
      end
      4'd3: begin
        logic [17:0] w;
        w = -kept_4;  // line 62
        step <= step + 4'd1;
        if ($signed(kept_1[17:0]) < $signed(w)) begin
          kept_2 <= kept_1[17:0];
          kept_6 <= w;
        end else begin
          kept_2 <= w;
          kept_6 <= kept_1[17:0];
        end
        kept_4 <= w;
        if (product[29:0] > 30'd268435456) begin
          kept_7 <= 15'd0;
        end else if (difference_56[31:28] == 4'd0) begin
          kept_7 <= difference_56[27:13];
        end else begin
          kept_7 <= 15'd32767;
        end
        factor_a <= kept_2[15:0];
        factor_b <= {4'd0, dead_i};
      end
      4'd4: begin
        step <= step + 4'd1;
        if (sine_i) begin
          kept_2 <= 18'd0;
        end else begin
          kept_2 <= sum_64[18:1];
        end
        kept_7 <= {1'b0, product[17:4]};
        factor_a <= {1'b0, kept_7};
        factor_b <= {1'b0, inverse};
      end
      4'd5: begin
        step <= step + 4'd1;
        if (hold_i) begin
          kept_1 <= {4'd0, hold_v_i ? hold_voltage_i : 15'd0};
          kept_3 <= {1'b0, hold_v_i ? 15'd0 : hold_voltage_i};
          kept_4 <= 18'd0;
        end else begin
          logic [18:0] wide_67;
          logic [18:0] difference_67;
          logic [18:0] difference_67_2;
          logic [15:0] free;
          logic [18:0] difference_67_3;
          logic [15:0] free_2;
          wide_67 = {kept_2[17], kept_2};  // line 67
          difference_67 = {{3{v_alpha_i[15]}}, v_alpha_i} - wide_67;  // line 67
          difference_67_2 = {kept_1[17], kept_1[17:0]} - wide_67;  // line 67
          free =  // line 67
              difference_67_2[18] ?
              ((difference_67_2[18:15] == 4'd15) ? difference_67_2[15:0] : 16'd32768) :
              (difference_67_2[18:15] == 4'd0) ? difference_67_2[15:0] :
              16'd32767;
          difference_67_3 = {kept_4[17], kept_4} - wide_67;  // line 67
          free_2 =  // line 67
              difference_67_3[18] ?
              ((difference_67_3[18:15] == 4'd15) ? difference_67_3[15:0] : 16'd32768) :
              (difference_67_3[18:15] == 4'd0) ? difference_67_3[15:0] :
              16'd32767;
          kept_1 <= {3'd0, free};
          if (difference_67[18]) begin
            if (difference_67[18:15] == 4'd15) begin
              kept_3 <= difference_67[15:0];
            end else begin
              kept_3 <= 16'd32768;
            end
          end else if (difference_67[18:15] == 4'd0) begin
            kept_3 <= difference_67[15:0];
          end else begin
            kept_3 <= 16'd32767;
          end
          kept_4 <= {2'd0, free_2};
        end
        kept_2 <= {4'd0, product[17:4]};
        factor_a <= kept_3;
        factor_b <= {4'd0, dead_i};
      end
      4'd6: begin
        if (product[29:13] < 17'd65535) begin
          logic [14:0] choice_58;
          choice_58 = (sum_57[28:26] == 3'd0) ? 15'd4096 : sum_57[28:14];  // line 58
          if (sum_57[28:26] == 3'd0) begin
            inverse <= 15'd4096;
          end else begin
            inverse <= sum_57[28:14];
          end
          kept_8 <= {16'd0, choice_58};
          factor_b <= {1'b0, choice_58};
        end else begin
          inverse <= 15'd32767;
          kept_8 <= 31'd32767;
          factor_b <= 16'd32767;
        end
        step <= step + 4'd1;
        factor_a <= kept_3;
      end
      4'd7: begin
        step <= step + 4'd1;
        kept_3 <= {2'd0, product[17:4]};
        factor_a <= kept_1[15:0];
        factor_b <= kept_8[15:0];
      end
      4'd11, 4'd12, 4'd13, 4'd14, 4'd15: begin
        logic [19:0] sum_86;
        logic either_89;
        logic [18:0] difference_88;
        logic below_88;
        logic [13:0] choice;
        logic [30:0] wide;
        sum_86 = {3'd0, kept_0} + {product[29], product[29:11]};  // line 86
        either_89 =  // line 89
            (kept_8[20] && kept_8[20:3] != 18'd262143) ||
            $signed(sum_86_2[21:4]) < $signed({4'd0, minimum_i});
        difference_88 = {5'd0, period_i} - {sum_86_2[21], sum_86_2[21:4]};  // line 88
        below_88 = $signed(kept_1) < $signed({5'd0, minimum_i});  // line 88
        choice =
            (step == 4'd11) ? kept_7[13:0] :
            (step == 4'd12) ? kept_2[13:0] :
            kept_3[13:0];
        wide = {10'd0, {sum_86[19], sum_86} + {{7{choice[13]}}, choice}};
        case (step)
          4'd11: begin
            step <= step + 4'd1;
            kept_8 <= wide;
            factor_a <= kept_1[15:0];
            factor_b <= {2'd0, period_i};
          end
          4'd12: begin
            step <= step + 4'd1;
            kept_1 <= difference_88;
            kept_5 <= either_89;
            kept_7 <= {1'b0, sum_86_2[17:4]};
            kept_8 <= wide;
          end
          4'd13: begin
            logic [13:0] choice_89;
            choice_89 =  // line 89
                kept_5 ? 14'd0 :
                below_88 ? period_i :
                kept_7[13:0];
            step <= step + 4'd1;
            kept_1 <= difference_88;
            kept_3 <= {2'd0, sum_86_2[17:4]};
            kept_5 <= either_89;
            kept_7 <= {1'b0, choice_89};
            kept_8 <= wide;
          end
          4'd14: begin
            logic [13:0] choice_89_2;
            choice_89_2 =  // line 89
                kept_5 ? 14'd0 :
                below_88 ? period_i :
                kept_3[13:0];
            step <= step + 4'd1;
            kept_0 <= {3'd0, sum_86_2[17:4]};
            kept_1 <= difference_88;
            kept_3 <= {2'd0, choice_89_2};
            kept_5 <= either_89;
          end
          default: begin  // 4'd15
            step <= 4'd0;
            on_u_held <= kept_7[13:0];
            on_v_held <= kept_3[13:0];
            if (kept_5) begin
              on_w_held <= 14'd0;
            end else if (below_88) begin
              on_w_held <= period_i;
            end else begin
              on_w_held <= kept_0[13:0];
            end
          end
        endcase
      end
      default: begin
        logic [15:0] share;
        share =  // line 83
            (product[30] && product[29:11] != 19'd524287) ?
            ((sum_83[31:27] == 5'd31) ? sum_83[27:12] : 16'd32768) :
            (sum_83[31:27] == 5'd0) ? sum_83[27:12] :
            16'd32767;
        case (step)
          4'd8: begin
            step <= step + 4'd1;
            kept_1 <= {3'd0, share};
            factor_a <= kept_4[15:0];
            factor_b <= kept_8[15:0];
          end
          default: begin  // 4'd9, 4'd10
            step <= step + 4'd1;
            kept_1 <= {3'd0, share};
            factor_a <= kept_1[15:0];
            factor_b <= {2'd0, period_i};
          end
        endcase
      end
    endcase
    product <= product_next;  // line 86
    done <= step == 4'd15;
    missed <= start_i && step != 4'd0;
    if (rst) begin
      inverse <= 15'd4096;
      step <= 4'd0;
      kept_0 <= 17'd0;
      kept_1 <= 19'd0;
      kept_2 <= 18'd0;
      kept_3 <= 16'd0;
      kept_4 <= 18'd0;
      kept_5 <= 1'b0;
      kept_6 <= 18'd0;
      kept_7 <= 15'd0;
      kept_8 <= 31'd0;
      factor_a <= 16'd0;
      factor_b <= 16'd0;
      product <= 32'd0;
      on_u_held <= 14'd0;
      on_v_held <= 14'd0;
      on_w_held <= 14'd0;
      done <= 1'b0;
      missed <= 1'b0;
    end
  end

  assign on_u_o = on_u_held;
  assign on_v_o = on_v_held;
  assign on_w_o = on_w_held;
  assign done_o = done;
  assign busy_o = step != 4'd0;
  assign missed_o = missed;

  // What nothing reads, for the linters.
  wire unused =
      &{1'b0, kept_8[30:21], sum_61[14:0], sum_64[0], difference_56[12:0], sum_57[13:0],
      sum_83[11:0], sum_86_2[3:0], choice_86_5[3:0]};
endmodule
