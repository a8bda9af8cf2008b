// current_control: steplock::CurrentControl, printed by hlsgen from hls/sinusoidal/current_control.hpp:35.
// A sample takes 37 clocks, and in no order fewer than 37: 253 operations, 34 products, 4 entries of tables
// on 1 multiplier of 16 x 16 bits; 573 register bits, 333 of them between steps.
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
    input  logic [14:0] inductance_i,  // u3.12, voltage per current and speed
    input  logic [14:0] emf_i,  // u3.12, voltage per speed
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
  logic kept_0;  // in steps 1-1, 5-5, 6-6, 9-9, 11-11, 13-29, 30-36
  logic [7:0] kept_1;  // in steps 1-1
  logic [15:0] kept_2;  // in steps 1-1, 2-4, 5-5 sine, 6-6 sine, 10-36 i_gamma
  logic [2:0] kept_3;  // in steps 1-4, 5-5, 6-6, 18-18, 19-19
  logic kept_4;  // in steps 1-6, 11-16, 17-29, 31-31, 33-33, 35-35, 36-36
  logic kept_5;  // in steps 1-3, 5-5, 6-6, 17-17, 18-18, 19-19, 23-23, 28-28
  logic [7:0] kept_6;  // in steps 1-2
  logic [6:0] kept_7;  // in steps 1-11, 20-20, 22-22, 36-36
  logic [7:0] kept_8;  // in steps 1-3
  logic [32:0] kept_9;  // in steps 3-3, 4-6, 7-7, 8-8, 9-9 product, 11-11 product, 13-17 moved, 18-19, 20-31 _sine, 33-33 product, 35-35 product
  logic [16:0] kept_10;  // in steps 3-5, 12-22 coupling, 24-25 emf, 26-28 ahead
  logic [15:0] kept_11;  // in steps 4-17, 18-18 sine_then, 19-32 _cosine, 34-36
  logic [17:0] kept_12;  // in steps 5-18, 19-19 sine_then, 20-20, 21-23 far, 24-29
  logic [31:0] kept_13;  // in steps 6-7, 10-10, 11-13, 14-16, 17-31, 32-32, 34-34
  logic [31:0] kept_14;  // in steps 7-8, 12-36 i_delta
  logic [15:0] kept_15;  // in steps 13-26 error, 29-33 ask_beta, 36-36
  logic [20:0] kept_16;  // in steps 15-15, 16-16 wanted, 17-22 limit, 23-23, 24-29
  logic [15:0] kept_17;  // in steps 17-20, 22-22, 24-29 limit, 30-32 delta_voltage, 36-36
  logic kept_18;  // in steps 18-18, 19-19
  logic kept_19;  // in steps 18-20
  logic [15:0] kept_20;  // in steps 25-25, 32-36 ask_alpha
  logic [27:0] kept_21;  // in steps 26-29 moved
  logic [32:0] kept_22;  // in steps 27-27, 28-28 product, 29-29 wanted, 30-30, 31-31 product
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

  wire [9:0] sum_65 = angle_i[15:6] + 10'd256;  // line 65
  wire [7:0] differ_65 = angle_i[13:6] ^ {8{sum_65[8]}};  // line 65
  wire [16:0] wide_65 = {kept_2[15], kept_2};  // line 65
  wire [32:0] wide_65_2 = {product[31], product};  // line 65
  wire [32:0] sum_65_2 = wide_65_2 + 33'd4194304;  // line 65
  wire [16:0] wide_65_3 = {{7{sum_65_2[32]}}, sum_65_2[32:23]};  // line 65
  wire [16:0] wide_65_4 = {kept_10[15], kept_10[15:0]};  // line 65
  wire [33:0] sum_112 = {kept_9[32], kept_9} + 34'd16384;  // line 112
  wire [16:0] difference_74 = {set_gamma_i[15], set_gamma_i} - wide_65;  // line 74
  wire [15:0] choice_74 = (difference_74[16:15] == 2'd3) ? difference_74[15:0] : 16'd32768;
  wire [15:0] choice_74_2 = (difference_74[16:15] == 2'd0) ? difference_74[15:0] : 16'd32767;
  wire [15:0] error = difference_74[16] ? choice_74 : choice_74_2;  // line 74
  wire [28:0] wide_118 = {product[30], product[30:3]};  // line 118
  wire [19:0] wide_119 = {product[30], product[30:12]};  // line 119
  wire [31:0] sum_71 = {product[30], product[30:0]} + 32'd2048;  // line 71
  wire [32:0] wide_69 = {kept_13[31], kept_13};  // line 69
  wire [32:0] sum_112_2 = wide_65_2 + 33'd16384;  // line 112
  wire [9:0] sum_86 = ahead_i[15:6] + 10'd256;  // line 86
  wire [16:0] difference_83 = {set_delta_i[15], set_delta_i} - {kept_14[15], kept_14[15:0]};
  wire [15:0] error_2 =  // line 83
      difference_83[16] ? ((difference_83[16:15] == 2'd3) ? difference_83[15:0] : 16'd32768) :
      (difference_83[16:15] == 2'd0) ? difference_83[15:0] :
      16'd32767;
  wire [32:0] wide_87 = {kept_22[31], kept_22[31:0]};  // line 87
  wire [33:0] sum_112_3 = {kept_22[32], kept_22} + 34'd16384;  // line 112

  logic [7:0] choice_86;  // line 86
  always_comb begin
    case (step)
      6'd0: choice_86 = differ_65;
      6'd1: choice_86 = kept_1;
      6'd2: choice_86 = kept_6;
      default: choice_86 = kept_8;
    endcase
  end

  logic [14:0] entry_86;  // kQuarterWave
  always_comb begin
    case (choice_86)
      8'd0: entry_86 = 15'd101;
      8'd1: entry_86 = 15'd302;
      8'd2: entry_86 = 15'd503;
      8'd3: entry_86 = 15'd704;
      8'd4: entry_86 = 15'd905;
      8'd5: entry_86 = 15'd1106;
      8'd6: entry_86 = 15'd1307;
      8'd7: entry_86 = 15'd1507;
      8'd8: entry_86 = 15'd1708;
      8'd9: entry_86 = 15'd1909;
      8'd10: entry_86 = 15'd2110;
      8'd11: entry_86 = 15'd2310;
      8'd12: entry_86 = 15'd2511;
      8'd13: entry_86 = 15'd2711;
      8'd14: entry_86 = 15'd2911;
      8'd15: entry_86 = 15'd3112;
      8'd16: entry_86 = 15'd3312;
      8'd17: entry_86 = 15'd3512;
      8'd18: entry_86 = 15'd3712;
      8'd19: entry_86 = 15'd3911;
      8'd20: entry_86 = 15'd4111;
      8'd21: entry_86 = 15'd4310;
      8'd22: entry_86 = 15'd4509;
      8'd23: entry_86 = 15'd4708;
      8'd24: entry_86 = 15'd4907;
      8'd25: entry_86 = 15'd5106;
      8'd26: entry_86 = 15'd5305;
      8'd27: entry_86 = 15'd5503;
      8'd28: entry_86 = 15'd5701;
      8'd29: entry_86 = 15'd5899;
      8'd30: entry_86 = 15'd6096;
      8'd31: entry_86 = 15'd6294;
      8'd32: entry_86 = 15'd6491;
      8'd33: entry_86 = 15'd6688;
      8'd34: entry_86 = 15'd6885;
      8'd35: entry_86 = 15'd7081;
      8'd36: entry_86 = 15'd7277;
      8'd37: entry_86 = 15'd7473;
      8'd38: entry_86 = 15'd7669;
      8'd39: entry_86 = 15'd7864;
      8'd40: entry_86 = 15'd8059;
      8'd41: entry_86 = 15'd8254;
      8'd42: entry_86 = 15'd8448;
      8'd43: entry_86 = 15'd8642;
      8'd44: entry_86 = 15'd8836;
      8'd45: entry_86 = 15'd9030;
      8'd46: entry_86 = 15'd9223;
      8'd47: entry_86 = 15'd9416;
      8'd48: entry_86 = 15'd9608;
      8'd49: entry_86 = 15'd9800;
      8'd50: entry_86 = 15'd9992;
      8'd51: entry_86 = 15'd10183;
      8'd52: entry_86 = 15'd10374;
      8'd53: entry_86 = 15'd10564;
      8'd54: entry_86 = 15'd10754;
      8'd55: entry_86 = 15'd10944;
      8'd56: entry_86 = 15'd11133;
      8'd57: entry_86 = 15'd11322;
      8'd58: entry_86 = 15'd11511;
      8'd59: entry_86 = 15'd11699;
      8'd60: entry_86 = 15'd11886;
      8'd61: entry_86 = 15'd12074;
      8'd62: entry_86 = 15'd12260;
      8'd63: entry_86 = 15'd12446;
      8'd64: entry_86 = 15'd12632;
      8'd65: entry_86 = 15'd12817;
      8'd66: entry_86 = 15'd13002;
      8'd67: entry_86 = 15'd13187;
      8'd68: entry_86 = 15'd13370;
      8'd69: entry_86 = 15'd13554;
      8'd70: entry_86 = 15'd13736;
      8'd71: entry_86 = 15'd13919;
      8'd72: entry_86 = 15'd14101;
      8'd73: entry_86 = 15'd14282;
      8'd74: entry_86 = 15'd14462;
      8'd75: entry_86 = 15'd14643;
      8'd76: entry_86 = 15'd14822;
      8'd77: entry_86 = 15'd15001;
      8'd78: entry_86 = 15'd15180;
      8'd79: entry_86 = 15'd15358;
      8'd80: entry_86 = 15'd15535;
      8'd81: entry_86 = 15'd15712;
      8'd82: entry_86 = 15'd15888;
      8'd83: entry_86 = 15'd16063;
      8'd84: entry_86 = 15'd16238;
      8'd85: entry_86 = 15'd16413;
      8'd86: entry_86 = 15'd16586;
      8'd87: entry_86 = 15'd16759;
      8'd88: entry_86 = 15'd16932;
      8'd89: entry_86 = 15'd17104;
      8'd90: entry_86 = 15'd17275;
      8'd91: entry_86 = 15'd17445;
      8'd92: entry_86 = 15'd17615;
      8'd93: entry_86 = 15'd17784;
      8'd94: entry_86 = 15'd17953;
      8'd95: entry_86 = 15'd18121;
      8'd96: entry_86 = 15'd18288;
      8'd97: entry_86 = 15'd18454;
      8'd98: entry_86 = 15'd18620;
      8'd99: entry_86 = 15'd18785;
      8'd100: entry_86 = 15'd18950;
      8'd101: entry_86 = 15'd19113;
      8'd102: entry_86 = 15'd19276;
      8'd103: entry_86 = 15'd19438;
      8'd104: entry_86 = 15'd19600;
      8'd105: entry_86 = 15'd19761;
      8'd106: entry_86 = 15'd19921;
      8'd107: entry_86 = 15'd20080;
      8'd108: entry_86 = 15'd20238;
      8'd109: entry_86 = 15'd20396;
      8'd110: entry_86 = 15'd20553;
      8'd111: entry_86 = 15'd20709;
      8'd112: entry_86 = 15'd20865;
      8'd113: entry_86 = 15'd21019;
      8'd114: entry_86 = 15'd21173;
      8'd115: entry_86 = 15'd21326;
      8'd116: entry_86 = 15'd21479;
      8'd117: entry_86 = 15'd21630;
      8'd118: entry_86 = 15'd21781;
      8'd119: entry_86 = 15'd21930;
      8'd120: entry_86 = 15'd22079;
      8'd121: entry_86 = 15'd22227;
      8'd122: entry_86 = 15'd22375;
      8'd123: entry_86 = 15'd22521;
      8'd124: entry_86 = 15'd22667;
      8'd125: entry_86 = 15'd22812;
      8'd126: entry_86 = 15'd22956;
      8'd127: entry_86 = 15'd23099;
      8'd128: entry_86 = 15'd23241;
      8'd129: entry_86 = 15'd23382;
      8'd130: entry_86 = 15'd23522;
      8'd131: entry_86 = 15'd23662;
      8'd132: entry_86 = 15'd23801;
      8'd133: entry_86 = 15'd23938;
      8'd134: entry_86 = 15'd24075;
      8'd135: entry_86 = 15'd24211;
      8'd136: entry_86 = 15'd24346;
      8'd137: entry_86 = 15'd24480;
      8'd138: entry_86 = 15'd24613;
      8'd139: entry_86 = 15'd24746;
      8'd140: entry_86 = 15'd24877;
      8'd141: entry_86 = 15'd25007;
      8'd142: entry_86 = 15'd25137;
      8'd143: entry_86 = 15'd25265;
      8'd144: entry_86 = 15'd25393;
      8'd145: entry_86 = 15'd25519;
      8'd146: entry_86 = 15'd25645;
      8'd147: entry_86 = 15'd25770;
      8'd148: entry_86 = 15'd25893;
      8'd149: entry_86 = 15'd26016;
      8'd150: entry_86 = 15'd26138;
      8'd151: entry_86 = 15'd26259;
      8'd152: entry_86 = 15'd26378;
      8'd153: entry_86 = 15'd26497;
      8'd154: entry_86 = 15'd26615;
      8'd155: entry_86 = 15'd26732;
      8'd156: entry_86 = 15'd26848;
      8'd157: entry_86 = 15'd26962;
      8'd158: entry_86 = 15'd27076;
      8'd159: entry_86 = 15'd27189;
      8'd160: entry_86 = 15'd27300;
      8'd161: entry_86 = 15'd27411;
      8'd162: entry_86 = 15'd27521;
      8'd163: entry_86 = 15'd27629;
      8'd164: entry_86 = 15'd27737;
      8'd165: entry_86 = 15'd27843;
      8'd166: entry_86 = 15'd27949;
      8'd167: entry_86 = 15'd28053;
      8'd168: entry_86 = 15'd28157;
      8'd169: entry_86 = 15'd28259;
      8'd170: entry_86 = 15'd28360;
      8'd171: entry_86 = 15'd28460;
      8'd172: entry_86 = 15'd28560;
      8'd173: entry_86 = 15'd28658;
      8'd174: entry_86 = 15'd28755;
      8'd175: entry_86 = 15'd28850;
      8'd176: entry_86 = 15'd28945;
      8'd177: entry_86 = 15'd29039;
      8'd178: entry_86 = 15'd29131;
      8'd179: entry_86 = 15'd29223;
      8'd180: entry_86 = 15'd29313;
      8'd181: entry_86 = 15'd29403;
      8'd182: entry_86 = 15'd29491;
      8'd183: entry_86 = 15'd29578;
      8'd184: entry_86 = 15'd29664;
      8'd185: entry_86 = 15'd29749;
      8'd186: entry_86 = 15'd29832;
      8'd187: entry_86 = 15'd29915;
      8'd188: entry_86 = 15'd29997;
      8'd189: entry_86 = 15'd30077;
      8'd190: entry_86 = 15'd30156;
      8'd191: entry_86 = 15'd30234;
      8'd192: entry_86 = 15'd30311;
      8'd193: entry_86 = 15'd30387;
      8'd194: entry_86 = 15'd30462;
      8'd195: entry_86 = 15'd30535;
      8'd196: entry_86 = 15'd30607;
      8'd197: entry_86 = 15'd30679;
      8'd198: entry_86 = 15'd30749;
      8'd199: entry_86 = 15'd30818;
      8'd200: entry_86 = 15'd30885;
      8'd201: entry_86 = 15'd30952;
      8'd202: entry_86 = 15'd31017;
      8'd203: entry_86 = 15'd31082;
      8'd204: entry_86 = 15'd31145;
      8'd205: entry_86 = 15'd31206;
      8'd206: entry_86 = 15'd31267;
      8'd207: entry_86 = 15'd31327;
      8'd208: entry_86 = 15'd31385;
      8'd209: entry_86 = 15'd31442;
      8'd210: entry_86 = 15'd31498;
      8'd211: entry_86 = 15'd31553;
      8'd212: entry_86 = 15'd31607;
      8'd213: entry_86 = 15'd31659;
      8'd214: entry_86 = 15'd31710;
      8'd215: entry_86 = 15'd31760;
      8'd216: entry_86 = 15'd31809;
      8'd217: entry_86 = 15'd31857;
      8'd218: entry_86 = 15'd31903;
      8'd219: entry_86 = 15'd31949;
      8'd220: entry_86 = 15'd31993;
      8'd221: entry_86 = 15'd32036;
      8'd222: entry_86 = 15'd32077;
      8'd223: entry_86 = 15'd32118;
      8'd224: entry_86 = 15'd32157;
      8'd225: entry_86 = 15'd32195;
      8'd226: entry_86 = 15'd32232;
      8'd227: entry_86 = 15'd32267;
      8'd228: entry_86 = 15'd32302;
      8'd229: entry_86 = 15'd32335;
      8'd230: entry_86 = 15'd32367;
      8'd231: entry_86 = 15'd32397;
      8'd232: entry_86 = 15'd32427;
      8'd233: entry_86 = 15'd32455;
      8'd234: entry_86 = 15'd32482;
      8'd235: entry_86 = 15'd32508;
      8'd236: entry_86 = 15'd32533;
      8'd237: entry_86 = 15'd32556;
      8'd238: entry_86 = 15'd32578;
      8'd239: entry_86 = 15'd32599;
      8'd240: entry_86 = 15'd32619;
      8'd241: entry_86 = 15'd32637;
      8'd242: entry_86 = 15'd32655;
      8'd243: entry_86 = 15'd32671;
      8'd244: entry_86 = 15'd32685;
      8'd245: entry_86 = 15'd32699;
      8'd246: entry_86 = 15'd32711;
      8'd247: entry_86 = 15'd32722;
      8'd248: entry_86 = 15'd32732;
      8'd249: entry_86 = 15'd32741;
      8'd250: entry_86 = 15'd32748;
      8'd251: entry_86 = 15'd32755;
      8'd252: entry_86 = 15'd32759;
      8'd253: entry_86 = 15'd32763;
      8'd254: entry_86 = 15'd32766;
      default: entry_86 = 15'd32767;
    endcase
  end

  wire [31:0] product_next = $signed(factor_a) * $signed(factor_b);  // line 89

  always_ff @(posedge clk) begin
    case (step)
      6'd0: begin
        logic [6:0] differ_65_2;
        logic [16:0] joined_67;
        logic [17:0] sum_67;
        differ_65_2 = {angle_i[5:0], 1'b0} ^ 7'h40;  // line 65
        joined_67 = {i_v_i, 1'b0};  // line 67
        sum_67 = {joined_67[16], joined_67} + {{2{i_u_i[15]}}, i_u_i};  // line 67
        step <= {5'd0, start_i};
        kept_0 <= sum_65[9];
        kept_1 <= angle_i[13:6] ^ {8{angle_i[14]}};
        kept_2 <= {1'b0, sum_67[14:0]};
        kept_3 <= sum_67[17:15];
        kept_4 <= sum_67[17];
        kept_5 <= sum_86[9];
        kept_6 <= ahead_i[13:6] ^ {8{sum_86[8]}};
        kept_7 <= {ahead_i[5:0], 1'b0} ^ 7'h40;
        kept_8 <= ahead_i[13:6] ^ {8{ahead_i[14]}};
        kQuarterWave_entry <= entry_86;
        factor_a <= {{9{differ_65_2[6]}}, differ_65_2};
        factor_b <= 16'd402;
      end
      6'd1, 6'd2, 6'd3, 6'd4: begin
        logic [15:0] difference_65;
        difference_65 = -{1'b0, kQuarterWave_entry};  // line 65
        case (step)
          6'd1: begin
            step <= step + 6'd1;
            if (kept_0) begin
              kept_2 <= difference_65;
            end else begin
              kept_2 <= {1'b0, kQuarterWave_entry};
            end
            kQuarterWave_entry <= entry_86;
            factor_a <= {1'b0, kept_2[14:0]};
            factor_b <= 16'd18919;
          end
          6'd2: begin
            step <= step + 6'd1;
            kept_9 <= {1'b0, {16{product[15]}}, product[15:0]};
            kept_10 <= {1'b0, angle_i[15] ? difference_65 : {1'b0, kQuarterWave_entry}};
            kQuarterWave_entry <= entry_86;
            factor_a <= product[15:0];
            if (angle_i[15]) begin
              factor_b <= difference_65;
            end else begin
              factor_b <= {1'b0, kQuarterWave_entry};
            end
          end
          6'd3: begin
            step <= step + 6'd1;
            kept_9 <= {18'd0, product[29:15]};
            if (kept_5) begin
              kept_11 <= difference_65;
            end else begin
              kept_11 <= {1'b0, kQuarterWave_entry};
            end
            kQuarterWave_entry <= entry_86;
            factor_a <= kept_9[15:0];
            factor_b <= kept_2;
          end
          default: begin  // 6'd4
            logic [16:0] difference_65_2;
            difference_65_2 = wide_65 - wide_65_3;  // line 65
            step <= step + 6'd1;
            kept_0 <= difference_65_2[16:15] == 2'd3;
            kept_2 <= difference_65_2[15:0];
            kept_3 <= {2'd0, difference_65_2[16]};
            kept_5 <= difference_65_2[16:15] == 2'd0;
            kept_12 <= {2'd0, ahead_i[15] ? difference_65 : {1'b0, kQuarterWave_entry}};
            factor_a <= {{13{kept_3[2]}}, kept_3};
            factor_b <= 16'd18919;
          end
        endcase
      end
      6'd5, 6'd6: begin
        logic [15:0] _cosine;
        logic [31:0] wide_68;
        _cosine =  // line 65
            kept_3[0] ? (kept_0 ? kept_2 : 16'd32768) :
            kept_5 ? kept_2 :
            16'd32767;
        wide_68 = {{16{_cosine[15]}}, _cosine};  // line 68
        case (step)
          6'd5: begin
            logic [16:0] sum_65_3;
            sum_65_3 = wide_65_4 + wide_65_3;  // line 65
            step <= step + 6'd1;
            kept_0 <= sum_65_3[16:15] == 2'd3;
            kept_2 <= sum_65_3[15:0];
            kept_3 <= {2'd0, sum_65_3[16]};
            kept_5 <= sum_65_3[16:15] == 2'd0;
            kept_13 <= wide_68;
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
            logic [18:0] sum_67_2;
            sum_67_2 = {4'd0, kept_9[14:0]} + product[18:0];  // line 67
            step <= step + 6'd1;
            if (kept_4) begin
              logic [15:0] choice_67;
              choice_67 = (sum_67_2[18:15] == 4'd15) ? sum_67_2[15:0] : 16'd32768;  // line 67
              kept_9 <= {1'b0, {16{choice_67[15]}}, choice_67};
              if (sum_67_2[18:15] == 4'd15) begin
                factor_a <= sum_67_2[15:0];
              end else begin
                factor_a <= 16'd32768;
              end
            end else begin
              logic [15:0] choice_67_2;
              choice_67_2 = (sum_67_2[18:15] == 4'd0) ? sum_67_2[15:0] : 16'd32767;  // line 67
              kept_9 <= {1'b0, {16{choice_67_2[15]}}, choice_67_2};
              if (sum_67_2[18:15] == 4'd0) begin
                factor_a <= sum_67_2[15:0];
              end else begin
                factor_a <= 16'd32767;
              end
            end
            kept_14 <= wide_68;
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
        product_2 = {kept_9[31], kept_9[31:0]} + wide_65_2;  // line 68
        step <= step + 6'd1;
        kept_0 <= product_2[32] && product_2[31:14] != 18'd262143;
        kept_9 <= product_2;
        factor_a <= i_u_i;
        factor_b <= kept_14[15:0];
      end
      6'd9: begin
        step <= step + 6'd1;
        if (kept_0) begin
          if (sum_112[33:30] == 4'd15) begin
            kept_2 <= sum_112[30:15];
          end else begin
            kept_2 <= 16'd32768;
          end
        end else if (sum_112[33:30] == 4'd0) begin
          kept_2 <= sum_112[30:15];
        end else begin
          kept_2 <= 16'd32767;
        end
        kept_13 <= product;
        factor_a <= speed_i;
        factor_b <= {1'b0, inductance_i};
      end
      6'd10, 6'd32: begin
        logic [32:0] product_3;
        logic both_112;
        product_3 = wide_69 - wide_65_2;  // line 69
        both_112 = product_3[32] && product_3[31:14] != 18'd262143;  // line 112
        case (step)
          6'd10: begin
            step <= step + 6'd1;
            kept_0 <= both_112;
            kept_4 <= error[15];
            kept_9 <= product_3;
            if (difference_74[16]) begin
              kept_13 <= {1'b0, {15{choice_74[15]}}, choice_74};
              if (difference_74[16:15] == 2'd3) begin
                factor_a <= difference_74[15:0];
              end else begin
                factor_a <= 16'd32768;
              end
            end else begin
              kept_13 <= {1'b0, {15{choice_74_2[15]}}, choice_74_2};
              if (difference_74[16:15] == 2'd0) begin
                factor_a <= difference_74[15:0];
              end else begin
                factor_a <= 16'd32767;
              end
            end
            factor_b <= {1'b0, k_i_i};
          end
          default: begin  // 6'd32
            step <= step + 6'd1;
            kept_4 <= both_112;
            kept_9 <= product_3;
            factor_a <= kept_17;
            factor_b <= kept_11;
          end
        endcase
      end
      6'd11, 6'd23: begin
        logic [15:0] coupling;
        coupling =  // line 71
            (product[30] && product[29:11] != 19'd524287) ?
            ((sum_71[31:27] == 5'd31) ? sum_71[27:12] : 16'd32768) :
            (sum_71[31:27] == 5'd0) ? sum_71[27:12] :
            16'd32767;
        case (step)
          6'd11: begin
            logic [15:0] i_gamma;
            i_gamma =  // line 112
                kept_0 ? ((sum_112[33:30] == 4'd15) ? sum_112[30:15] : 16'd32768) :
                (sum_112[33:30] == 4'd0) ? sum_112[30:15] :
                16'd32767;
            step <= step + 6'd1;
            kept_10 <= {1'b0, coupling};
            kept_14 <= {16'd0, i_gamma};
            factor_a <= {{9{kept_7[6]}}, kept_7};
            factor_b <= 16'd402;
          end
          default: begin  // 6'd23
            logic [17:0] left;
            logic [14:0] limit;
            logic [16:0] wide;
            left = kept_5 ? kept_16[17:0] : kept_12;  // line 82
            limit =  // line 84
                left[17] ? 15'd0 :
                (left[17:15] == 3'd0) ? left[14:0] :
                15'd32767;
            wide = {1'b0, -{1'b0, limit}};
            step <= step + 6'd1;
            kept_10 <= {1'b0, coupling};
            kept_12 <= {3'd0, limit};
            kept_16 <= {3'd0, wide[16], wide};
            kept_17 <= {1'b0, limit};
            factor_a <= kept_15;
            factor_b <= {1'b0, k_i_i};
          end
        endcase
      end
      6'd12: begin
        logic [28:0] sum_118;
        logic [27:0] moved;
        sum_118 = {integral_gamma[27], integral_gamma} + wide_118;  // line 118
        moved =  // line 118
            sum_118[28] ? ((sum_118[28:27] == 2'd3) ? sum_118[27:0] : 28'd134217728) :
            (sum_118[28:27] == 2'd0) ? sum_118[27:0] :
            28'd134217727;
        step <= step + 6'd1;
        kept_0 <= error_2[15];
        kept_9 <= {5'd0, moved};
        if (difference_83[16]) begin
          if (difference_83[16:15] == 2'd3) begin
            kept_15 <= difference_83[15:0];
          end else begin
            kept_15 <= 16'd32768;
          end
        end else if (difference_83[16:15] == 2'd0) begin
          kept_15 <= difference_83[15:0];
        end else begin
          kept_15 <= 16'd32767;
        end
        factor_a <= kept_10[15:0];
        factor_b <= kept_14[15:0];
      end
      6'd13: begin
        step <= step + 6'd1;
        kept_13 <= {16'd0, product[15:0]};
        factor_a <= {1'b0, k_p_i};
        factor_b <= kept_13[15:0];
      end
      6'd14, 6'd24: begin
        logic both_112_2;
        both_112_2 = product[31] && product[30:14] != 17'd131071;  // line 112
        case (step)
          6'd14: begin
            logic [15:0] choice_112;
            choice_112 =  // line 112
                both_112_2 ? ((sum_112_2[32:30] == 3'd7) ? sum_112_2[30:15] : 16'd32768) :
                (sum_112_2[32:30] == 3'd0) ? sum_112_2[30:15] :
                16'd32767;
            step <= step + 6'd1;
            kept_16 <= {5'd0, choice_112};
            factor_a <= {4'd0, v_dc_i};
            factor_b <= {1'b0, limit_i};
          end
          default: begin  // 6'd24
            step <= step + 6'd1;
            if (both_112_2) begin
              if (sum_112_2[32:30] == 3'd7) begin
                kept_20 <= sum_112_2[30:15];
              end else begin
                kept_20 <= 16'd32768;
              end
            end else if (sum_112_2[32:30] == 3'd0) begin
              kept_20 <= sum_112_2[30:15];
            end else begin
              kept_20 <= 16'd32767;
            end
            factor_a <= set_gamma_i;
            factor_b <= kept_9[15:0];
          end
        endcase
      end
      6'd15: begin
        logic [19:0] sum_119;
        logic [16:0] ahead;
        sum_119 = {{4{kept_9[27]}}, kept_9[27:12]} + wide_119;  // line 119
        ahead = -{kept_16[15], kept_16[15:0]};  // line 75
        step <= step + 6'd1;
        kept_16 <= {sum_119[19], sum_119} + {{4{ahead[16]}}, ahead};
        factor_a <= kept_13[15:0];
        factor_b <= kept_12[15:0];
      end
      6'd16: begin
        logic [15:0] difference_121;
        logic below_121;
        logic at_most_120;
        logic [15:0] choice_74_3;
        logic [16:0] wide_2;
        difference_121 = -{2'd0, product[26:13]};  // line 121
        below_121 = $signed(kept_16) < $signed({{5{difference_121[15]}}, difference_121});
        at_most_120 = $signed(kept_16) <= $signed({7'd0, product[26:13]});  // line 120
        choice_74_3 =  // line 74
            at_most_120 ? (below_121 ? difference_121 : kept_16[15:0]) : {2'd0, product[26:13]};
        wide_2 = {2'd0, product[26:12]};
        step <= step + 6'd1;
        kept_4 <= enable_i && ($signed({7'd0, product[26:13]}) < $signed(kept_16) || below_121);
        kept_5 <= !(at_most_120 || kept_4) || (below_121 && kept_4);
        kept_13 <= {16'd0, choice_74_3};
        kept_16 <= {3'd0, wide_2[16], wide_2};
        kept_17 <= {1'b0, product[26:12]} + {5'd0, product[26:16]};
        factor_a <= kept_13[15:0];
        factor_b <= kept_11;
      end
      6'd17: begin
        logic [16:0] difference_86;
        difference_86 = {kept_11[15], kept_11} - wide_65_3;  // line 86
        if (enable_i) begin
          logic [15:0] gamma_voltage;
          logic [15:0] choice_76;
          gamma_voltage = enable_i ? kept_13[15:0] : 16'd0;  // line 74
          choice_76 = kept_13[15] ? -gamma_voltage : kept_13[15:0];  // line 76
          if (!kept_5) begin
            integral_gamma <= kept_9[27:0];
          end
          kept_9 <= {18'd0, choice_76[14:0]};
          kept_19 <= choice_76[15];
          factor_a <= {1'b0, choice_76[14:0]};
        end else begin
          integral_gamma <= 28'd0;
          kept_9 <= 33'd0;
          kept_19 <= 1'b0;
          factor_a <= 16'd0;
        end
        step <= step + 6'd1;
        kept_3 <= {2'd0, difference_86[16:15] == 2'd0};
        kept_5 <= difference_86[16:15] == 2'd3;
        kept_11 <= difference_86[15:0];
        kept_18 <= difference_86[16];
        factor_b <= 16'd13;
      end
      6'd18: begin
        logic [16:0] sum_86_2;
        sum_86_2 = {kept_12[15], kept_12[15:0]} + wide_65_3;  // line 86
        step <= step + 6'd1;
        kept_3 <= {2'd0, sum_86_2[16]};
        kept_5 <= sum_86_2[16:15] == 2'd3;
        if (kept_18) begin
          if (!kept_5) begin
            kept_11 <= 16'd32768;
          end
        end else if (!kept_3[0]) begin
          kept_11 <= 16'd32767;
        end
        kept_12 <= {2'd0, sum_86_2[15:0]};
        kept_18 <= sum_86_2[16:15] == 2'd0;
        factor_a <= {15'd0, kept_19};
        factor_b <= 16'd65533;
      end
      6'd19: begin
        logic [15:0] _sine;
        _sine =  // line 86
            kept_3[0] ? (kept_5 ? kept_12[15:0] : 16'd32768) :
            kept_18 ? kept_12[15:0] :
            16'd32767;
        step <= step + 6'd1;
        kept_7 <= {3'd0, product[18:15]};
        kept_9 <= {17'd0, _sine};
        kept_12 <= {8'd0, product[14:5]};
        factor_a <= kept_9[15:0];
        factor_b <= 16'd9;
      end
      6'd20, 6'd22: begin
        logic [4:0] sum_78;
        sum_78 = {1'b0, kept_7[3:0]} + {1'b0, product[3:0]};  // line 78
        case (step)
          6'd20: begin
            step <= step + 6'd1;
            kept_12 <= {2'd0, kept_17} - {3'd0, sum_78, kept_12[9:0]};
            factor_a <= {15'd0, kept_19};
            factor_b <= 16'd65529;
          end
          default: begin  // 6'd22
            logic [16:0] near;
            near = {2'd0, kept_16[14:0]} - {3'd0, sum_78, kept_17[8:0]};  // line 80
            step <= step + 6'd1;
            kept_5 <= $signed({near[16], near}) < $signed(kept_12);
            kept_16 <= {3'd0, near[16], near};
            factor_a <= kept_10[15:0];
            factor_b <= kept_2;
          end
        endcase
      end
      6'd21: begin
        step <= step + 6'd1;
        kept_7 <= {3'd0, product[18:15]};
        kept_17 <= {7'd0, product[14:6]};
        factor_a <= speed_i;
        factor_b <= {1'b0, emf_i};
      end
      6'd25: begin
        logic [28:0] sum_118_2;
        sum_118_2 = {integral_delta[27], integral_delta} + wide_118;  // line 118
        step <= step + 6'd1;
        kept_10 <= {kept_20[15], kept_20} + wide_65_4;
        if (sum_118_2[28]) begin
          if (sum_118_2[28:27] == 2'd3) begin
            kept_21 <= sum_118_2[27:0];
          end else begin
            kept_21 <= 28'd134217728;
          end
        end else if (sum_118_2[28:27] == 2'd0) begin
          kept_21 <= sum_118_2[27:0];
        end else begin
          kept_21 <= 28'd134217727;
        end
        factor_a <= set_delta_i;
        factor_b <= kept_11;
      end
      6'd26: begin
        step <= step + 6'd1;
        kept_22 <= {1'b0, product};
        factor_a <= kept_15;
        factor_b <= {1'b0, k_p_i};
      end
      6'd27: begin
        logic [32:0] product_6;
        product_6 = wide_87 + wide_65_2;  // line 88
        step <= step + 6'd1;
        kept_5 <= product_6[32] && product_6[31:14] != 18'd262143;
        kept_22 <= product_6;
        factor_a <= set_gamma_i;
        factor_b <= kept_11;
      end
      6'd28: begin
        logic [19:0] sum_119_2;
        logic [20:0] wanted;
        sum_119_2 = {{4{kept_21[27]}}, kept_21[27:12]} + wide_119;  // line 119
        wanted = {sum_119_2[19], sum_119_2} + {{4{kept_10[16]}}, kept_10};  // line 119
        step <= step + 6'd1;
        if (kept_5) begin
          if (sum_112_3[33:30] == 4'd15) begin
            kept_15 <= sum_112_3[30:15];
          end else begin
            kept_15 <= 16'd32768;
          end
        end else if (sum_112_3[33:30] == 4'd0) begin
          kept_15 <= sum_112_3[30:15];
        end else begin
          kept_15 <= 16'd32767;
        end
        kept_22 <= {12'd0, wanted};
        factor_a <= set_delta_i;
        factor_b <= kept_9[15:0];
      end
      6'd29: begin
        if (enable_i) begin
          logic below_121_2;
          logic at_most_120_2;
          below_121_2 = $signed(kept_22[20:0]) < $signed({{5{kept_16[15]}}, kept_16[15:0]});
          at_most_120_2 = $signed(kept_22[20:0]) <= $signed({6'd0, kept_17[14:0]});  // line 120
          if (at_most_120_2 || kept_0) begin
            if (!(below_121_2 && kept_0)) begin
              integral_delta <= kept_21;
            end
            if (at_most_120_2) begin
              if (below_121_2) begin
                kept_17 <= kept_16[15:0];
              end else begin
                kept_17 <= kept_22[15:0];
              end
            end else begin
              kept_17 <= kept_12[15:0];
            end
          end else begin
            kept_17 <= kept_12[15:0];
          end
          kept_0 <=
              kept_4 || $signed({6'd0, kept_17[14:0]}) < $signed(kept_22[20:0]) || below_121_2;
          factor_a <= kept_13[15:0];
        end else begin
          integral_delta <= 28'd0;
          kept_0 <= kept_4;
          kept_17 <= 16'd0;
          factor_a <= 16'd0;
        end
        step <= step + 6'd1;
        kept_22 <= {1'b0, product};
        factor_b <= kept_11;
      end
      6'd30: begin
        logic [32:0] product_5;
        product_5 = wide_87 - wide_65_2;  // line 87
        step <= step + 6'd1;
        kept_4 <= product_5[32] && product_5[31:14] != 18'd262143;
        kept_22 <= product_5;
        factor_a <= kept_17;
        factor_b <= kept_9[15:0];
      end
      6'd31: begin
        step <= step + 6'd1;
        kept_13 <= product;
        if (kept_4) begin
          if (sum_112_3[33:30] == 4'd15) begin
            kept_20 <= sum_112_3[30:15];
          end else begin
            kept_20 <= 16'd32768;
          end
        end else if (sum_112_3[33:30] == 4'd0) begin
          kept_20 <= sum_112_3[30:15];
        end else begin
          kept_20 <= 16'd32767;
        end
        if (enable_i) begin
          factor_a <= kept_13[15:0];
        end else begin
          factor_a <= 16'd0;
        end
        factor_b <= kept_9[15:0];
      end
      6'd33: begin
        step <= step + 6'd1;
        if (kept_4) begin
          if (sum_112[33:30] == 4'd15) begin
            kept_11 <= sum_112[30:15];
          end else begin
            kept_11 <= 16'd32768;
          end
        end else if (sum_112[33:30] == 4'd0) begin
          kept_11 <= sum_112[30:15];
        end else begin
          kept_11 <= 16'd32767;
        end
        kept_13 <= product;
        factor_a <= kept_15;
        factor_b <= 16'd28378;
      end
      6'd34: begin
        logic [32:0] product_4;
        product_4 = wide_69 + wide_65_2;  // line 91
        step <= step + 6'd1;
        kept_4 <= product_4[32] && product_4[31:14] != 18'd262143;
        kept_9 <= product_4;
      end
      6'd35: begin
        logic [18:0] difference_95;
        difference_95 = {sum_112_2[32], sum_112_2[32:15]} - {{4{kept_20[15]}}, kept_20[15:1]};
        step <= step + 6'd1;
        kept_4 <= difference_95[18];
        kept_7 <= {3'd0, difference_95[18:15]};
        if (kept_4) begin
          if (sum_112[33:30] == 4'd15) begin
            kept_15 <= sum_112[30:15];
          end else begin
            kept_15 <= 16'd32768;
          end
        end else if (sum_112[33:30] == 4'd0) begin
          kept_15 <= sum_112[30:15];
        end else begin
          kept_15 <= 16'd32767;
        end
        kept_17 <= difference_95[15:0];
      end
      6'd36: begin
        step <= 6'd0;
        v_alpha_held <= kept_11;
        v_beta_held <= kept_15;
        i_gamma_held <= kept_2;
        i_delta_held <= kept_14[15:0];
        wanted_u_held <= kept_20;
        if (kept_4) begin
          if (kept_7[3:0] == 4'd15) begin
            wanted_v_held <= kept_17;
          end else begin
            wanted_v_held <= 16'd32768;
          end
        end else if (kept_7[3:0] == 4'd0) begin
          wanted_v_held <= kept_17;
        end else begin
          wanted_v_held <= 16'd32767;
        end
        limited_held <= kept_0;
      end
      default: step <= step + 6'd1;
    endcase
    product <= product_next;  // line 89
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
      kept_10 <= 17'd0;
      kept_11 <= 16'd0;
      kept_12 <= 18'd0;
      kept_13 <= 32'd0;
      kept_14 <= 32'd0;
      kept_15 <= 16'd0;
      kept_16 <= 21'd0;
      kept_17 <= 16'd0;
      kept_18 <= 1'b0;
      kept_19 <= 1'b0;
      kept_20 <= 16'd0;
      kept_21 <= 28'd0;
      kept_22 <= 33'd0;
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
      &{1'b0, kept_14[31:16], sum_65[7:0], sum_65_2[22:0], sum_112[14:0], error[14:0],
      sum_71[11:0], sum_112_2[14:0], sum_86[7:0], error_2[14:0], sum_112_3[14:0]};
endmodule
