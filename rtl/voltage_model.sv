// voltage_model: steplock::VoltageModel, printed by hlsgen from hls/sinusoidal/voltage_model.hpp:72.
// A sample takes 40 clocks, and in no order fewer than 38: 237 operations, 33 products, 2 entries of tables
// on 1 multiplier of 16 x 16 bits; 820 register bits, 408 of them between steps.
// Do not edit: change the C++ and print again.

module voltage_model (
    input  logic        clk,
    input  logic        rst,  // synchronous, active high
    input  logic        enable_i,  // false: the angle is `initial`, the speed 0
    input  logic [15:0] edge_i,  // s0.15 of 1/16 turn: a slower mean step is one backward
    input  logic [23:0] initial_i,  // u0.24
    input  logic [15:0] i_u_i,  // s0.15
    input  logic [15:0] i_v_i,  // s0.15
    input  logic [11:0] v_dc_i,  // u0.12
    input  logic [13:0] pattern_on_u_i,  // clocks
    input  logic [13:0] pattern_on_v_i,  // clocks
    input  logic [13:0] pattern_on_w_i,  // clocks
    input  logic [13:0] pattern_period_i,  // clocks
    input  logic [11:0] pattern_dead_i,  // u8.4, clocks
    input  logic [14:0] pattern_inverse_i,  // u0.25
    input  logic        words_average_i,  // the mean of 8 samples
    input  logic [14:0] words_decay_i,  // u0.15, per sample
    input  logic [14:0] words_gain_i,  // u2.13, current per voltage
    input  logic [14:0] words_k_emf_i,  // u0.15, turns per current
    input  logic [14:0] words_k_theta_i,  // u1.14, turns per current
    input  logic [14:0] words_k_si_i,  // u-8.23, turns per current
    input  logic        start_i,  // begins a sample, unless busy
    output logic [23:0] angle_o,  // u0.24, at this sample
    output logic [19:0] step_o,  // s-4.23, until the next
    output logic [19:0] emf_step_o,  // s-4.23, the hypothetical speed
    output logic [15:0] error_o,  // s-1.16, Delta i_gamma: zero in step
    output logic        done_o,  // one clock: the results are new
    output logic        busy_o,  // a start would be ignored
    output logic        missed_o  // one clock: a start was ignored
);
  logic [15:0] observer_last_u;  // s0.15, at the interval's begin
  logic [15:0] observer_last_v;  // s0.15
  logic [11:0] observer_last_dc;  // u0.12
  logic [23:0] observer_before;  // u0.24, theta_c at the last sample
  logic [19:0] observer_step;  // s-4.23
  logic [24:0] observer_way;  // s-4.28, 32 mean steps
  logic observer_against;  // turning against the direction of -edge
  logic [15:0] speed_recent_0;  // Delta i_delta
  logic [15:0] speed_recent_1;  // Delta i_delta
  logic [15:0] speed_recent_2;  // Delta i_delta
  logic [15:0] speed_recent_3;  // Delta i_delta
  logic [15:0] speed_recent_4;  // Delta i_delta
  logic [15:0] speed_recent_5;  // Delta i_delta
  logic [15:0] speed_recent_6;  // Delta i_delta
  logic [15:0] speed_recent_7;  // Delta i_delta
  logic [18:0] speed_sum;  // of them
  logic [27:0] speed_integral;
  logic [5:0] step;  // 0: waiting for a start
  logic [23:0] kept_0;  // in steps 1-39
  logic kept_1;  // in steps 1-38
  logic kept_2;  // in steps 1-36
  logic [19:0] kept_3;  // in steps 1-32, 37-39
  logic [17:0] kept_4;  // in steps 1-10, 12-12, 13-13, 14-14, 16-17, 19-19, 20-20, 21-24
  logic [15:0] kept_5;  // in steps 1-4, 5-5, 6-13, 14-16, 18-19, 20-21, 24-24, 25-27, 31-39 seen_gamma
  logic [1:0] kept_6;  // in steps 1-7, 13-18
  logic [17:0] kept_7;  // in steps 1-12, 14-14, 21-23
  logic [14:0] kept_8;  // in steps 1-8, 9-11, 13-13, 15-19, 20-20, 22-22, 35-35
  logic [1:0] kept_9;  // in steps 1-9, 15-19
  logic [15:0] kept_10;  // in steps 1-1, 2-26, 27-27, 32-32 seen_delta
  logic kept_11;  // in steps 1-1, 3-17, 19-19, 20-20, 24-24, 25-25, 26-26, 27-27, 30-30, 31-31, 36-36
  logic [5:0] kept_12;  // in steps 1-1, 2-2, 5-6, 9-16, 17-18, 24-24, 26-26, 33-33, 36-36
  logic kept_13;  // in steps 1-3, 14-14, 25-25, 27-27
  logic [19:0] kept_14;  // in steps 1-1, 3-15, 23-23, 35-37, 39-39
  logic kept_15;  // in steps 1-4, 25-25, 27-27
  logic kept_16;  // in steps 1-2
  logic [7:0] kept_17;  // in steps 1-1, 15-20
  logic [6:0] kept_18;  // in steps 1-18
  logic kept_19;  // in steps 1-1
  logic [20:0] kept_20;  // in steps 1-3, 4-4, 5-5, 7-9, 10-10, 11-25, 36-36 turned_emf_step, 37-37
  logic kept_21;  // in steps 1-3
  logic [5:0] kept_22;  // in steps 1-3, 6-17, 18-19
  logic kept_23;  // in steps 1-5
  logic [24:0] kept_24;  // in steps 1-38, 39-39
  logic kept_25;  // in steps 1-39
  logic [15:0] kept_26;  // in steps 1-39
  logic [15:0] kept_27;  // in steps 3-24, 25-25, 26-26
  logic [14:0] kept_28;  // in steps 7-9, 11-11, 13-18, 19-19, 22-22, 35-35
  logic [14:0] kept_29;  // in steps 8-8, 11-11, 15-15, 17-18
  logic [14:0] kept_30;  // in steps 8-8, 15-19
  logic [32:0] kept_31;  // in steps 26-26, 27-28, 29-29, 30-30, 31-31
  logic [31:0] kept_32;  // in steps 28-30, 34-34, 37-37, 38-38
  logic [31:0] kept_33;  // in steps 28-28, 38-38
  logic [15:0] factor_a;  // of the shared multiplier
  logic [15:0] factor_b;  // of the shared multiplier
  logic [31:0] product;  // of the factors before
  logic [14:0] kQuarterWave_entry;  // of the table, shared
  logic [19:0] emf_step_held;  // until the next is done
  logic [15:0] error_held;  // until the next is done
  logic done;
  logic missed;

  wire [23:0] wide_93 = {{4{observer_step[19]}}, observer_step};  // line 93
  wire [23:0] sum_93 = observer_before + wide_93;  // line 93
  wire [16:0] wide_93_2 = {i_u_i[15], i_u_i};  // line 93
  wire [16:0] wide_93_3 = {observer_last_u[15], observer_last_u};  // line 93
  wire [16:0] sum_93_2 = wide_93_2 + wide_93_3;  // line 93
  wire [31:0] joined_93_2 = {{2'd0, kept_20[14:0]} + product[16:0], kept_28};  // line 93
  wire [32:0] sum_93_3 = {joined_93_2[31], joined_93_2} + 33'd16384;  // line 93
  wire [18:0] wide_93_4 = {kept_20[17], kept_20[17:0]};  // line 93
  wire [16:0] wide_93_5 = {i_v_i[15], i_v_i};  // line 93
  wire [16:0] wide_93_6 = {observer_last_v[15], observer_last_v};  // line 93
  wire [16:0] sum_93_5 = wide_93_5 + wide_93_6;  // line 93
  wire [31:0] joined_93_4 = {{2'd0, kept_28} + product[16:0], kept_29};  // line 93
  wire [32:0] sum_93_6 = {joined_93_4[31], joined_93_4} + 33'd16384;  // line 93
  wire [18:0] wide_93_7 = {kept_4[17], kept_4};  // line 93
  wire [33:0] joined_93_5 = {{4'd0, kept_8} + product[18:0], kept_28};  // line 93
  wire [34:0] wide_93_8 = {joined_93_5[33], joined_93_5};  // line 93
  wire [34:0] sum_93_10 = wide_93_8 + 35'd16384;  // line 93
  wire [16:0] sum_93_11 = sum_93_5 - 17'd34;  // line 93
  wire [17:0] sum_93_12 = kept_14[17:0] - 18'd33;  // line 93
  wire [17:0] difference_93 = -kept_14[17:0];  // line 93
  wire [15:0] wide_93_9 = {{10{kept_12[5]}}, kept_12};  // line 93
  wire [34:0] sum_93_13 = {{5'd0, kept_29} + product[19:0], kept_30} + 35'd8192;  // line 93
  wire [28:0] sum_93_14 = {1'b0, product[27:0]} + 29'd4096;  // line 93
  wire [5:0] sum_93_16 = kept_12 + product[5:0];  // line 93
  wire [35:0] joined_93_6 = {sum_93_16, kept_29, kept_28};  // line 93
  wire [36:0] sum_93_17 = {joined_93_6[35], joined_93_6} + 37'd8192;  // line 93
  wire [31:0] wide_93_10 = {product[30], product[30:0]};  // line 93
  wire [31:0] sum_93_18 = wide_93_10 + 32'd2048;  // line 93
  wire [20:0] wide_93_11 = {sum_93_18[31], sum_93_18[31:12]};  // line 93
  wire [9:0] sum_93_19 = sum_93[23:14] + 10'd256;  // line 93
  wire [32:0] wide_93_12 = {product[31], product};  // line 93
  wire [32:0] sum_93_20 = wide_93_12 + 33'd4194304;  // line 93
  wire [16:0] wide_93_13 = {{7{sum_93_20[32]}}, sum_93_20[32:23]};  // line 93
  wire [16:0] sum_93_21 = sum_93_2 - 17'd34;  // line 93
  wire [15:0] wide_93_14 = {{10{kept_22[5]}}, kept_22};  // line 93
  wire [5:0] sum_93_23 = kept_22 + product[5:0];  // line 93
  wire [35:0] joined_93_7 = {sum_93_23, kept_5[14:0], kept_30};  // line 93
  wire [36:0] sum_93_24 = {joined_93_7[35], joined_93_7} + 37'd8192;  // line 93
  wire [33:0] sum_93_26 = {kept_31[32], kept_31} + 34'd16384;  // line 93
  wire [34:0] difference_53 = 35'd1024 - wide_93_8;  // line 53
  wire [31:0] sum_52 = wide_93_10 + 32'd64;  // line 52
  wire [31:0] sum_50 = wide_93_10 + 32'd128;  // line 50
  wire [28:0] moved = {speed_integral[27], speed_integral} + {{5{kept_32[23]}}, kept_32[23:0]};
  wire [27:0] choice_51 =  // line 51
      moved[28] ? ((moved[28:27] == 2'd3) ? moved[27:0] : 28'd134217728) :
      (moved[28:27] == 2'd0) ? moved[27:0] :
      28'd134217727;
  wire [31:0] product_next = $signed(factor_a) * $signed(factor_b);  // line 50
  wire [7:0] choice_93_13 = (step == 6'd0) ? sum_93[21:14] ^ {8{sum_93[22]}} : kept_17;  // line 93

  logic [14:0] entry_93;  // kQuarterWave
  always_comb begin
    case (choice_93_13)
      8'd0: entry_93 = 15'd101;
      8'd1: entry_93 = 15'd302;
      8'd2: entry_93 = 15'd503;
      8'd3: entry_93 = 15'd704;
      8'd4: entry_93 = 15'd905;
      8'd5: entry_93 = 15'd1106;
      8'd6: entry_93 = 15'd1307;
      8'd7: entry_93 = 15'd1507;
      8'd8: entry_93 = 15'd1708;
      8'd9: entry_93 = 15'd1909;
      8'd10: entry_93 = 15'd2110;
      8'd11: entry_93 = 15'd2310;
      8'd12: entry_93 = 15'd2511;
      8'd13: entry_93 = 15'd2711;
      8'd14: entry_93 = 15'd2911;
      8'd15: entry_93 = 15'd3112;
      8'd16: entry_93 = 15'd3312;
      8'd17: entry_93 = 15'd3512;
      8'd18: entry_93 = 15'd3712;
      8'd19: entry_93 = 15'd3911;
      8'd20: entry_93 = 15'd4111;
      8'd21: entry_93 = 15'd4310;
      8'd22: entry_93 = 15'd4509;
      8'd23: entry_93 = 15'd4708;
      8'd24: entry_93 = 15'd4907;
      8'd25: entry_93 = 15'd5106;
      8'd26: entry_93 = 15'd5305;
      8'd27: entry_93 = 15'd5503;
      8'd28: entry_93 = 15'd5701;
      8'd29: entry_93 = 15'd5899;
      8'd30: entry_93 = 15'd6096;
      8'd31: entry_93 = 15'd6294;
      8'd32: entry_93 = 15'd6491;
      8'd33: entry_93 = 15'd6688;
      8'd34: entry_93 = 15'd6885;
      8'd35: entry_93 = 15'd7081;
      8'd36: entry_93 = 15'd7277;
      8'd37: entry_93 = 15'd7473;
      8'd38: entry_93 = 15'd7669;
      8'd39: entry_93 = 15'd7864;
      8'd40: entry_93 = 15'd8059;
      8'd41: entry_93 = 15'd8254;
      8'd42: entry_93 = 15'd8448;
      8'd43: entry_93 = 15'd8642;
      8'd44: entry_93 = 15'd8836;
      8'd45: entry_93 = 15'd9030;
      8'd46: entry_93 = 15'd9223;
      8'd47: entry_93 = 15'd9416;
      8'd48: entry_93 = 15'd9608;
      8'd49: entry_93 = 15'd9800;
      8'd50: entry_93 = 15'd9992;
      8'd51: entry_93 = 15'd10183;
      8'd52: entry_93 = 15'd10374;
      8'd53: entry_93 = 15'd10564;
      8'd54: entry_93 = 15'd10754;
      8'd55: entry_93 = 15'd10944;
      8'd56: entry_93 = 15'd11133;
      8'd57: entry_93 = 15'd11322;
      8'd58: entry_93 = 15'd11511;
      8'd59: entry_93 = 15'd11699;
      8'd60: entry_93 = 15'd11886;
      8'd61: entry_93 = 15'd12074;
      8'd62: entry_93 = 15'd12260;
      8'd63: entry_93 = 15'd12446;
      8'd64: entry_93 = 15'd12632;
      8'd65: entry_93 = 15'd12817;
      8'd66: entry_93 = 15'd13002;
      8'd67: entry_93 = 15'd13187;
      8'd68: entry_93 = 15'd13370;
      8'd69: entry_93 = 15'd13554;
      8'd70: entry_93 = 15'd13736;
      8'd71: entry_93 = 15'd13919;
      8'd72: entry_93 = 15'd14101;
      8'd73: entry_93 = 15'd14282;
      8'd74: entry_93 = 15'd14462;
      8'd75: entry_93 = 15'd14643;
      8'd76: entry_93 = 15'd14822;
      8'd77: entry_93 = 15'd15001;
      8'd78: entry_93 = 15'd15180;
      8'd79: entry_93 = 15'd15358;
      8'd80: entry_93 = 15'd15535;
      8'd81: entry_93 = 15'd15712;
      8'd82: entry_93 = 15'd15888;
      8'd83: entry_93 = 15'd16063;
      8'd84: entry_93 = 15'd16238;
      8'd85: entry_93 = 15'd16413;
      8'd86: entry_93 = 15'd16586;
      8'd87: entry_93 = 15'd16759;
      8'd88: entry_93 = 15'd16932;
      8'd89: entry_93 = 15'd17104;
      8'd90: entry_93 = 15'd17275;
      8'd91: entry_93 = 15'd17445;
      8'd92: entry_93 = 15'd17615;
      8'd93: entry_93 = 15'd17784;
      8'd94: entry_93 = 15'd17953;
      8'd95: entry_93 = 15'd18121;
      8'd96: entry_93 = 15'd18288;
      8'd97: entry_93 = 15'd18454;
      8'd98: entry_93 = 15'd18620;
      8'd99: entry_93 = 15'd18785;
      8'd100: entry_93 = 15'd18950;
      8'd101: entry_93 = 15'd19113;
      8'd102: entry_93 = 15'd19276;
      8'd103: entry_93 = 15'd19438;
      8'd104: entry_93 = 15'd19600;
      8'd105: entry_93 = 15'd19761;
      8'd106: entry_93 = 15'd19921;
      8'd107: entry_93 = 15'd20080;
      8'd108: entry_93 = 15'd20238;
      8'd109: entry_93 = 15'd20396;
      8'd110: entry_93 = 15'd20553;
      8'd111: entry_93 = 15'd20709;
      8'd112: entry_93 = 15'd20865;
      8'd113: entry_93 = 15'd21019;
      8'd114: entry_93 = 15'd21173;
      8'd115: entry_93 = 15'd21326;
      8'd116: entry_93 = 15'd21479;
      8'd117: entry_93 = 15'd21630;
      8'd118: entry_93 = 15'd21781;
      8'd119: entry_93 = 15'd21930;
      8'd120: entry_93 = 15'd22079;
      8'd121: entry_93 = 15'd22227;
      8'd122: entry_93 = 15'd22375;
      8'd123: entry_93 = 15'd22521;
      8'd124: entry_93 = 15'd22667;
      8'd125: entry_93 = 15'd22812;
      8'd126: entry_93 = 15'd22956;
      8'd127: entry_93 = 15'd23099;
      8'd128: entry_93 = 15'd23241;
      8'd129: entry_93 = 15'd23382;
      8'd130: entry_93 = 15'd23522;
      8'd131: entry_93 = 15'd23662;
      8'd132: entry_93 = 15'd23801;
      8'd133: entry_93 = 15'd23938;
      8'd134: entry_93 = 15'd24075;
      8'd135: entry_93 = 15'd24211;
      8'd136: entry_93 = 15'd24346;
      8'd137: entry_93 = 15'd24480;
      8'd138: entry_93 = 15'd24613;
      8'd139: entry_93 = 15'd24746;
      8'd140: entry_93 = 15'd24877;
      8'd141: entry_93 = 15'd25007;
      8'd142: entry_93 = 15'd25137;
      8'd143: entry_93 = 15'd25265;
      8'd144: entry_93 = 15'd25393;
      8'd145: entry_93 = 15'd25519;
      8'd146: entry_93 = 15'd25645;
      8'd147: entry_93 = 15'd25770;
      8'd148: entry_93 = 15'd25893;
      8'd149: entry_93 = 15'd26016;
      8'd150: entry_93 = 15'd26138;
      8'd151: entry_93 = 15'd26259;
      8'd152: entry_93 = 15'd26378;
      8'd153: entry_93 = 15'd26497;
      8'd154: entry_93 = 15'd26615;
      8'd155: entry_93 = 15'd26732;
      8'd156: entry_93 = 15'd26848;
      8'd157: entry_93 = 15'd26962;
      8'd158: entry_93 = 15'd27076;
      8'd159: entry_93 = 15'd27189;
      8'd160: entry_93 = 15'd27300;
      8'd161: entry_93 = 15'd27411;
      8'd162: entry_93 = 15'd27521;
      8'd163: entry_93 = 15'd27629;
      8'd164: entry_93 = 15'd27737;
      8'd165: entry_93 = 15'd27843;
      8'd166: entry_93 = 15'd27949;
      8'd167: entry_93 = 15'd28053;
      8'd168: entry_93 = 15'd28157;
      8'd169: entry_93 = 15'd28259;
      8'd170: entry_93 = 15'd28360;
      8'd171: entry_93 = 15'd28460;
      8'd172: entry_93 = 15'd28560;
      8'd173: entry_93 = 15'd28658;
      8'd174: entry_93 = 15'd28755;
      8'd175: entry_93 = 15'd28850;
      8'd176: entry_93 = 15'd28945;
      8'd177: entry_93 = 15'd29039;
      8'd178: entry_93 = 15'd29131;
      8'd179: entry_93 = 15'd29223;
      8'd180: entry_93 = 15'd29313;
      8'd181: entry_93 = 15'd29403;
      8'd182: entry_93 = 15'd29491;
      8'd183: entry_93 = 15'd29578;
      8'd184: entry_93 = 15'd29664;
      8'd185: entry_93 = 15'd29749;
      8'd186: entry_93 = 15'd29832;
      8'd187: entry_93 = 15'd29915;
      8'd188: entry_93 = 15'd29997;
      8'd189: entry_93 = 15'd30077;
      8'd190: entry_93 = 15'd30156;
      8'd191: entry_93 = 15'd30234;
      8'd192: entry_93 = 15'd30311;
      8'd193: entry_93 = 15'd30387;
      8'd194: entry_93 = 15'd30462;
      8'd195: entry_93 = 15'd30535;
      8'd196: entry_93 = 15'd30607;
      8'd197: entry_93 = 15'd30679;
      8'd198: entry_93 = 15'd30749;
      8'd199: entry_93 = 15'd30818;
      8'd200: entry_93 = 15'd30885;
      8'd201: entry_93 = 15'd30952;
      8'd202: entry_93 = 15'd31017;
      8'd203: entry_93 = 15'd31082;
      8'd204: entry_93 = 15'd31145;
      8'd205: entry_93 = 15'd31206;
      8'd206: entry_93 = 15'd31267;
      8'd207: entry_93 = 15'd31327;
      8'd208: entry_93 = 15'd31385;
      8'd209: entry_93 = 15'd31442;
      8'd210: entry_93 = 15'd31498;
      8'd211: entry_93 = 15'd31553;
      8'd212: entry_93 = 15'd31607;
      8'd213: entry_93 = 15'd31659;
      8'd214: entry_93 = 15'd31710;
      8'd215: entry_93 = 15'd31760;
      8'd216: entry_93 = 15'd31809;
      8'd217: entry_93 = 15'd31857;
      8'd218: entry_93 = 15'd31903;
      8'd219: entry_93 = 15'd31949;
      8'd220: entry_93 = 15'd31993;
      8'd221: entry_93 = 15'd32036;
      8'd222: entry_93 = 15'd32077;
      8'd223: entry_93 = 15'd32118;
      8'd224: entry_93 = 15'd32157;
      8'd225: entry_93 = 15'd32195;
      8'd226: entry_93 = 15'd32232;
      8'd227: entry_93 = 15'd32267;
      8'd228: entry_93 = 15'd32302;
      8'd229: entry_93 = 15'd32335;
      8'd230: entry_93 = 15'd32367;
      8'd231: entry_93 = 15'd32397;
      8'd232: entry_93 = 15'd32427;
      8'd233: entry_93 = 15'd32455;
      8'd234: entry_93 = 15'd32482;
      8'd235: entry_93 = 15'd32508;
      8'd236: entry_93 = 15'd32533;
      8'd237: entry_93 = 15'd32556;
      8'd238: entry_93 = 15'd32578;
      8'd239: entry_93 = 15'd32599;
      8'd240: entry_93 = 15'd32619;
      8'd241: entry_93 = 15'd32637;
      8'd242: entry_93 = 15'd32655;
      8'd243: entry_93 = 15'd32671;
      8'd244: entry_93 = 15'd32685;
      8'd245: entry_93 = 15'd32699;
      8'd246: entry_93 = 15'd32711;
      8'd247: entry_93 = 15'd32722;
      8'd248: entry_93 = 15'd32732;
      8'd249: entry_93 = 15'd32741;
      8'd250: entry_93 = 15'd32748;
      8'd251: entry_93 = 15'd32755;
      8'd252: entry_93 = 15'd32759;
      8'd253: entry_93 = 15'd32763;
      8'd254: entry_93 = 15'd32766;
      default: entry_93 = 15'd32767;
    endcase
  end

  always_ff @(posedge clk) begin
    case (step)
      6'd0: begin
        logic below_95;
        logic equal_95;
        below_95 = $signed(observer_way[24:9]) < $signed(observer_against ? 16'd0 : edge_i);
        equal_95 = edge_i[15] == below_95;  // line 95
        step <= {5'd0, start_i};
        if (enable_i) begin
          kept_0 <= sum_93 + wide_93;
          kept_25 <= equal_95 && edge_i != 16'd0;
          kept_26 <= speed_recent_0;
        end else begin
          kept_0 <= initial_i;
          kept_25 <= 1'b0;
          kept_26 <= 16'd0;
        end
        kept_1 <= below_95;
        kept_2 <= edge_i == 16'd0 || equal_95;
        kept_3 <= {1'b0, speed_sum - {{3{speed_recent_7[15]}}, speed_recent_7}};
        kept_4 <= {1'b0, wide_93_2 - wide_93_3};
        kept_5 <= {1'b0, sum_93_2[14:0]};
        kept_6 <= sum_93_2[16:15];
        kept_7 <= {1'b0, wide_93_5 - wide_93_6};
        kept_8 <= sum_93_5[14:0];
        kept_9 <= sum_93_5[16:15];
        kept_10 <= sum_93_11[16:1];
        kept_11 <= $signed(sum_93_5[16:1]) > 16'sd16;
        kept_12 <= sum_93_5[6:1];
        kept_13 <= pattern_on_v_i != 14'd0 && pattern_on_v_i < pattern_period_i;
        kept_14 <= {2'd0, {sum_93_2[16], sum_93_2} + {sum_93_5[16], sum_93_5}};
        kept_15 <= pattern_on_w_i != 14'd0 && pattern_on_w_i < pattern_period_i;
        kept_16 <= sum_93_19[9];
        kept_17 <= sum_93[21:14] ^ {8{sum_93_19[8]}};
        kept_18 <= {sum_93[13:8], 1'b0} ^ 7'h40;
        kept_19 <= sum_93[23];
        kept_20 <= {5'd0, sum_93_21[16:1]};
        kept_21 <= $signed(sum_93_2[16:1]) > 16'sd16;
        kept_22 <= sum_93_2[6:1];
        kept_23 <= pattern_on_u_i != 14'd0 && pattern_on_u_i < pattern_period_i;
        kept_24 <= observer_way - {{5{observer_way[24]}}, observer_way[24:5]};
        factor_a <= {3'd0, {1'b0, v_dc_i} + {1'b0, observer_last_dc}};
        factor_b <= {1'b0, pattern_inverse_i};
        kQuarterWave_entry <= entry_93;
      end
      6'd1, 6'd2: begin
        logic [15:0] difference_93_5;
        difference_93_5 = -{1'b0, kQuarterWave_entry};  // line 93
        case (step)
          6'd1: begin
            logic [5:0] choice_93_3;
            choice_93_3 = (kept_10 < 16'd65503) ? (kept_11 ? 6'd16 : 6'd48) : kept_12;  // line 93
            step <= step + 6'd1;
            if (kept_19) begin
              kept_10 <= difference_93_5;
            end else begin
              kept_10 <= {1'b0, kQuarterWave_entry};
            end
            if (sum_93_12[17:1] < 17'd131039) begin
              if ($signed(difference_93[17:1]) > 17'sd16) begin
                kept_12 <= 6'd16;
              end else begin
                kept_12 <= 6'd48;
              end
            end else begin
              kept_12 <= difference_93[6:1];
            end
            factor_a <= {{10{choice_93_3[5]}}, choice_93_3};
            factor_b <= {4'd0, pattern_dead_i};
            kQuarterWave_entry <= entry_93;
          end
          default: begin  // 6'd2
            step <= step + 6'd1;
            kept_11 <= sum_93_14[28];
            kept_14 <= {5'd0, sum_93_14[27:13]};
            if (kept_16) begin
              kept_27 <= difference_93_5;
            end else begin
              kept_27 <= {1'b0, kQuarterWave_entry};
            end
            factor_a <= wide_93_9;
            factor_b <= {4'd0, pattern_dead_i};
          end
        endcase
      end
      6'd3: begin
        logic [13:0] choice_93_4;
        logic [5:0] choice_93_7;
        choice_93_4 = kept_13 ? product[17:4] : 14'd0;  // line 93
        choice_93_7 = (kept_20[15:0] < 16'd65503) ? (kept_21 ? 6'd16 : 6'd48) : kept_22;  // line 93
        step <= step + 6'd1;
        kept_20 <= {1'b0, {2'd0, pattern_on_v_i, 4'd0} - {{6{choice_93_4[13]}}, choice_93_4}};
        factor_a <= {{10{choice_93_7[5]}}, choice_93_7};
        factor_b <= {4'd0, pattern_dead_i};
      end
      6'd4: begin
        logic [13:0] choice_93_5;
        logic [19:0] difference_93_2;
        logic [19:0] difference_93_3;
        choice_93_5 = kept_15 ? product[17:4] : 14'd0;  // line 93
        difference_93_2 = {2'd0, pattern_on_w_i, 4'd0} - {{6{choice_93_5[13]}}, choice_93_5};
        difference_93_3 = kept_20[19:0] - difference_93_2;  // line 93
        step <= step + 6'd1;
        kept_5 <= {1'b0, difference_93_3[14:0]};
        kept_12 <= {1'b0, difference_93_3[19:15]};
        kept_20 <= {kept_20[19], kept_20[19:0]} + {difference_93_2[19], difference_93_2};
        factor_a <= {1'b0, kept_5[14:0]};
        factor_b <= {1'b0, words_decay_i};
      end
      6'd5: begin
        logic [13:0] choice_93_8;
        logic [20:0] difference_93_7;
        choice_93_8 = kept_23 ? product[17:4] : 14'd0;  // line 93
        difference_93_7 =  // line 93
            {{2'd0, pattern_on_u_i, 4'd0} - {{6{choice_93_8[13]}}, choice_93_8}, 1'b0} - kept_20;
        step <= step + 6'd1;
        kept_5 <= {1'b0, difference_93_7[14:0]};
        kept_22 <= difference_93_7[20:15];
        factor_a <= {1'b0, kept_5[14:0]};
        factor_b <= 16'd28378;
      end
      6'd6: begin
        step <= step + 6'd1;
        kept_20 <= {6'd0, product[29:15]};
        kept_28 <= product[14:0];
        factor_a <= {{11{kept_12[4]}}, kept_12[4:0]};
        factor_b <= 16'd28378;
      end
      6'd7: begin
        step <= step + 6'd1;
        kept_29 <= product[29:15];
        kept_30 <= product[14:0];
        factor_a <= {{14{kept_6[1]}}, kept_6};
        factor_b <= {1'b0, words_decay_i};
      end
      6'd8: begin
        step <= step + 6'd1;
        kept_8 <= sum_93_13[28:14];
        kept_12 <= sum_93_13[34:29];
        factor_a <= {1'b0, kept_8};
        factor_b <= {1'b0, words_decay_i};
      end
      6'd9: begin
        step <= step + 6'd1;
        kept_20 <= {3'd0, sum_93_3[32:15]};
        factor_a <= {{14{kept_9[1]}}, kept_9};
        factor_b <= {1'b0, words_decay_i};
      end
      6'd10: begin
        logic [17:0] joined_93;
        logic [18:0] sum_93_4;
        logic [17:0] choice_93;
        joined_93 = {kept_4[16:0], 1'b0};  // line 93
        sum_93_4 = {joined_93[17], joined_93} + wide_93_4;  // line 93
        choice_93 =  // line 93
            sum_93_4[18] ? ((sum_93_4[18:17] == 2'd3) ? sum_93_4[17:0] : 18'd131072) :
            (sum_93_4[18:17] == 2'd0) ? sum_93_4[17:0] :
            18'd131071;
        step <= step + 6'd1;
        kept_20 <= {3'd0, choice_93};
        kept_28 <= product[29:15];
        kept_29 <= product[14:0];
        factor_a <= {1'b0, kept_8};
        factor_b <= {1'b0, kept_14[14:0]};
      end
      6'd11: begin
        step <= step + 6'd1;
        kept_4 <= sum_93_6[32:15];
        factor_a <= {kept_8[14], kept_8};
        factor_b <= {15'd0, kept_11};
      end
      6'd12: begin
        logic [17:0] joined_93_3;
        logic [18:0] sum_93_7;
        joined_93_3 = {kept_7[16:0], 1'b0};  // line 93
        sum_93_7 = {joined_93_3[17], joined_93_3} + wide_93_7;  // line 93
        step <= step + 6'd1;
        if (sum_93_7[18]) begin
          if (sum_93_7[18:17] == 2'd3) begin
            kept_4 <= sum_93_7[17:0];
          end else begin
            kept_4 <= 18'd131072;
          end
        end else if (sum_93_7[18:17] == 2'd0) begin
          kept_4 <= sum_93_7[17:0];
        end else begin
          kept_4 <= 18'd131071;
        end
        kept_6 <= product[14:13];
        kept_8 <= product[29:15];
        kept_28 <= product[14:0];
        factor_a <= {1'b0, kept_5[14:0]};
        factor_b <= {1'b0, kept_14[14:0]};
      end
      6'd13: begin
        logic [18:0] sum_93_8;
        logic [19:0] sum_93_9;
        logic [2:0] part_93;
        sum_93_8 = wide_93_4 + wide_93_7;  // line 93
        sum_93_9 = {sum_93_8[18], sum_93_8} + {{2{kept_4[17]}}, kept_4};  // line 93
        part_93 = sum_93_9[19:17];  // line 93
        step <= step + 6'd1;
        case (part_93)
          3'd0: begin
            kept_4 <= 18'd131072;
            kept_7 <= sum_93_9[17:0];
          end
          3'd7: begin
            kept_4 <= sum_93_9[17:0];
            kept_7 <= 18'd131071;
          end
          default: begin
            kept_4 <= 18'd131072;
            kept_7 <= 18'd131071;
          end
        endcase
        kept_5 <= {1'b0, kept_8} + {1'b0, product[14:0]};
        kept_13 <= sum_93_9[19];
        factor_a <= {kept_5[14], kept_5[14:0]};
        factor_b <= {15'd0, kept_11};
      end
      6'd14: begin
        logic [17:0] choice_93_2;
        choice_93_2 = kept_13 ? kept_4 : kept_7;  // line 93
        step <= step + 6'd1;
        kept_8 <= choice_93_2[14:0];
        kept_9 <= product[14:13];
        kept_17 <= {5'd0, choice_93_2[17:15]};
        kept_29 <= product[29:15];
        kept_30 <= product[14:0];
        factor_a <= wide_93_9;
        factor_b <= {1'b0, kept_14[14:0]};
      end
      6'd15: begin
        step <= step + 6'd1;
        kept_4 <= {2'd0, {1'b0, kept_29} + {1'b0, product[14:0]}};
        factor_a <= wide_93_14;
        factor_b <= {1'b0, kept_14[14:0]};
      end
      6'd16: begin
        logic [20:0] sum_93_15;
        sum_93_15 = {5'd0, kept_5} + product[20:0];  // line 93
        step <= step + 6'd1;
        kept_12 <= sum_93_15[20:15];
        kept_29 <= sum_93_15[14:0];
        factor_a <= wide_93_9;
        factor_b <= {15'd0, kept_11};
      end
      6'd17: begin
        logic [20:0] sum_93_22;
        sum_93_22 = {5'd0, kept_4[15:0]} + product[20:0];  // line 93
        step <= step + 6'd1;
        kept_5 <= {1'b0, sum_93_22[14:0]};
        kept_22 <= sum_93_22[20:15];
        factor_a <= wide_93_14;
        factor_b <= {15'd0, kept_11};
      end
      6'd18: begin
        step <= step + 6'd1;
        kept_4 <= {2'd0, sum_93_17[29:14]};
        kept_11 <= sum_93_16[5] && {sum_93_16[4:0], kept_29, kept_6} != 22'd4194303;
        kept_28 <= {7'd0, sum_93_17[36:29]};
        factor_a <= {{9{kept_18[6]}}, kept_18};
        factor_b <= 16'd402;
      end
      6'd19: begin
        step <= step + 6'd1;
        kept_4 <= {2'd0, sum_93_24[29:14]};
        if (kept_11) begin
          if (kept_28[7:0] == 8'd255) begin
            kept_5 <= kept_4[15:0];
          end else begin
            kept_5 <= 16'd32768;
          end
        end else if (kept_28[7:0] == 8'd0) begin
          kept_5 <= kept_4[15:0];
        end else begin
          kept_5 <= 16'd32767;
        end
        kept_8 <= {7'd0, sum_93_24[36:29]};
        kept_11 <= sum_93_23[5] && {sum_93_23[4:0], kept_5[14:0], kept_9} != 22'd4194303;
        factor_a <= {1'b0, kept_8};
        factor_b <= 16'd18919;
      end
      6'd20: begin
        logic [15:0] choice_93_9;
        choice_93_9 =  // line 93
            kept_11 ? ((kept_8[7:0] == 8'd255) ? kept_4[15:0] : 16'd32768) :
            (kept_8[7:0] == 8'd0) ? kept_4[15:0] :
            16'd32767;
        step <= step + 6'd1;
        kept_4 <= {2'd0, product[15:0]};
        kept_7 <= {2'd0, choice_93_9};
        factor_a <= {{13{kept_17[2]}}, kept_17[2:0]};
        factor_b <= 16'd18919;
      end
      6'd21: begin
        step <= step + 6'd1;
        kept_8 <= product[29:15];
        kept_28 <= product[14:0];
        factor_a <= kept_5;
        factor_b <= {1'b0, words_gain_i};
      end
      6'd22: begin
        step <= step + 6'd1;
        kept_14 <= sum_93_10[34:15];
        factor_a <= kept_4[15:0];
        factor_b <= kept_10;
      end
      6'd23: begin
        logic [20:0] difference_93_4;
        difference_93_4 = {kept_14[19], kept_14} - wide_93_11;  // line 93
        step <= step + 6'd1;
        kept_5 <= difference_93_4[15:0];
        kept_11 <= difference_93_4[20];
        kept_12 <= difference_93_4[20:15];
        factor_a <= kept_7[15:0];
        factor_b <= {1'b0, words_gain_i};
      end
      6'd24: begin
        logic [16:0] difference_93_6;
        difference_93_6 = {kept_27[15], kept_27} - wide_93_13;  // line 93
        step <= step + 6'd1;
        if (kept_11) begin
          if (kept_12 != 6'd63) begin
            kept_5 <= 16'd32768;
          end
        end else if (kept_12 != 6'd0) begin
          kept_5 <= 16'd32767;
        end
        kept_11 <= difference_93_6[16:15] == 2'd3;
        kept_13 <= difference_93_6[16:15] == 2'd0;
        kept_15 <= difference_93_6[16];
        kept_27 <= difference_93_6[15:0];
        factor_a <= kept_4[15:0];
        factor_b <= kept_27;
      end
      6'd25: begin
        logic [15:0] choice_93_6;
        logic [20:0] difference_93_8;
        choice_93_6 =  // line 93
            kept_15 ? (kept_11 ? kept_27 : 16'd32768) :
            kept_13 ? kept_27 :
            16'd32767;
        difference_93_8 = {{3{kept_20[17]}}, kept_20[17:0]} - wide_93_11;  // line 93
        step <= step + 6'd1;
        kept_11 <= difference_93_8[20];
        kept_12 <= difference_93_8[20:15];
        kept_27 <= difference_93_8[15:0];
        kept_31 <= {1'b0, {16{choice_93_6[15]}}, choice_93_6};
        factor_a <= kept_5;
        if (kept_15) begin
          if (kept_11) begin
            factor_b <= kept_27;
          end else begin
            factor_b <= 16'd32768;
          end
        end else if (kept_13) begin
          factor_b <= kept_27;
        end else begin
          factor_b <= 16'd32767;
        end
      end
      6'd26: begin
        logic [16:0] sum_93_25;
        sum_93_25 = {kept_10[15], kept_10} + wide_93_13;  // line 93
        step <= step + 6'd1;
        kept_10 <= sum_93_25[15:0];
        kept_11 <= sum_93_25[16:15] == 2'd3;
        kept_13 <= sum_93_25[16:15] == 2'd0;
        kept_15 <= sum_93_25[16];
        if (kept_11) begin
          logic [15:0] choice_93_10;
          choice_93_10 = (kept_12 == 6'd63) ? kept_27 : 16'd32768;  // line 93
          kept_31 <= {1'b0, {16{choice_93_10[15]}}, choice_93_10};
          if (kept_12 == 6'd63) begin
            factor_a <= kept_27;
          end else begin
            factor_a <= 16'd32768;
          end
        end else begin
          logic [15:0] choice_93_11;
          choice_93_11 = (kept_12 == 6'd0) ? kept_27 : 16'd32767;  // line 93
          kept_31 <= {1'b0, {16{choice_93_11[15]}}, choice_93_11};
          if (kept_12 == 6'd0) begin
            factor_a <= kept_27;
          end else begin
            factor_a <= 16'd32767;
          end
        end
        factor_b <= kept_31[15:0];
      end
      6'd27: begin
        logic [15:0] choice_93_12;
        choice_93_12 =  // line 93
            kept_15 ? (kept_11 ? kept_10 : 16'd32768) :
            kept_13 ? kept_10 :
            16'd32767;
        step <= step + 6'd1;
        kept_32 <= product;
        kept_33 <= {{16{choice_93_12[15]}}, choice_93_12};
        factor_a <= kept_5;
        if (kept_15) begin
          if (kept_11) begin
            factor_b <= kept_10;
          end else begin
            factor_b <= 16'd32768;
          end
        end else if (kept_13) begin
          factor_b <= kept_10;
        end else begin
          factor_b <= 16'd32767;
        end
      end
      6'd28: begin
        step <= step + 6'd1;
        kept_31 <= {1'b0, product};
        factor_a <= kept_33[15:0];
        factor_b <= kept_31[15:0];
      end
      6'd29: begin
        logic [32:0] sum_93_27;
        sum_93_27 = {kept_31[31], kept_31[31:0]} + wide_93_12;  // line 93
        step <= step + 6'd1;
        kept_11 <= sum_93_27[32] && sum_93_27[31:14] != 18'd262143;
        kept_31 <= sum_93_27;
      end
      6'd30: begin
        logic [32:0] difference_93_9;
        difference_93_9 = {kept_32[31], kept_32} - wide_93_12;  // line 93
        step <= step + 6'd1;
        if (kept_11) begin
          if (sum_93_26[33:30] == 4'd15) begin
            kept_5 <= sum_93_26[30:15];
          end else begin
            kept_5 <= 16'd32768;
          end
        end else if (sum_93_26[33:30] == 4'd0) begin
          kept_5 <= sum_93_26[30:15];
        end else begin
          kept_5 <= 16'd32767;
        end
        kept_11 <= difference_93_9[32] && difference_93_9[31:14] != 18'd262143;
        kept_31 <= difference_93_9;
      end
      6'd31: begin
        if (enable_i) begin
          if (kept_11) begin
            if (sum_93_26[33:30] == 4'd15) begin
              speed_recent_0 <= sum_93_26[30:15];
            end else begin
              speed_recent_0 <= 16'd32768;
            end
          end else if (sum_93_26[33:30] == 4'd0) begin
            speed_recent_0 <= sum_93_26[30:15];
          end else begin
            speed_recent_0 <= 16'd32767;
          end
        end else begin
          speed_recent_0 <= 16'd0;
        end
        step <= step + 6'd1;
        if (kept_11) begin
          if (sum_93_26[33:30] == 4'd15) begin
            kept_10 <= sum_93_26[30:15];
          end else begin
            kept_10 <= 16'd32768;
          end
        end else if (sum_93_26[33:30] == 4'd0) begin
          kept_10 <= sum_93_26[30:15];
        end else begin
          kept_10 <= 16'd32767;
        end
        factor_a <= kept_5;
        factor_b <= {1'b0, words_k_si_i};
      end
      6'd32: begin
        logic [18:0] sum_46;
        logic [18:0] emf;
        sum_46 = kept_3[18:0] + {{3{kept_10[15]}}, kept_10};  // line 46
        emf = words_average_i ? sum_46 : {kept_10, 3'd0};  // line 49
        if (enable_i) begin
          speed_sum <= sum_46;
        end else begin
          speed_sum <= 19'd0;
        end
        step <= step + 6'd1;
        kept_12 <= {2'd0, emf[18:15]};
        factor_a <= {1'b0, emf[14:0]};
        factor_b <= {1'b0, words_k_emf_i};
      end
      6'd33: begin
        step <= step + 6'd1;
        kept_32 <= {8'd0, sum_50[31:8]};
        factor_a <= {{12{kept_12[3]}}, kept_12[3:0]};
        factor_b <= {1'b0, words_k_emf_i};
      end
      6'd34: begin
        if (enable_i) begin
          if (moved[28]) begin
            if (moved[28:27] == 2'd3) begin
              speed_integral <= moved[27:0];
            end else begin
              speed_integral <= 28'd134217728;
            end
          end else if (moved[28:27] == 2'd0) begin
            speed_integral <= moved[27:0];
          end else begin
            speed_integral <= 28'd134217727;
          end
        end else begin
          speed_integral <= 28'd0;
        end
        step <= step + 6'd1;
        kept_8 <= product[29:15];
        kept_14 <= choice_51[27:8];
        kept_28 <= product[14:0];
        factor_a <= kept_5;
        factor_b <= {1'b0, words_k_theta_i};
      end
      6'd35: begin
        step <= step + 6'd1;
        kept_11 <= $signed(joined_93_5) > 34'sd1024;
        kept_12 <= {1'b0, difference_53[34:30]};
        kept_20 <= {1'b0, difference_53[30:11]};
      end
      6'd36: begin
        logic [19:0] turned_emf_step;
        logic [19:0] choice_95;
        turned_emf_step =  // line 53
            kept_11 ? ((kept_12[4:0] == 5'd31) ? kept_20[19:0] : 20'd524288) :
            (kept_12[4:0] == 5'd0) ? kept_20[19:0] :
            20'd524287;
        choice_95 = (kept_2 || turned_emf_step[19] == kept_1) ? turned_emf_step : 20'd0;  // line 95
        step <= step + 6'd1;
        if (enable_i) begin
          if (kept_11) begin
            if (kept_12[4:0] == 5'd31) begin
              kept_3 <= kept_20[19:0];
            end else begin
              kept_3 <= 20'd524288;
            end
          end else if (kept_12[4:0] == 5'd0) begin
            kept_3 <= kept_20[19:0];
          end else begin
            kept_3 <= 20'd524287;
          end
        end else begin
          kept_3 <= 20'd0;
        end
        kept_20 <= {1'b0, choice_95};
        kept_32 <= {7'd0, sum_52[31:7]};
      end
      6'd37: begin
        logic [26:0] wide_95;
        logic [25:0] turned_pull;
        logic [26:0] wide_95_2;
        wide_95 = {{7{kept_20[19]}}, kept_20[19:0]};  // line 95
        turned_pull = {kept_32[24], kept_32[24:0]} + {{6{kept_14[19]}}, kept_14};  // line 54
        wide_95_2 = {turned_pull[25], turned_pull};  // line 95
        step <= step + 6'd1;
        kept_32 <= {5'd0, wide_95 - wide_95_2};
        kept_33 <= {5'd0, wide_95 + wide_95_2};
      end
      6'd38: begin
        logic [26:0] choice_95_2;
        logic [19:0] step_2;
        choice_95_2 = kept_1 ? kept_32[26:0] : kept_33[26:0];  // line 95
        step_2 =  // line 95
            choice_95_2[26] ? ((choice_95_2[26:19] == 8'd255) ? choice_95_2[19:0] : 20'd524288) :
            (choice_95_2[26:19] == 8'd0) ? choice_95_2[19:0] :
            20'd524287;
        step <= step + 6'd1;
        if (enable_i) begin
          if (choice_95_2[26]) begin
            if (choice_95_2[26:19] == 8'd255) begin
              kept_14 <= choice_95_2[19:0];
            end else begin
              kept_14 <= 20'd524288;
            end
          end else if (choice_95_2[26:19] == 8'd0) begin
            kept_14 <= choice_95_2[19:0];
          end else begin
            kept_14 <= 20'd524287;
          end
        end else begin
          kept_14 <= 20'd0;
        end
        kept_24 <= kept_24 + {{5{step_2[19]}}, step_2};
      end
      6'd39: begin
        observer_last_u <= i_u_i;
        observer_last_v <= i_v_i;
        observer_last_dc <= v_dc_i;
        observer_before <= kept_0;
        observer_step <= kept_14;
        if (enable_i) begin
          observer_way <= kept_24;
          speed_recent_2 <= speed_recent_1;
          speed_recent_3 <= speed_recent_2;
          speed_recent_4 <= speed_recent_3;
          speed_recent_5 <= speed_recent_4;
          speed_recent_6 <= speed_recent_5;
          speed_recent_7 <= speed_recent_6;
          error_held <= kept_5;
        end else begin
          observer_way <= 25'd0;
          speed_recent_2 <= 16'd0;
          speed_recent_3 <= 16'd0;
          speed_recent_4 <= 16'd0;
          speed_recent_5 <= 16'd0;
          speed_recent_6 <= 16'd0;
          speed_recent_7 <= 16'd0;
          error_held <= 16'd0;
        end
        observer_against <= kept_25;
        speed_recent_1 <= kept_26;
        step <= 6'd0;
        emf_step_held <= kept_3;
      end
      default: step <= step + 6'd1;
    endcase
    product <= product_next;  // line 50
    done <= step == 6'd39;
    missed <= start_i && step != 6'd0;
    if (rst) begin
      observer_last_u <= 16'sd0;
      observer_last_v <= 16'sd0;
      observer_last_dc <= 12'd0;
      observer_before <= 24'd0;
      observer_step <= 20'sd0;
      observer_way <= 25'sd0;
      observer_against <= 1'b0;
      speed_recent_0 <= 16'sd0;
      speed_recent_1 <= 16'sd0;
      speed_recent_2 <= 16'sd0;
      speed_recent_3 <= 16'sd0;
      speed_recent_4 <= 16'sd0;
      speed_recent_5 <= 16'sd0;
      speed_recent_6 <= 16'sd0;
      speed_recent_7 <= 16'sd0;
      speed_sum <= 19'sd0;
      speed_integral <= 28'sd0;
      step <= 6'd0;
      kept_0 <= 24'd0;
      kept_1 <= 1'b0;
      kept_2 <= 1'b0;
      kept_3 <= 20'd0;
      kept_4 <= 18'd0;
      kept_5 <= 16'd0;
      kept_6 <= 2'd0;
      kept_7 <= 18'd0;
      kept_8 <= 15'd0;
      kept_9 <= 2'd0;
      kept_10 <= 16'd0;
      kept_11 <= 1'b0;
      kept_12 <= 6'd0;
      kept_13 <= 1'b0;
      kept_14 <= 20'd0;
      kept_15 <= 1'b0;
      kept_16 <= 1'b0;
      kept_17 <= 8'd0;
      kept_18 <= 7'd0;
      kept_19 <= 1'b0;
      kept_20 <= 21'd0;
      kept_21 <= 1'b0;
      kept_22 <= 6'd0;
      kept_23 <= 1'b0;
      kept_24 <= 25'd0;
      kept_25 <= 1'b0;
      kept_26 <= 16'd0;
      kept_27 <= 16'd0;
      kept_28 <= 15'd0;
      kept_29 <= 15'd0;
      kept_30 <= 15'd0;
      kept_31 <= 33'd0;
      kept_32 <= 32'd0;
      kept_33 <= 32'd0;
      factor_a <= 16'd0;
      factor_b <= 16'd0;
      product <= 32'd0;
      kQuarterWave_entry <= 15'd0;
      emf_step_held <= 20'sd0;
      error_held <= 16'sd0;
      done <= 1'b0;
      missed <= 1'b0;
    end
  end

  assign angle_o = observer_before;
  assign step_o = observer_step;
  assign emf_step_o = emf_step_held;
  assign error_o = error_held;
  assign done_o = done;
  assign busy_o = step != 6'd0;
  assign missed_o = missed;

  // What nothing reads, for the linters.
  wire unused =
      &{1'b0, kept_33[31:27], sum_93_3[14:0], sum_93_6[14:0], sum_93_10[14:0], sum_93_11[0],
      sum_93_12[0], difference_93[0], sum_93_13[13:0], sum_93_14[12:0], sum_93_17[13:0],
      sum_93_18[11:0], sum_93_19[7:0], sum_93_20[22:0], sum_93_21[0], sum_93_24[13:0],
      sum_93_26[14:0], difference_53[10:0], sum_52[6:0], sum_50[7:0], choice_51[7:0]};
endmodule
