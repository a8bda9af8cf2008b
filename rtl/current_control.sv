// current_control: steplock::CurrentControl, printed by hlsgen from hls/sinusoidal/current_control.hpp:36.
// A sample takes 37 clocks, and in no order fewer than 37: 258 operations, 34 products, 4 entries of tables
// on 1 multiplier of 16 x 16 bits; 590 register bits, 350 of them between steps.
// Do not edit: change the C++ and print again.

module current_control (
    input  logic        clk,
    input  logic        rst,  // synchronous, active high
    input  logic        enable_i,  // false: no voltage, integrators at 0
    input  logic [15:0] i_u_i,  // s0.15
    input  logic [15:0] i_v_i,  // s0.15
    input  logic [15:0] angle_i,  // u0.16, electrical turns, of the gamma axis at the sample
    input  logic [15:0] ahead_i,  // u0.16, electrical turns, of the gamma axis when the voltage acts
    input  logic [15:0] speed_i,  // s0.15
    input  logic [15:0] set_gamma_i,  // s0.15
    input  logic [15:0] set_delta_i,  // s0.15
    input  logic [14:0] k_p_i,  // u3.12
    input  logic [14:0] k_i_i,  // u0.15, per sample
    input  logic [14:0] inductance_i,  // u5.10, voltage per current and speed
    input  logic [14:0] emf_i,  // u5.10, voltage per speed
    input  logic [11:0] v_dc_i,  // u0.12
    input  logic [14:0] limit_i,  // u0.15, length of the voltage vector, of the dc voltage
    input  logic        start_i,  // begins a sample, unless busy
    output logic [15:0] v_alpha_o,  // s0.15
    output logic [15:0] v_beta_o,  // s0.15
    output logic [15:0] i_gamma_o,  // s0.15
    output logic [15:0] i_delta_o,  // s0.15
    output logic [15:0] wanted_u_o,  // s0.15, phase currents asked for, when the voltage acts
    output logic [15:0] wanted_v_o,  // s0.15
    output logic        limited_o,  // the voltage would have been longer
    output logic        done_o,  // one clock: the results are new
    output logic        busy_o,  // a start would be ignored
    output logic        missed_o  // one clock: a start was ignored
);
  logic [27:0] integral_gamma;  // s0.27, voltage
  logic [27:0] integral_delta;  // s0.27, voltage
  logic [5:0] step;  // 0: waiting for a start
  logic kept_0;  // in steps 1-1, 5-5, 6-6, 9-9, 11-11, 17-29, 30-36
  logic [7:0] kept_1;  // in steps 1-1
  logic [15:0] kept_2;  // in steps 1-1, 2-4, 5-5 sine, 6-6 sine, 10-36 i_gamma
  logic [2:0] kept_3;  // in steps 1-4, 5-5, 6-6, 19-19, 20-20
  logic kept_4;  // in steps 1-6, 11-16, 18-21, 24-24, 28-28, 31-31, 33-33, 35-35, 36-36
  logic kept_5;  // in steps 1-3, 5-5, 6-6, 19-19, 20-20
  logic [7:0] kept_6;  // in steps 1-2
  logic [6:0] kept_7;  // in steps 1-14, 21-21, 23-23, 36-36
  logic [7:0] kept_8;  // in steps 1-3
  logic [32:0] kept_9;  // in steps 3-3, 4-6, 7-7, 8-8, 9-9 product, 11-11 product, 13-29 error, 31-31 product, 33-33 product, 35-35 product
  logic [15:0] kept_10;  // in steps 3-5, 12-22 coupling, 25-28, 29-33 ask_beta, 34-36
  logic [15:0] kept_11;  // in steps 4-18, 19-19 sine_then, 20-32 _cosine, 36-36
  logic [17:0] kept_12;  // in steps 5-19, 20-20 sine_then, 21-21, 22-22 last, 23-24 b
  logic [31:0] kept_13;  // in steps 6-7, 10-10, 11-11, 12-36 i_delta
  logic [31:0] kept_14;  // in steps 7-8, 13-16 moved, 17-17, 22-22 far, 24-24, 26-29 moved, 30-30, 32-32, 34-34
  logic [20:0] kept_15;  // in steps 14-15, 16-16 wanted, 21-31 _sine
  logic [15:0] kept_16;  // in steps 15-15, 16-23 limit, 25-29, 30-32 delta_voltage, 36-36
  logic [14:0] kept_17;  // in steps 16-16, 18-20, 21-21, 23-23, 25-29 limit
  logic [15:0] kept_18;  // in steps 16-16, 17-31 gamma_voltage, 32-36 ask_alpha
  logic [15:0] kept_19;  // in steps 16-16, 18-28 emf
  logic [15:0] kept_20;  // in steps 16-21, 25-29
  logic [15:0] kept_21;  // in steps 16-21
  logic kept_22;  // in steps 19-19, 20-20
  logic [32:0] kept_23;  // in steps 27-27, 28-28 product, 29-29 wanted
  logic [14:0] kQuarterWave_entry;  // of the table, shared
  logic [15:0] factor_a;  // of the shared multiplier
  logic [15:0] factor_b;  // of the shared multiplier
  logic [31:0] product;  // of the factors before
  logic [15:0] v_alpha_held;  // until the next is done
  logic [15:0] v_beta_held;  // until the next is done
  logic [15:0] i_gamma_held;  // until the next is done
  logic [15:0] i_delta_held;  // until the next is done
  logic [15:0] wanted_u_held;  // until the next is done
  logic [15:0] wanted_v_held;  // until the next is done
  logic limited_held;  // until the next is done
  logic done;
  logic missed;

  wire [9:0] sum_66 = angle_i[15:6] + 10'd256;  // line 66
  wire [7:0] differ_66 = angle_i[13:6] ^ {8{sum_66[8]}};  // line 66
  wire [16:0] wide_66 = {kept_2[15], kept_2};  // line 66
  wire [31:0] wide_66_2 = {{16{product[15]}}, product[15:0]};  // line 66
  wire [32:0] wide_66_3 = {product[31], product};  // line 66
  wire [32:0] sum_66_2 = wide_66_3 + 33'd4194304;  // line 66
  wire [16:0] wide_66_4 = {{7{sum_66_2[32]}}, sum_66_2[32:23]};  // line 66
  wire [16:0] wide_66_5 = {kept_10[15], kept_10};  // line 66
  wire [33:0] sum_116 = {kept_9[32], kept_9} + 34'd16384;  // line 116
  wire [16:0] difference_75 = {set_gamma_i[15], set_gamma_i} - wide_66;  // line 75
  wire [15:0] error =  // line 75
      difference_75[16] ? ((difference_75[16:15] == 2'd3) ? difference_75[15:0] : 16'd32768) :
      (difference_75[16:15] == 2'd0) ? difference_75[15:0] :
      16'd32767;
  wire [28:0] wide_122 = {product[30], product[30:3]};  // line 122
  wire [31:0] sum_72 = {product[30], product[30:0]} + 32'd512;  // line 72
  wire [32:0] sum_116_2 = wide_66_3 + 33'd16384;  // line 116
  wire [9:0] sum_88 = ahead_i[15:6] + 10'd256;  // line 88
  wire [32:0] wide_92 = {kept_14[31], kept_14};  // line 92
  wire [33:0] sum_116_3 = {kept_23[32], kept_23} + 34'd16384;  // line 116

  logic [7:0] choice_88;  // line 88
  always_comb begin
    case (step)
      6'd0: choice_88 = differ_66;
      6'd1: choice_88 = kept_1;
      6'd2: choice_88 = kept_6;
      default: choice_88 = kept_8;
    endcase
  end

  logic [14:0] entry_88;  // kQuarterWave
  always_comb begin
    case (choice_88)
      8'd0: entry_88 = 15'd101;
      8'd1: entry_88 = 15'd302;
      8'd2: entry_88 = 15'd503;
      8'd3: entry_88 = 15'd704;
      8'd4: entry_88 = 15'd905;
      8'd5: entry_88 = 15'd1106;
      8'd6: entry_88 = 15'd1307;
      8'd7: entry_88 = 15'd1507;
      8'd8: entry_88 = 15'd1708;
      8'd9: entry_88 = 15'd1909;
      8'd10: entry_88 = 15'd2110;
      8'd11: entry_88 = 15'd2310;
      8'd12: entry_88 = 15'd2511;
      8'd13: entry_88 = 15'd2711;
      8'd14: entry_88 = 15'd2911;
      8'd15: entry_88 = 15'd3112;
      8'd16: entry_88 = 15'd3312;
      8'd17: entry_88 = 15'd3512;
      8'd18: entry_88 = 15'd3712;
      8'd19: entry_88 = 15'd3911;
      8'd20: entry_88 = 15'd4111;
      8'd21: entry_88 = 15'd4310;
      8'd22: entry_88 = 15'd4509;
      8'd23: entry_88 = 15'd4708;
      8'd24: entry_88 = 15'd4907;
      8'd25: entry_88 = 15'd5106;
      8'd26: entry_88 = 15'd5305;
      8'd27: entry_88 = 15'd5503;
      8'd28: entry_88 = 15'd5701;
      8'd29: entry_88 = 15'd5899;
      8'd30: entry_88 = 15'd6096;
      8'd31: entry_88 = 15'd6294;
      8'd32: entry_88 = 15'd6491;
      8'd33: entry_88 = 15'd6688;
      8'd34: entry_88 = 15'd6885;
      8'd35: entry_88 = 15'd7081;
      8'd36: entry_88 = 15'd7277;
      8'd37: entry_88 = 15'd7473;
      8'd38: entry_88 = 15'd7669;
      8'd39: entry_88 = 15'd7864;
      8'd40: entry_88 = 15'd8059;
      8'd41: entry_88 = 15'd8254;
      8'd42: entry_88 = 15'd8448;
      8'd43: entry_88 = 15'd8642;
      8'd44: entry_88 = 15'd8836;
      8'd45: entry_88 = 15'd9030;
      8'd46: entry_88 = 15'd9223;
      8'd47: entry_88 = 15'd9416;
      8'd48: entry_88 = 15'd9608;
      8'd49: entry_88 = 15'd9800;
      8'd50: entry_88 = 15'd9992;
      8'd51: entry_88 = 15'd10183;
      8'd52: entry_88 = 15'd10374;
      8'd53: entry_88 = 15'd10564;
      8'd54: entry_88 = 15'd10754;
      8'd55: entry_88 = 15'd10944;
      8'd56: entry_88 = 15'd11133;
      8'd57: entry_88 = 15'd11322;
      8'd58: entry_88 = 15'd11511;
      8'd59: entry_88 = 15'd11699;
      8'd60: entry_88 = 15'd11886;
      8'd61: entry_88 = 15'd12074;
      8'd62: entry_88 = 15'd12260;
      8'd63: entry_88 = 15'd12446;
      8'd64: entry_88 = 15'd12632;
      8'd65: entry_88 = 15'd12817;
      8'd66: entry_88 = 15'd13002;
      8'd67: entry_88 = 15'd13187;
      8'd68: entry_88 = 15'd13370;
      8'd69: entry_88 = 15'd13554;
      8'd70: entry_88 = 15'd13736;
      8'd71: entry_88 = 15'd13919;
      8'd72: entry_88 = 15'd14101;
      8'd73: entry_88 = 15'd14282;
      8'd74: entry_88 = 15'd14462;
      8'd75: entry_88 = 15'd14643;
      8'd76: entry_88 = 15'd14822;
      8'd77: entry_88 = 15'd15001;
      8'd78: entry_88 = 15'd15180;
      8'd79: entry_88 = 15'd15358;
      8'd80: entry_88 = 15'd15535;
      8'd81: entry_88 = 15'd15712;
      8'd82: entry_88 = 15'd15888;
      8'd83: entry_88 = 15'd16063;
      8'd84: entry_88 = 15'd16238;
      8'd85: entry_88 = 15'd16413;
      8'd86: entry_88 = 15'd16586;
      8'd87: entry_88 = 15'd16759;
      8'd88: entry_88 = 15'd16932;
      8'd89: entry_88 = 15'd17104;
      8'd90: entry_88 = 15'd17275;
      8'd91: entry_88 = 15'd17445;
      8'd92: entry_88 = 15'd17615;
      8'd93: entry_88 = 15'd17784;
      8'd94: entry_88 = 15'd17953;
      8'd95: entry_88 = 15'd18121;
      8'd96: entry_88 = 15'd18288;
      8'd97: entry_88 = 15'd18454;
      8'd98: entry_88 = 15'd18620;
      8'd99: entry_88 = 15'd18785;
      8'd100: entry_88 = 15'd18950;
      8'd101: entry_88 = 15'd19113;
      8'd102: entry_88 = 15'd19276;
      8'd103: entry_88 = 15'd19438;
      8'd104: entry_88 = 15'd19600;
      8'd105: entry_88 = 15'd19761;
      8'd106: entry_88 = 15'd19921;
      8'd107: entry_88 = 15'd20080;
      8'd108: entry_88 = 15'd20238;
      8'd109: entry_88 = 15'd20396;
      8'd110: entry_88 = 15'd20553;
      8'd111: entry_88 = 15'd20709;
      8'd112: entry_88 = 15'd20865;
      8'd113: entry_88 = 15'd21019;
      8'd114: entry_88 = 15'd21173;
      8'd115: entry_88 = 15'd21326;
      8'd116: entry_88 = 15'd21479;
      8'd117: entry_88 = 15'd21630;
      8'd118: entry_88 = 15'd21781;
      8'd119: entry_88 = 15'd21930;
      8'd120: entry_88 = 15'd22079;
      8'd121: entry_88 = 15'd22227;
      8'd122: entry_88 = 15'd22375;
      8'd123: entry_88 = 15'd22521;
      8'd124: entry_88 = 15'd22667;
      8'd125: entry_88 = 15'd22812;
      8'd126: entry_88 = 15'd22956;
      8'd127: entry_88 = 15'd23099;
      8'd128: entry_88 = 15'd23241;
      8'd129: entry_88 = 15'd23382;
      8'd130: entry_88 = 15'd23522;
      8'd131: entry_88 = 15'd23662;
      8'd132: entry_88 = 15'd23801;
      8'd133: entry_88 = 15'd23938;
      8'd134: entry_88 = 15'd24075;
      8'd135: entry_88 = 15'd24211;
      8'd136: entry_88 = 15'd24346;
      8'd137: entry_88 = 15'd24480;
      8'd138: entry_88 = 15'd24613;
      8'd139: entry_88 = 15'd24746;
      8'd140: entry_88 = 15'd24877;
      8'd141: entry_88 = 15'd25007;
      8'd142: entry_88 = 15'd25137;
      8'd143: entry_88 = 15'd25265;
      8'd144: entry_88 = 15'd25393;
      8'd145: entry_88 = 15'd25519;
      8'd146: entry_88 = 15'd25645;
      8'd147: entry_88 = 15'd25770;
      8'd148: entry_88 = 15'd25893;
      8'd149: entry_88 = 15'd26016;
      8'd150: entry_88 = 15'd26138;
      8'd151: entry_88 = 15'd26259;
      8'd152: entry_88 = 15'd26378;
      8'd153: entry_88 = 15'd26497;
      8'd154: entry_88 = 15'd26615;
      8'd155: entry_88 = 15'd26732;
      8'd156: entry_88 = 15'd26848;
      8'd157: entry_88 = 15'd26962;
      8'd158: entry_88 = 15'd27076;
      8'd159: entry_88 = 15'd27189;
      8'd160: entry_88 = 15'd27300;
      8'd161: entry_88 = 15'd27411;
      8'd162: entry_88 = 15'd27521;
      8'd163: entry_88 = 15'd27629;
      8'd164: entry_88 = 15'd27737;
      8'd165: entry_88 = 15'd27843;
      8'd166: entry_88 = 15'd27949;
      8'd167: entry_88 = 15'd28053;
      8'd168: entry_88 = 15'd28157;
      8'd169: entry_88 = 15'd28259;
      8'd170: entry_88 = 15'd28360;
      8'd171: entry_88 = 15'd28460;
      8'd172: entry_88 = 15'd28560;
      8'd173: entry_88 = 15'd28658;
      8'd174: entry_88 = 15'd28755;
      8'd175: entry_88 = 15'd28850;
      8'd176: entry_88 = 15'd28945;
      8'd177: entry_88 = 15'd29039;
      8'd178: entry_88 = 15'd29131;
      8'd179: entry_88 = 15'd29223;
      8'd180: entry_88 = 15'd29313;
      8'd181: entry_88 = 15'd29403;
      8'd182: entry_88 = 15'd29491;
      8'd183: entry_88 = 15'd29578;
      8'd184: entry_88 = 15'd29664;
      8'd185: entry_88 = 15'd29749;
      8'd186: entry_88 = 15'd29832;
      8'd187: entry_88 = 15'd29915;
      8'd188: entry_88 = 15'd29997;
      8'd189: entry_88 = 15'd30077;
      8'd190: entry_88 = 15'd30156;
      8'd191: entry_88 = 15'd30234;
      8'd192: entry_88 = 15'd30311;
      8'd193: entry_88 = 15'd30387;
      8'd194: entry_88 = 15'd30462;
      8'd195: entry_88 = 15'd30535;
      8'd196: entry_88 = 15'd30607;
      8'd197: entry_88 = 15'd30679;
      8'd198: entry_88 = 15'd30749;
      8'd199: entry_88 = 15'd30818;
      8'd200: entry_88 = 15'd30885;
      8'd201: entry_88 = 15'd30952;
      8'd202: entry_88 = 15'd31017;
      8'd203: entry_88 = 15'd31082;
      8'd204: entry_88 = 15'd31145;
      8'd205: entry_88 = 15'd31206;
      8'd206: entry_88 = 15'd31267;
      8'd207: entry_88 = 15'd31327;
      8'd208: entry_88 = 15'd31385;
      8'd209: entry_88 = 15'd31442;
      8'd210: entry_88 = 15'd31498;
      8'd211: entry_88 = 15'd31553;
      8'd212: entry_88 = 15'd31607;
      8'd213: entry_88 = 15'd31659;
      8'd214: entry_88 = 15'd31710;
      8'd215: entry_88 = 15'd31760;
      8'd216: entry_88 = 15'd31809;
      8'd217: entry_88 = 15'd31857;
      8'd218: entry_88 = 15'd31903;
      8'd219: entry_88 = 15'd31949;
      8'd220: entry_88 = 15'd31993;
      8'd221: entry_88 = 15'd32036;
      8'd222: entry_88 = 15'd32077;
      8'd223: entry_88 = 15'd32118;
      8'd224: entry_88 = 15'd32157;
      8'd225: entry_88 = 15'd32195;
      8'd226: entry_88 = 15'd32232;
      8'd227: entry_88 = 15'd32267;
      8'd228: entry_88 = 15'd32302;
      8'd229: entry_88 = 15'd32335;
      8'd230: entry_88 = 15'd32367;
      8'd231: entry_88 = 15'd32397;
      8'd232: entry_88 = 15'd32427;
      8'd233: entry_88 = 15'd32455;
      8'd234: entry_88 = 15'd32482;
      8'd235: entry_88 = 15'd32508;
      8'd236: entry_88 = 15'd32533;
      8'd237: entry_88 = 15'd32556;
      8'd238: entry_88 = 15'd32578;
      8'd239: entry_88 = 15'd32599;
      8'd240: entry_88 = 15'd32619;
      8'd241: entry_88 = 15'd32637;
      8'd242: entry_88 = 15'd32655;
      8'd243: entry_88 = 15'd32671;
      8'd244: entry_88 = 15'd32685;
      8'd245: entry_88 = 15'd32699;
      8'd246: entry_88 = 15'd32711;
      8'd247: entry_88 = 15'd32722;
      8'd248: entry_88 = 15'd32732;
      8'd249: entry_88 = 15'd32741;
      8'd250: entry_88 = 15'd32748;
      8'd251: entry_88 = 15'd32755;
      8'd252: entry_88 = 15'd32759;
      8'd253: entry_88 = 15'd32763;
      8'd254: entry_88 = 15'd32766;
      default: entry_88 = 15'd32767;
    endcase
  end

  wire [31:0] product_next = $signed(factor_a) * $signed(factor_b);  // line 91

  always_ff @(posedge clk) begin
    case (step)
      6'd0: begin
        logic [6:0] differ_66_2;
        logic [16:0] joined_68;
        logic [17:0] sum_68;
        differ_66_2 = {angle_i[5:0], 1'b0} ^ 7'h40;  // line 66
        joined_68 = {i_v_i, 1'b0};  // line 68
        sum_68 = {joined_68[16], joined_68} + {{2{i_u_i[15]}}, i_u_i};  // line 68
        step <= {5'd0, start_i};
        kept_0 <= sum_66[9];
        kept_1 <= angle_i[13:6] ^ {8{angle_i[14]}};
        kept_2 <= {1'b0, sum_68[14:0]};
        kept_3 <= sum_68[17:15];
        kept_4 <= sum_68[17];
        kept_5 <= sum_88[9];
        kept_6 <= ahead_i[13:6] ^ {8{sum_88[8]}};
        kept_7 <= {ahead_i[5:0], 1'b0} ^ 7'h40;
        kept_8 <= ahead_i[13:6] ^ {8{ahead_i[14]}};
        kQuarterWave_entry <= entry_88;
        factor_a <= {{9{differ_66_2[6]}}, differ_66_2};
        factor_b <= 16'd402;
      end
      6'd1, 6'd2, 6'd3, 6'd4: begin
        logic [15:0] difference_66;
        difference_66 = -{1'b0, kQuarterWave_entry};  // line 66
        case (step)
          6'd1: begin
            step <= step + 6'd1;
            if (kept_0) begin
              kept_2 <= difference_66;
            end else begin
              kept_2 <= {1'b0, kQuarterWave_entry};
            end
            kQuarterWave_entry <= entry_88;
            factor_a <= {1'b0, kept_2[14:0]};
            factor_b <= 16'd18919;
          end
          6'd2: begin
            step <= step + 6'd1;
            kept_9 <= {1'b0, wide_66_2};
            if (angle_i[15]) begin
              kept_10 <= difference_66;
              factor_b <= difference_66;
            end else begin
              kept_10 <= {1'b0, kQuarterWave_entry};
              factor_b <= {1'b0, kQuarterWave_entry};
            end
            kQuarterWave_entry <= entry_88;
            factor_a <= product[15:0];
          end
          6'd3: begin
            step <= step + 6'd1;
            kept_9 <= {18'd0, product[29:15]};
            if (kept_5) begin
              kept_11 <= difference_66;
            end else begin
              kept_11 <= {1'b0, kQuarterWave_entry};
            end
            kQuarterWave_entry <= entry_88;
            factor_a <= kept_9[15:0];
            factor_b <= kept_2;
          end
          default: begin  // 6'd4
            logic [16:0] difference_66_2;
            difference_66_2 = wide_66 - wide_66_4;  // line 66
            step <= step + 6'd1;
            kept_0 <= difference_66_2[16:15] == 2'd3;
            kept_2 <= difference_66_2[15:0];
            kept_3 <= {2'd0, difference_66_2[16]};
            kept_5 <= difference_66_2[16:15] == 2'd0;
            kept_12 <= {2'd0, ahead_i[15] ? difference_66 : {1'b0, kQuarterWave_entry}};
            factor_a <= {{13{kept_3[2]}}, kept_3};
            factor_b <= 16'd18919;
          end
        endcase
      end
      6'd5, 6'd6: begin
        logic [15:0] _cosine;
        logic [31:0] wide_69;
        _cosine =  // line 66
            kept_3[0] ? (kept_0 ? kept_2 : 16'd32768) :
            kept_5 ? kept_2 :
            16'd32767;
        wide_69 = {{16{_cosine[15]}}, _cosine};  // line 69
        case (step)
          6'd5: begin
            logic [16:0] sum_66_3;
            sum_66_3 = wide_66_5 + wide_66_4;  // line 66
            step <= step + 6'd1;
            kept_0 <= sum_66_3[16:15] == 2'd3;
            kept_2 <= sum_66_3[15:0];
            kept_3 <= {2'd0, sum_66_3[16]};
            kept_5 <= sum_66_3[16:15] == 2'd0;
            kept_13 <= wide_69;
            factor_a <= i_u_i;
            if (kept_3[0]) begin
              if (kept_0) begin
                factor_b <= kept_2;
              end else begin
                factor_b <= 16'd32768;
              end
            end else if (kept_5) begin
              factor_b <= kept_2;
            end else begin
              factor_b <= 16'd32767;
            end
          end
          default: begin  // 6'd6
            logic [18:0] sum_68_2;
            sum_68_2 = {4'd0, kept_9[14:0]} + product[18:0];  // line 68
            step <= step + 6'd1;
            if (kept_4) begin
              logic [15:0] choice_68;
              choice_68 = (sum_68_2[18:15] == 4'd15) ? sum_68_2[15:0] : 16'd32768;  // line 68
              kept_9 <= {1'b0, {16{choice_68[15]}}, choice_68};
              if (sum_68_2[18:15] == 4'd15) begin
                factor_a <= sum_68_2[15:0];
              end else begin
                factor_a <= 16'd32768;
              end
            end else begin
              logic [15:0] choice_68_2;
              choice_68_2 = (sum_68_2[18:15] == 4'd0) ? sum_68_2[15:0] : 16'd32767;  // line 68
              kept_9 <= {1'b0, {16{choice_68_2[15]}}, choice_68_2};
              if (sum_68_2[18:15] == 4'd0) begin
                factor_a <= sum_68_2[15:0];
              end else begin
                factor_a <= 16'd32767;
              end
            end
            kept_14 <= wide_69;
            if (kept_3[0]) begin
              if (kept_0) begin
                factor_b <= kept_2;
              end else begin
                factor_b <= 16'd32768;
              end
            end else if (kept_5) begin
              factor_b <= kept_2;
            end else begin
              factor_b <= 16'd32767;
            end
          end
        endcase
      end
      6'd7: begin
        step <= step + 6'd1;
        kept_9 <= {1'b0, product};
        factor_a <= kept_9[15:0];
        factor_b <= kept_13[15:0];
      end
      6'd8: begin
        logic [32:0] product_2;
        product_2 = {kept_9[31], kept_9[31:0]} + wide_66_3;  // line 69
        step <= step + 6'd1;
        kept_0 <= product_2[32] && product_2[31:14] != 18'd262143;
        kept_9 <= product_2;
        factor_a <= i_u_i;
        factor_b <= kept_14[15:0];
      end
      6'd9: begin
        step <= step + 6'd1;
        if (kept_0) begin
          if (sum_116[33:30] == 4'd15) begin
            kept_2 <= sum_116[30:15];
          end else begin
            kept_2 <= 16'd32768;
          end
        end else if (sum_116[33:30] == 4'd0) begin
          kept_2 <= sum_116[30:15];
        end else begin
          kept_2 <= 16'd32767;
        end
        kept_13 <= product;
        factor_a <= speed_i;
        factor_b <= {1'b0, inductance_i};
      end
      6'd10: begin
        logic [32:0] product_3;
        logic [16:0] wide_2;
        logic [31:0] wide_3;
        product_3 = {kept_13[31], kept_13} - wide_66_3;  // line 70
        wide_2 = {difference_75[15], difference_75[15:0]};
        wide_3 = {1'b0, {14{wide_2[16]}}, wide_2};
        step <= step + 6'd1;
        kept_0 <= product_3[32] && product_3[31:14] != 18'd262143;
        kept_4 <= error[15];
        kept_9 <= product_3;
        if (difference_75[16]) begin
          if (difference_75[16:15] == 2'd3) begin
            kept_13 <= wide_3;
            factor_a <= difference_75[15:0];
          end else begin
            kept_13 <= 32'd2147450880;
            factor_a <= 16'd32768;
          end
        end else if (difference_75[16:15] == 2'd0) begin
          kept_13 <= wide_3;
          factor_a <= difference_75[15:0];
        end else begin
          kept_13 <= 32'd32767;
          factor_a <= 16'd32767;
        end
        factor_b <= {1'b0, k_i_i};
      end
      6'd11, 6'd17: begin
        logic both_72;
        both_72 = product[30] && product[29:9] != 21'd2097151;  // line 72
        case (step)
          6'd11: begin
            logic [15:0] i_gamma;
            logic [16:0] wide;
            i_gamma =  // line 116
                kept_0 ? ((sum_116[33:30] == 4'd15) ? sum_116[30:15] : 16'd32768) :
                (sum_116[33:30] == 4'd0) ? sum_116[30:15] :
                16'd32767;
            wide = {1'b0, i_gamma};
            step <= step + 6'd1;
            if (both_72) begin
              if (sum_72[31:25] == 7'd127) begin
                kept_10 <= sum_72[25:10];
              end else begin
                kept_10 <= 16'd32768;
              end
            end else if (sum_72[31:25] == 7'd0) begin
              kept_10 <= sum_72[25:10];
            end else begin
              kept_10 <= 16'd32767;
            end
            kept_13 <= {1'b0, {14{wide[16]}}, wide};
            factor_a <= {1'b0, k_p_i};
            factor_b <= kept_13[15:0];
          end
          default: begin  // 6'd17
            logic [15:0] choice_77;
            choice_77 = kept_18[15] ? -kept_18 : kept_18;  // line 77
            step <= step + 6'd1;
            kept_4 <= choice_77[15];
            kept_17 <= choice_77[14:0];
            if (both_72) begin
              if (sum_72[31:25] == 7'd127) begin
                kept_19 <= sum_72[25:10];
              end else begin
                kept_19 <= 16'd32768;
              end
            end else if (sum_72[31:25] == 7'd0) begin
              kept_19 <= sum_72[25:10];
            end else begin
              kept_19 <= 16'd32767;
            end
            factor_a <= kept_11;
            factor_b <= kept_14[15:0];
          end
        endcase
      end
      6'd12: begin
        logic [28:0] sum_122;
        logic [27:0] moved;
        logic [16:0] difference_85;
        logic [15:0] error_2;
        sum_122 = {integral_gamma[27], integral_gamma} + wide_122;  // line 122
        moved =  // line 122
            sum_122[28] ? ((sum_122[28:27] == 2'd3) ? sum_122[27:0] : 28'd134217728) :
            (sum_122[28:27] == 2'd0) ? sum_122[27:0] :
            28'd134217727;
        difference_85 = {set_delta_i[15], set_delta_i} - {kept_13[15], kept_13[15:0]};  // line 85
        error_2 =  // line 85
            difference_85[16] ?
            ((difference_85[16:15] == 2'd3) ? difference_85[15:0] : 16'd32768) :
            (difference_85[16:15] == 2'd0) ? difference_85[15:0] :
            16'd32767;
        step <= step + 6'd1;
        kept_9 <= {17'd0, error_2};
        kept_14 <= {4'd0, moved};
        factor_a <= kept_10;
        factor_b <= kept_13[15:0];
      end
      6'd13, 6'd28: begin
        logic [19:0] sum_123;
        sum_123 = {{4{kept_14[27]}}, kept_14[27:12]} + {product[30], product[30:12]};  // line 123
        case (step)
          6'd13: begin
            step <= step + 6'd1;
            kept_15 <= {1'b0, sum_123};
            factor_a <= {4'd0, v_dc_i};
            factor_b <= {1'b0, limit_i};
          end
          default: begin  // 6'd28
            logic [16:0] ahead_2;
            logic [20:0] wanted;
            ahead_2 = wide_66_5 + {kept_19[15], kept_19};  // line 86
            wanted = {sum_123[19], sum_123} + {{4{ahead_2[16]}}, ahead_2};  // line 123
            step <= step + 6'd1;
            if (kept_4) begin
              if (sum_116_3[33:30] == 4'd15) begin
                kept_10 <= sum_116_3[30:15];
              end else begin
                kept_10 <= 16'd32768;
              end
            end else if (sum_116_3[33:30] == 4'd0) begin
              kept_10 <= sum_116_3[30:15];
            end else begin
              kept_10 <= 16'd32767;
            end
            kept_23 <= {12'd0, wanted};
            factor_a <= set_delta_i;
            factor_b <= kept_15[15:0];
          end
        endcase
      end
      6'd14, 6'd24: begin
        logic both_116;
        both_116 = product[31] && product[30:14] != 17'd131071;  // line 116
        case (step)
          6'd14: begin
            step <= step + 6'd1;
            if (both_116) begin
              if (sum_116_2[32:30] == 3'd7) begin
                kept_16 <= sum_116_2[30:15];
              end else begin
                kept_16 <= 16'd32768;
              end
            end else if (sum_116_2[32:30] == 3'd0) begin
              kept_16 <= sum_116_2[30:15];
            end else begin
              kept_16 <= 16'd32767;
            end
            factor_a <= {{9{kept_7[6]}}, kept_7};
            factor_b <= 16'd402;
          end
          default: begin  // 6'd24
            logic [17:0] left;
            logic [14:0] choice_86;
            logic [14:0] limit;
            left = kept_4 ? kept_14[17:0] : kept_12;  // line 106
            choice_86 = (left[17:15] == 3'd0) ? left[14:0] : 15'd32767;  // line 86
            limit = left[17] ? 15'd0 : choice_86;  // line 86
            step <= step + 6'd1;
            if (both_116) begin
              if (sum_116_2[32:30] == 3'd7) begin
                kept_10 <= sum_116_2[30:15];
              end else begin
                kept_10 <= 16'd32768;
              end
            end else if (sum_116_2[32:30] == 3'd0) begin
              kept_10 <= sum_116_2[30:15];
            end else begin
              kept_10 <= 16'd32767;
            end
            if (left[17]) begin
              kept_16 <= 16'd0;
              kept_17 <= 15'd0;
            end else begin
              kept_16 <= {1'b0, choice_86};
              if (left[17:15] == 3'd0) begin
                kept_17 <= left[14:0];
              end else begin
                kept_17 <= 15'd32767;
              end
            end
            kept_20 <= -{1'b0, limit};
            factor_a <= set_gamma_i;
            factor_b <= kept_15[15:0];
          end
        endcase
      end
      6'd15: begin
        logic [16:0] ahead;
        logic [14:0] difference_76;
        ahead = -{kept_16[15], kept_16};  // line 76
        difference_76 = product[26:12] - {2'd0, product[26:14]};  // line 76
        step <= step + 6'd1;
        kept_15 <= {kept_15[19], kept_15[19:0]} + {{4{ahead[16]}}, ahead};
        kept_16 <= {1'b0, product[26:12]};
        kept_17 <= difference_76;
        kept_18 <= {1'b0, difference_76};
        kept_19 <= -{1'b0, difference_76};
        kept_20 <= {1'b0, product[26:12]} + {5'd0, product[26:16]};
        kept_21 <= {1'b0, product[26:12]} + {3'd0, product[26:14]};
        factor_a <= speed_i;
        factor_b <= {1'b0, emf_i};
      end
      6'd16: begin
        if (enable_i) begin
          logic below_125;
          logic at_most_124;
          below_125 = $signed(kept_15) < $signed({{5{kept_19[15]}}, kept_19});  // line 125
          at_most_124 = $signed(kept_15) <= $signed({6'd0, kept_17});  // line 124
          if (at_most_124 || kept_4) begin
            if (!(below_125 && kept_4)) begin
              integral_gamma <= kept_14[27:0];
            end
            if (at_most_124) begin
              if (below_125) begin
                kept_18 <= kept_19;
              end else begin
                kept_18 <= kept_15[15:0];
              end
            end
          end
          kept_0 <= $signed({6'd0, kept_17}) < $signed(kept_15) || below_125;
        end else begin
          integral_gamma <= 28'd0;
          kept_0 <= 1'b0;
          kept_18 <= 16'd0;
        end
        step <= step + 6'd1;
        kept_14 <= wide_66_2;
        factor_a <= product[15:0];
        factor_b <= kept_12[15:0];
      end
      6'd18: begin
        logic [16:0] difference_88;
        difference_88 = {kept_11[15], kept_11} - wide_66_4;  // line 88
        step <= step + 6'd1;
        kept_3 <= {2'd0, difference_88[16:15] == 2'd0};
        kept_5 <= difference_88[16:15] == 2'd3;
        kept_11 <= difference_88[15:0];
        kept_22 <= difference_88[16];
        factor_a <= {1'b0, kept_17};
        factor_b <= 16'd13;
      end
      6'd19: begin
        logic [16:0] sum_88_2;
        sum_88_2 = {kept_12[15], kept_12[15:0]} + wide_66_4;  // line 88
        step <= step + 6'd1;
        kept_3 <= {2'd0, sum_88_2[16]};
        kept_5 <= sum_88_2[16:15] == 2'd3;
        if (kept_22) begin
          if (!kept_5) begin
            kept_11 <= 16'd32768;
          end
        end else if (!kept_3[0]) begin
          kept_11 <= 16'd32767;
        end
        kept_12 <= {2'd0, sum_88_2[15:0]};
        kept_22 <= sum_88_2[16:15] == 2'd0;
        factor_a <= {15'd0, kept_4};
        factor_b <= 16'd65533;
      end
      6'd20: begin
        logic [15:0] _sine;
        _sine =  // line 88
            kept_3[0] ? (kept_5 ? kept_12[15:0] : 16'd32768) :
            kept_22 ? kept_12[15:0] :
            16'd32767;
        step <= step + 6'd1;
        kept_7 <= {3'd0, product[18:15]};
        kept_12 <= {7'd0, product[14:4]};
        kept_15 <= {5'd0, _sine};
        kept_17 <= {5'd0, product[14:5]};
        factor_a <= {1'b0, kept_17};
        factor_b <= 16'd9;
      end
      6'd21, 6'd23: begin
        logic [4:0] sum_79;
        sum_79 = {1'b0, kept_7[3:0]} + {1'b0, product[3:0]};  // line 79
        case (step)
          6'd21: begin
            logic [17:0] far;
            far = {2'd0, kept_20} - {3'd0, sum_79, kept_17[9:0]};  // line 82
            step <= step + 6'd1;
            kept_12 <= {2'd0, kept_21} - {2'd0, sum_79, kept_12[10:0]};
            kept_14 <= {14'd0, far};
            factor_a <= {15'd0, kept_4};
            factor_b <= 16'd65529;
          end
          default: begin  // 6'd23
            logic [16:0] near;
            logic [17:0] wide_106;
            near = {2'd0, kept_16[14:0]} - {3'd0, sum_79, kept_17[8:0]};  // line 81
            wide_106 = {near[16], near};  // line 106
            step <= step + 6'd1;
            kept_4 <= $signed(wide_106) < $signed(kept_12);
            kept_14 <= {14'd0, wide_106};
            factor_a <= kept_9[15:0];
            factor_b <= {1'b0, k_i_i};
          end
        endcase
      end
      6'd22: begin
        step <= step + 6'd1;
        kept_7 <= {3'd0, product[18:15]};
        if ($signed(kept_14[17:0]) < $signed(kept_12)) begin
          kept_12 <= kept_14[17:0];
        end
        kept_17 <= {6'd0, product[14:6]};
        factor_a <= kept_10;
        factor_b <= kept_2;
      end
      6'd25: begin
        logic [28:0] sum_122_2;
        logic [27:0] moved_2;
        sum_122_2 = {integral_delta[27], integral_delta} + wide_122;  // line 122
        moved_2 =  // line 122
            sum_122_2[28] ? ((sum_122_2[28:27] == 2'd3) ? sum_122_2[27:0] : 28'd134217728) :
            (sum_122_2[28:27] == 2'd0) ? sum_122_2[27:0] :
            28'd134217727;
        step <= step + 6'd1;
        kept_14 <= {4'd0, moved_2};
        factor_a <= set_delta_i;
        factor_b <= kept_11;
      end
      6'd26: begin
        step <= step + 6'd1;
        kept_23 <= {1'b0, product};
        factor_a <= kept_9[15:0];
        factor_b <= {1'b0, k_p_i};
      end
      6'd27: begin
        logic [32:0] product_6;
        product_6 = {kept_23[31], kept_23[31:0]} + wide_66_3;  // line 90
        step <= step + 6'd1;
        kept_4 <= product_6[32] && product_6[31:14] != 18'd262143;
        kept_23 <= product_6;
        factor_a <= set_gamma_i;
        factor_b <= kept_11;
      end
      6'd29: begin
        if (enable_i) begin
          logic below_125_2;
          logic at_most_124_2;
          below_125_2 = $signed(kept_23[20:0]) < $signed({{5{kept_20[15]}}, kept_20});  // line 125
          at_most_124_2 = $signed(kept_23[20:0]) <= $signed({6'd0, kept_17});  // line 124
          if (at_most_124_2 || kept_9[15]) begin
            if (!(below_125_2 && kept_9[15])) begin
              integral_delta <= kept_14[27:0];
            end
            if (at_most_124_2) begin
              if (below_125_2) begin
                kept_16 <= kept_20;
              end else begin
                kept_16 <= kept_23[15:0];
              end
            end
          end
          kept_0 <= kept_0 || $signed({6'd0, kept_17}) < $signed(kept_23[20:0]) || below_125_2;
        end else begin
          integral_delta <= 28'd0;
          kept_16 <= 16'd0;
        end
        step <= step + 6'd1;
        kept_14 <= product;
        factor_a <= kept_18;
        factor_b <= kept_11;
      end
      6'd30, 6'd32: begin
        logic [32:0] product_4;
        logic both_116_2;
        product_4 = wide_92 - wide_66_3;  // line 92
        both_116_2 = product_4[32] && product_4[31:14] != 18'd262143;  // line 116
        case (step)
          6'd30: begin
            step <= step + 6'd1;
            kept_4 <= both_116_2;
            kept_9 <= product_4;
            factor_a <= kept_16;
            factor_b <= kept_15[15:0];
          end
          default: begin  // 6'd32
            step <= step + 6'd1;
            kept_4 <= both_116_2;
            kept_9 <= product_4;
            factor_a <= kept_16;
            factor_b <= kept_11;
          end
        endcase
      end
      6'd31: begin
        step <= step + 6'd1;
        kept_14 <= product;
        if (kept_4) begin
          if (sum_116[33:30] == 4'd15) begin
            kept_18 <= sum_116[30:15];
          end else begin
            kept_18 <= 16'd32768;
          end
        end else if (sum_116[33:30] == 4'd0) begin
          kept_18 <= sum_116[30:15];
        end else begin
          kept_18 <= 16'd32767;
        end
        factor_a <= kept_18;
        factor_b <= kept_15[15:0];
      end
      6'd33: begin
        step <= step + 6'd1;
        if (kept_4) begin
          if (sum_116[33:30] == 4'd15) begin
            kept_10 <= sum_116[30:15];
          end else begin
            kept_10 <= 16'd32768;
          end
        end else if (sum_116[33:30] == 4'd0) begin
          kept_10 <= sum_116[30:15];
        end else begin
          kept_10 <= 16'd32767;
        end
        kept_14 <= product;
        factor_a <= kept_10;
        factor_b <= 16'd28378;
      end
      6'd34: begin
        logic [32:0] product_5;
        product_5 = wide_92 + wide_66_3;  // line 93
        step <= step + 6'd1;
        kept_4 <= product_5[32] && product_5[31:14] != 18'd262143;
        kept_9 <= product_5;
      end
      6'd35: begin
        logic [18:0] difference_97;
        difference_97 = {sum_116_2[32], sum_116_2[32:15]} - {{4{kept_18[15]}}, kept_18[15:1]};
        step <= step + 6'd1;
        kept_4 <= difference_97[18];
        kept_7 <= {3'd0, difference_97[18:15]};
        if (kept_4) begin
          if (sum_116[33:30] == 4'd15) begin
            kept_11 <= sum_116[30:15];
          end else begin
            kept_11 <= 16'd32768;
          end
        end else if (sum_116[33:30] == 4'd0) begin
          kept_11 <= sum_116[30:15];
        end else begin
          kept_11 <= 16'd32767;
        end
        kept_16 <= difference_97[15:0];
      end
      6'd36: begin
        step <= 6'd0;
        v_alpha_held <= kept_10;
        v_beta_held <= kept_11;
        i_gamma_held <= kept_2;
        i_delta_held <= kept_13[15:0];
        wanted_u_held <= kept_18;
        if (kept_4) begin
          if (kept_7[3:0] == 4'd15) begin
            wanted_v_held <= kept_16;
          end else begin
            wanted_v_held <= 16'd32768;
          end
        end else if (kept_7[3:0] == 4'd0) begin
          wanted_v_held <= kept_16;
        end else begin
          wanted_v_held <= 16'd32767;
        end
        limited_held <= kept_0;
      end
      default: step <= step + 6'd1;
    endcase
    product <= product_next;  // line 91
    done <= step == 6'd36;
    missed <= start_i && step != 6'd0;
    if (rst) begin
      integral_gamma <= 28'sd0;
      integral_delta <= 28'sd0;
      step <= 6'd0;
      kept_0 <= 1'b0;
      kept_1 <= 8'd0;
      kept_2 <= 16'd0;
      kept_3 <= 3'd0;
      kept_4 <= 1'b0;
      kept_5 <= 1'b0;
      kept_6 <= 8'd0;
      kept_7 <= 7'd0;
      kept_8 <= 8'd0;
      kept_9 <= 33'd0;
      kept_10 <= 16'd0;
      kept_11 <= 16'd0;
      kept_12 <= 18'd0;
      kept_13 <= 32'd0;
      kept_14 <= 32'd0;
      kept_15 <= 21'd0;
      kept_16 <= 16'd0;
      kept_17 <= 15'd0;
      kept_18 <= 16'd0;
      kept_19 <= 16'd0;
      kept_20 <= 16'd0;
      kept_21 <= 16'd0;
      kept_22 <= 1'b0;
      kept_23 <= 33'd0;
      kQuarterWave_entry <= 15'd0;
      factor_a <= 16'd0;
      factor_b <= 16'd0;
      product <= 32'd0;
      v_alpha_held <= 16'sd0;
      v_beta_held <= 16'sd0;
      i_gamma_held <= 16'sd0;
      i_delta_held <= 16'sd0;
      wanted_u_held <= 16'sd0;
      wanted_v_held <= 16'sd0;
      limited_held <= 1'b0;
      done <= 1'b0;
      missed <= 1'b0;
    end
  end

  assign v_alpha_o = v_alpha_held;
  assign v_beta_o = v_beta_held;
  assign i_gamma_o = i_gamma_held;
  assign i_delta_o = i_delta_held;
  assign wanted_u_o = wanted_u_held;
  assign wanted_v_o = wanted_v_held;
  assign limited_o = limited_held;
  assign done_o = done;
  assign busy_o = step != 6'd0;
  assign missed_o = missed;

  // What nothing reads, for the linters.
  wire unused =
      &{1'b0, sum_66[7:0], sum_66_2[22:0], sum_116[14:0], error[14:0], sum_72[9:0],
      sum_116_2[14:0], sum_88[7:0], sum_116_3[14:0]};
endmodule
