// current_control: steplock::CurrentControl, printed by hlsgen from hls/sinusoidal/current_control.hpp:33.
// A sample takes 32 clocks, and in no order fewer than 32: 223 operations, 29 products, 4 entries of tables
// on 1 multiplier of 16 x 16 bits; 564 register bits, 357 of them between steps.
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
    output logic        limited_o,  // the voltage would have been longer
    output logic        done_o,  // one clock: the results are new
    output logic        busy_o,  // a start would be ignored
    output logic        missed_o  // one clock: a start was ignored
);
  logic [27:0] integral_gamma;  // s0.27, voltage
  logic [27:0] integral_delta;  // s0.27, voltage
  logic [4:0] step;  // 0: waiting for a start
  logic kept_0;  // in steps 1-2, 5-5, 6-6, 11-11, 12-12, 14-18, 19-26, 27-27, 30-30, 31-31
  logic [7:0] kept_1;  // in steps 1-1
  logic [15:0] kept_2;  // in steps 1-4, 5-26, 27-27 sine_then, 31-31
  logic [2:0] kept_3;  // in steps 1-1, 5-5, 6-6, 20-20
  logic kept_4;  // in steps 1-6, 20-22, 25-25, 27-27
  logic kept_5;  // in steps 1-4, 5-5, 6-6, 20-20, 27-27
  logic [7:0] kept_6;  // in steps 1-3
  logic [6:0] kept_7;  // in steps 1-11, 22-22, 24-24
  logic [7:0] kept_8;  // in steps 1-2
  logic [15:0] kept_9;  // in steps 2-5, 6-6 sine, 7-9 beta, 12-31 i_delta
  logic [15:0] kept_10;  // in steps 3-4, 5-5 sine, 7-9 _sine, 13-31 i_gamma
  logic [31:0] kept_11;  // in steps 3-3, 4-6, 8-11, 13-24 limit, 25-25, 27-27, 28-28, 29-30
  logic [15:0] kept_12;  // in steps 4-24, 26-26 limit
  logic [31:0] kept_13;  // in steps 6-8, 9-16 coupling, 17-18 moved, 21-26 _sine, 28-29
  logic [32:0] kept_14;  // in steps 10-10, 11-11 product, 12-12 product, 13-18, 30-30 product, 31-31 product
  logic [15:0] kept_15;  // in steps 13-18, 19-28 gamma_voltage
  logic [15:0] kept_16;  // in steps 13-18, 19-25, 26-26
  logic [15:0] kept_17;  // in steps 13-26 error
  logic [15:0] kept_18;  // in steps 13-22, 24-24, 26-26
  logic [30:0] kept_19;  // in steps 14-14, 15-17, 18-18 wanted, 20-20 sine_then, 21-25 emf, 26-26 wanted
  logic [15:0] kept_20;  // in steps 14-24
  logic [18:0] kept_21;  // in steps 16-17, 20-21, 22-22, 23-25 far
  logic [27:0] kept_22;  // in steps 18-26 moved
  logic kept_23;  // in steps 20-20, 27-31
  logic [14:0] kQuarterWave_entry;  // of the table, shared
  logic [15:0] factor_a;  // of the shared multiplier
  logic [15:0] factor_b;  // of the shared multiplier
  logic [31:0] product;  // of the factors before
  logic [15:0] v_alpha_held;  // until the next is done
  logic [15:0] v_beta_held;  // until the next is done
  logic [15:0] i_gamma_held;  // until the next is done
  logic [15:0] i_delta_held;  // until the next is done
  logic limited_held;  // until the next is done
  logic done;
  logic missed;

  wire [9:0] sum_61 = angle_i[15:6] + 10'd256;  // line 61
  wire [16:0] wide_61 = {kept_10[15], kept_10};  // line 61
  wire [7:0] differ_61_2 = angle_i[13:6] ^ {8{angle_i[14]}};  // line 61
  wire [32:0] wide_61_2 = {product[31], product};  // line 61
  wire [32:0] sum_61_2 = wide_61_2 + 33'd4194304;  // line 61
  wire [16:0] wide_61_3 = {{7{sum_61_2[32]}}, sum_61_2[32:23]};  // line 61
  wire [32:0] wide_64 = {kept_11[31], kept_11};  // line 64
  wire [16:0] wide_61_4 = {kept_9[15], kept_9};  // line 61
  wire [33:0] sum_102 = {kept_14[32], kept_14} + 34'd16384;  // line 102
  wire [16:0] difference_70 = {set_gamma_i[15], set_gamma_i} - wide_61;  // line 70
  wire [15:0] choice_70 = (difference_70[16:15] == 2'd3) ? difference_70[15:0] : 16'd32768;
  wire [15:0] choice_70_2 = (difference_70[16:15] == 2'd0) ? difference_70[15:0] : 16'd32767;
  wire [15:0] error = difference_70[16] ? choice_70 : choice_70_2;  // line 70
  wire [28:0] wide_108 = {product[30], product[30:3]};  // line 108
  wire [31:0] sum_67 = {product[30], product[30:0]} + 32'd2048;  // line 67
  wire [32:0] sum_102_2 = wide_61_2 + 33'd16384;  // line 102
  wire [16:0] wide_71 = {kept_19[15], kept_19[15:0]};  // line 71
  wire [9:0] sum_82 = ahead_i[15:6] + 10'd256;  // line 82

  logic [7:0] choice_82;  // line 82
  always_comb begin
    case (step)
      5'd0: choice_82 = differ_61_2;
      5'd1: choice_82 = kept_1;
      5'd2: choice_82 = kept_8;
      default: choice_82 = kept_6;
    endcase
  end

  logic [14:0] entry_82;  // kQuarterWave
  always_comb begin
    case (choice_82)
      8'd0: entry_82 = 15'd101;
      8'd1: entry_82 = 15'd302;
      8'd2: entry_82 = 15'd503;
      8'd3: entry_82 = 15'd704;
      8'd4: entry_82 = 15'd905;
      8'd5: entry_82 = 15'd1106;
      8'd6: entry_82 = 15'd1307;
      8'd7: entry_82 = 15'd1507;
      8'd8: entry_82 = 15'd1708;
      8'd9: entry_82 = 15'd1909;
      8'd10: entry_82 = 15'd2110;
      8'd11: entry_82 = 15'd2310;
      8'd12: entry_82 = 15'd2511;
      8'd13: entry_82 = 15'd2711;
      8'd14: entry_82 = 15'd2911;
      8'd15: entry_82 = 15'd3112;
      8'd16: entry_82 = 15'd3312;
      8'd17: entry_82 = 15'd3512;
      8'd18: entry_82 = 15'd3712;
      8'd19: entry_82 = 15'd3911;
      8'd20: entry_82 = 15'd4111;
      8'd21: entry_82 = 15'd4310;
      8'd22: entry_82 = 15'd4509;
      8'd23: entry_82 = 15'd4708;
      8'd24: entry_82 = 15'd4907;
      8'd25: entry_82 = 15'd5106;
      8'd26: entry_82 = 15'd5305;
      8'd27: entry_82 = 15'd5503;
      8'd28: entry_82 = 15'd5701;
      8'd29: entry_82 = 15'd5899;
      8'd30: entry_82 = 15'd6096;
      8'd31: entry_82 = 15'd6294;
      8'd32: entry_82 = 15'd6491;
      8'd33: entry_82 = 15'd6688;
      8'd34: entry_82 = 15'd6885;
      8'd35: entry_82 = 15'd7081;
      8'd36: entry_82 = 15'd7277;
      8'd37: entry_82 = 15'd7473;
      8'd38: entry_82 = 15'd7669;
      8'd39: entry_82 = 15'd7864;
      8'd40: entry_82 = 15'd8059;
      8'd41: entry_82 = 15'd8254;
      8'd42: entry_82 = 15'd8448;
      8'd43: entry_82 = 15'd8642;
      8'd44: entry_82 = 15'd8836;
      8'd45: entry_82 = 15'd9030;
      8'd46: entry_82 = 15'd9223;
      8'd47: entry_82 = 15'd9416;
      8'd48: entry_82 = 15'd9608;
      8'd49: entry_82 = 15'd9800;
      8'd50: entry_82 = 15'd9992;
      8'd51: entry_82 = 15'd10183;
      8'd52: entry_82 = 15'd10374;
      8'd53: entry_82 = 15'd10564;
      8'd54: entry_82 = 15'd10754;
      8'd55: entry_82 = 15'd10944;
      8'd56: entry_82 = 15'd11133;
      8'd57: entry_82 = 15'd11322;
      8'd58: entry_82 = 15'd11511;
      8'd59: entry_82 = 15'd11699;
      8'd60: entry_82 = 15'd11886;
      8'd61: entry_82 = 15'd12074;
      8'd62: entry_82 = 15'd12260;
      8'd63: entry_82 = 15'd12446;
      8'd64: entry_82 = 15'd12632;
      8'd65: entry_82 = 15'd12817;
      8'd66: entry_82 = 15'd13002;
      8'd67: entry_82 = 15'd13187;
      8'd68: entry_82 = 15'd13370;
      8'd69: entry_82 = 15'd13554;
      8'd70: entry_82 = 15'd13736;
      8'd71: entry_82 = 15'd13919;
      8'd72: entry_82 = 15'd14101;
      8'd73: entry_82 = 15'd14282;
      8'd74: entry_82 = 15'd14462;
      8'd75: entry_82 = 15'd14643;
      8'd76: entry_82 = 15'd14822;
      8'd77: entry_82 = 15'd15001;
      8'd78: entry_82 = 15'd15180;
      8'd79: entry_82 = 15'd15358;
      8'd80: entry_82 = 15'd15535;
      8'd81: entry_82 = 15'd15712;
      8'd82: entry_82 = 15'd15888;
      8'd83: entry_82 = 15'd16063;
      8'd84: entry_82 = 15'd16238;
      8'd85: entry_82 = 15'd16413;
      8'd86: entry_82 = 15'd16586;
      8'd87: entry_82 = 15'd16759;
      8'd88: entry_82 = 15'd16932;
      8'd89: entry_82 = 15'd17104;
      8'd90: entry_82 = 15'd17275;
      8'd91: entry_82 = 15'd17445;
      8'd92: entry_82 = 15'd17615;
      8'd93: entry_82 = 15'd17784;
      8'd94: entry_82 = 15'd17953;
      8'd95: entry_82 = 15'd18121;
      8'd96: entry_82 = 15'd18288;
      8'd97: entry_82 = 15'd18454;
      8'd98: entry_82 = 15'd18620;
      8'd99: entry_82 = 15'd18785;
      8'd100: entry_82 = 15'd18950;
      8'd101: entry_82 = 15'd19113;
      8'd102: entry_82 = 15'd19276;
      8'd103: entry_82 = 15'd19438;
      8'd104: entry_82 = 15'd19600;
      8'd105: entry_82 = 15'd19761;
      8'd106: entry_82 = 15'd19921;
      8'd107: entry_82 = 15'd20080;
      8'd108: entry_82 = 15'd20238;
      8'd109: entry_82 = 15'd20396;
      8'd110: entry_82 = 15'd20553;
      8'd111: entry_82 = 15'd20709;
      8'd112: entry_82 = 15'd20865;
      8'd113: entry_82 = 15'd21019;
      8'd114: entry_82 = 15'd21173;
      8'd115: entry_82 = 15'd21326;
      8'd116: entry_82 = 15'd21479;
      8'd117: entry_82 = 15'd21630;
      8'd118: entry_82 = 15'd21781;
      8'd119: entry_82 = 15'd21930;
      8'd120: entry_82 = 15'd22079;
      8'd121: entry_82 = 15'd22227;
      8'd122: entry_82 = 15'd22375;
      8'd123: entry_82 = 15'd22521;
      8'd124: entry_82 = 15'd22667;
      8'd125: entry_82 = 15'd22812;
      8'd126: entry_82 = 15'd22956;
      8'd127: entry_82 = 15'd23099;
      8'd128: entry_82 = 15'd23241;
      8'd129: entry_82 = 15'd23382;
      8'd130: entry_82 = 15'd23522;
      8'd131: entry_82 = 15'd23662;
      8'd132: entry_82 = 15'd23801;
      8'd133: entry_82 = 15'd23938;
      8'd134: entry_82 = 15'd24075;
      8'd135: entry_82 = 15'd24211;
      8'd136: entry_82 = 15'd24346;
      8'd137: entry_82 = 15'd24480;
      8'd138: entry_82 = 15'd24613;
      8'd139: entry_82 = 15'd24746;
      8'd140: entry_82 = 15'd24877;
      8'd141: entry_82 = 15'd25007;
      8'd142: entry_82 = 15'd25137;
      8'd143: entry_82 = 15'd25265;
      8'd144: entry_82 = 15'd25393;
      8'd145: entry_82 = 15'd25519;
      8'd146: entry_82 = 15'd25645;
      8'd147: entry_82 = 15'd25770;
      8'd148: entry_82 = 15'd25893;
      8'd149: entry_82 = 15'd26016;
      8'd150: entry_82 = 15'd26138;
      8'd151: entry_82 = 15'd26259;
      8'd152: entry_82 = 15'd26378;
      8'd153: entry_82 = 15'd26497;
      8'd154: entry_82 = 15'd26615;
      8'd155: entry_82 = 15'd26732;
      8'd156: entry_82 = 15'd26848;
      8'd157: entry_82 = 15'd26962;
      8'd158: entry_82 = 15'd27076;
      8'd159: entry_82 = 15'd27189;
      8'd160: entry_82 = 15'd27300;
      8'd161: entry_82 = 15'd27411;
      8'd162: entry_82 = 15'd27521;
      8'd163: entry_82 = 15'd27629;
      8'd164: entry_82 = 15'd27737;
      8'd165: entry_82 = 15'd27843;
      8'd166: entry_82 = 15'd27949;
      8'd167: entry_82 = 15'd28053;
      8'd168: entry_82 = 15'd28157;
      8'd169: entry_82 = 15'd28259;
      8'd170: entry_82 = 15'd28360;
      8'd171: entry_82 = 15'd28460;
      8'd172: entry_82 = 15'd28560;
      8'd173: entry_82 = 15'd28658;
      8'd174: entry_82 = 15'd28755;
      8'd175: entry_82 = 15'd28850;
      8'd176: entry_82 = 15'd28945;
      8'd177: entry_82 = 15'd29039;
      8'd178: entry_82 = 15'd29131;
      8'd179: entry_82 = 15'd29223;
      8'd180: entry_82 = 15'd29313;
      8'd181: entry_82 = 15'd29403;
      8'd182: entry_82 = 15'd29491;
      8'd183: entry_82 = 15'd29578;
      8'd184: entry_82 = 15'd29664;
      8'd185: entry_82 = 15'd29749;
      8'd186: entry_82 = 15'd29832;
      8'd187: entry_82 = 15'd29915;
      8'd188: entry_82 = 15'd29997;
      8'd189: entry_82 = 15'd30077;
      8'd190: entry_82 = 15'd30156;
      8'd191: entry_82 = 15'd30234;
      8'd192: entry_82 = 15'd30311;
      8'd193: entry_82 = 15'd30387;
      8'd194: entry_82 = 15'd30462;
      8'd195: entry_82 = 15'd30535;
      8'd196: entry_82 = 15'd30607;
      8'd197: entry_82 = 15'd30679;
      8'd198: entry_82 = 15'd30749;
      8'd199: entry_82 = 15'd30818;
      8'd200: entry_82 = 15'd30885;
      8'd201: entry_82 = 15'd30952;
      8'd202: entry_82 = 15'd31017;
      8'd203: entry_82 = 15'd31082;
      8'd204: entry_82 = 15'd31145;
      8'd205: entry_82 = 15'd31206;
      8'd206: entry_82 = 15'd31267;
      8'd207: entry_82 = 15'd31327;
      8'd208: entry_82 = 15'd31385;
      8'd209: entry_82 = 15'd31442;
      8'd210: entry_82 = 15'd31498;
      8'd211: entry_82 = 15'd31553;
      8'd212: entry_82 = 15'd31607;
      8'd213: entry_82 = 15'd31659;
      8'd214: entry_82 = 15'd31710;
      8'd215: entry_82 = 15'd31760;
      8'd216: entry_82 = 15'd31809;
      8'd217: entry_82 = 15'd31857;
      8'd218: entry_82 = 15'd31903;
      8'd219: entry_82 = 15'd31949;
      8'd220: entry_82 = 15'd31993;
      8'd221: entry_82 = 15'd32036;
      8'd222: entry_82 = 15'd32077;
      8'd223: entry_82 = 15'd32118;
      8'd224: entry_82 = 15'd32157;
      8'd225: entry_82 = 15'd32195;
      8'd226: entry_82 = 15'd32232;
      8'd227: entry_82 = 15'd32267;
      8'd228: entry_82 = 15'd32302;
      8'd229: entry_82 = 15'd32335;
      8'd230: entry_82 = 15'd32367;
      8'd231: entry_82 = 15'd32397;
      8'd232: entry_82 = 15'd32427;
      8'd233: entry_82 = 15'd32455;
      8'd234: entry_82 = 15'd32482;
      8'd235: entry_82 = 15'd32508;
      8'd236: entry_82 = 15'd32533;
      8'd237: entry_82 = 15'd32556;
      8'd238: entry_82 = 15'd32578;
      8'd239: entry_82 = 15'd32599;
      8'd240: entry_82 = 15'd32619;
      8'd241: entry_82 = 15'd32637;
      8'd242: entry_82 = 15'd32655;
      8'd243: entry_82 = 15'd32671;
      8'd244: entry_82 = 15'd32685;
      8'd245: entry_82 = 15'd32699;
      8'd246: entry_82 = 15'd32711;
      8'd247: entry_82 = 15'd32722;
      8'd248: entry_82 = 15'd32732;
      8'd249: entry_82 = 15'd32741;
      8'd250: entry_82 = 15'd32748;
      8'd251: entry_82 = 15'd32755;
      8'd252: entry_82 = 15'd32759;
      8'd253: entry_82 = 15'd32763;
      8'd254: entry_82 = 15'd32766;
      default: entry_82 = 15'd32767;
    endcase
  end

  wire [31:0] product_next = $signed(factor_a) * $signed(factor_b);  // line 84

  always_ff @(posedge clk) begin
    case (step)
      5'd0: begin
        logic [6:0] differ_61;
        logic [16:0] joined_63;
        logic [17:0] sum_63;
        differ_61 = {angle_i[5:0], 1'b0} ^ 7'h40;  // line 61
        joined_63 = {i_v_i, 1'b0};  // line 63
        sum_63 = {joined_63[16], joined_63} + {{2{i_u_i[15]}}, i_u_i};  // line 63
        step <= {4'd0, start_i};
        kept_0 <= sum_61[9];
        kept_1 <= angle_i[13:6] ^ {8{sum_61[8]}};
        kept_2 <= {1'b0, sum_63[14:0]};
        kept_3 <= sum_63[17:15];
        kept_4 <= sum_63[17];
        kept_5 <= sum_82[9];
        kept_6 <= ahead_i[13:6] ^ {8{sum_82[8]}};
        kept_7 <= {ahead_i[5:0], 1'b0} ^ 7'h40;
        kept_8 <= ahead_i[13:6] ^ {8{ahead_i[14]}};
        kQuarterWave_entry <= entry_82;
        factor_a <= {{9{differ_61[6]}}, differ_61};
        factor_b <= 16'd402;
      end
      5'd1, 5'd2, 5'd3, 5'd4: begin
        logic [15:0] difference_61;
        difference_61 = -{1'b0, kQuarterWave_entry};  // line 61
        case (step)
          5'd1: begin
            step <= step + 5'd1;
            if (angle_i[15]) begin
              kept_9 <= difference_61;
            end else begin
              kept_9 <= {1'b0, kQuarterWave_entry};
            end
            kQuarterWave_entry <= entry_82;
            factor_a <= {{13{kept_3[2]}}, kept_3};
            factor_b <= 16'd18919;
          end
          5'd2: begin
            step <= step + 5'd1;
            if (kept_0) begin
              kept_10 <= difference_61;
            end else begin
              kept_10 <= {1'b0, kQuarterWave_entry};
            end
            kept_11 <= {{16{product[15]}}, product[15:0]};
            kQuarterWave_entry <= entry_82;
            factor_a <= product[15:0];
            factor_b <= kept_9;
          end
          5'd3: begin
            step <= step + 5'd1;
            kept_11 <= {13'd0, product[18:0]};
            if (ahead_i[15]) begin
              kept_12 <= difference_61;
            end else begin
              kept_12 <= {1'b0, kQuarterWave_entry};
            end
            kQuarterWave_entry <= entry_82;
            factor_a <= kept_11[15:0];
            factor_b <= kept_10;
          end
          default: begin  // 5'd4
            logic [16:0] difference_61_2;
            difference_61_2 = wide_61 - wide_61_3;  // line 61
            step <= step + 5'd1;
            kept_0 <= difference_61_2[16:15] == 2'd3;
            if (kept_5) begin
              kept_2 <= difference_61;
            end else begin
              kept_2 <= {1'b0, kQuarterWave_entry};
            end
            kept_3 <= {2'd0, difference_61_2[16]};
            kept_5 <= difference_61_2[16:15] == 2'd0;
            kept_10 <= difference_61_2[15:0];
            factor_a <= {1'b0, kept_2[14:0]};
            factor_b <= 16'd18919;
          end
        endcase
      end
      5'd5: begin
        logic [15:0] _cosine;
        logic [16:0] sum_61_3;
        _cosine =  // line 61
            kept_3[0] ? (kept_0 ? kept_10 : 16'd32768) :
            kept_5 ? kept_10 :
            16'd32767;
        sum_61_3 = wide_61_4 + wide_61_3;  // line 61
        step <= step + 5'd1;
        kept_0 <= sum_61_3[16:15] == 2'd3;
        kept_3 <= {2'd0, sum_61_3[16]};
        kept_5 <= sum_61_3[16:15] == 2'd0;
        kept_9 <= sum_61_3[15:0];
        kept_13 <= {{16{_cosine[15]}}, _cosine};
        factor_a <= i_u_i;
        if (kept_3[0]) begin
          if (kept_0) begin
            factor_b <= kept_10;
          end else begin
            factor_b <= 16'd32768;
          end
        end else if (kept_5) begin
          factor_b <= kept_10;
        end else begin
          factor_b <= 16'd32767;
        end
      end
      5'd6: begin
        logic [18:0] sum_63_2;
        sum_63_2 = {4'd0, product[29:15]} + kept_11[18:0];  // line 63
        step <= step + 5'd1;
        if (kept_4) begin
          if (sum_63_2[18:15] == 4'd15) begin
            kept_9 <= sum_63_2[15:0];
          end else begin
            kept_9 <= 16'd32768;
          end
        end else if (sum_63_2[18:15] == 4'd0) begin
          kept_9 <= sum_63_2[15:0];
        end else begin
          kept_9 <= 16'd32767;
        end
        if (kept_3[0]) begin
          if (kept_0) begin
            kept_10 <= kept_9;
          end else begin
            kept_10 <= 16'd32768;
          end
        end else if (kept_5) begin
          kept_10 <= kept_9;
        end else begin
          kept_10 <= 16'd32767;
        end
        factor_a <= speed_i;
        factor_b <= {1'b0, inductance_i};
      end
      5'd7: begin
        step <= step + 5'd1;
        kept_11 <= product;
        factor_a <= i_u_i;
        factor_b <= kept_10;
      end
      5'd8, 5'd20: begin
        logic [15:0] coupling;
        coupling =  // line 67
            (product[30] && product[29:11] != 19'd524287) ?
            ((sum_67[31:27] == 5'd31) ? sum_67[27:12] : 16'd32768) :
            (sum_67[31:27] == 5'd0) ? sum_67[27:12] :
            16'd32767;
        case (step)
          5'd8: begin
            step <= step + 5'd1;
            kept_13 <= {16'd0, coupling};
            factor_a <= kept_9;
            factor_b <= kept_13[15:0];
          end
          default: begin  // 5'd20
            logic [15:0] _sine;
            logic [21:0] wide_4;
            _sine =  // line 82
                kept_23 ? (kept_5 ? kept_19[15:0] : 16'd32768) :
                kept_3[0] ? kept_19[15:0] :
                16'd32767;
            wide_4 = {6'd0, coupling};
            step <= step + 5'd1;
            kept_13 <= {16'd0, _sine};
            kept_19 <= {{9{wide_4[21]}}, wide_4};
            factor_a <= {15'd0, kept_4};
            factor_b <= 16'd65533;
          end
        endcase
      end
      5'd9: begin
        step <= step + 5'd1;
        kept_14 <= {1'b0, product};
        factor_a <= kept_9;
        factor_b <= kept_10;
      end
      5'd10: begin
        logic [32:0] product_3;
        product_3 = wide_61_2 - {kept_14[31], kept_14[31:0]};  // line 65
        step <= step + 5'd1;
        kept_0 <= product_3[32] && product_3[31:14] != 18'd262143;
        kept_14 <= product_3;
        factor_a <= {4'd0, v_dc_i};
        factor_b <= {1'b0, limit_i};
      end
      5'd11: begin
        logic [32:0] product_2;
        product_2 = wide_64 + wide_61_2;  // line 64
        step <= step + 5'd1;
        kept_0 <= product_2[32] && product_2[31:14] != 18'd262143;
        if (kept_0) begin
          if (sum_102[33:30] == 4'd15) begin
            kept_9 <= sum_102[30:15];
          end else begin
            kept_9 <= 16'd32768;
          end
        end else if (sum_102[33:30] == 4'd0) begin
          kept_9 <= sum_102[30:15];
        end else begin
          kept_9 <= 16'd32767;
        end
        kept_14 <= product_2;
        factor_a <= {{9{kept_7[6]}}, kept_7};
        factor_b <= 16'd402;
      end
      5'd12: begin
        logic [16:0] difference_79;
        difference_79 = {set_delta_i[15], set_delta_i} - wide_61_4;  // line 79
        step <= step + 5'd1;
        if (kept_0) begin
          if (sum_102[33:30] == 4'd15) begin
            kept_10 <= sum_102[30:15];
          end else begin
            kept_10 <= 16'd32768;
          end
        end else if (sum_102[33:30] == 4'd0) begin
          kept_10 <= sum_102[30:15];
        end else begin
          kept_10 <= 16'd32767;
        end
        kept_11 <= {17'd0, product[26:12]};
        kept_14 <= {19'd0, product[26:13]};
        kept_15 <= {2'd0, product[26:13]};
        kept_16 <= -{2'd0, product[26:13]};
        if (difference_79[16]) begin
          if (difference_79[16:15] == 2'd3) begin
            kept_17 <= difference_79[15:0];
          end else begin
            kept_17 <= 16'd32768;
          end
        end else if (difference_79[16:15] == 2'd0) begin
          kept_17 <= difference_79[15:0];
        end else begin
          kept_17 <= 16'd32767;
        end
        kept_18 <= {1'b0, product[26:12]} + {5'd0, product[26:16]};
        factor_a <= kept_13[15:0];
        factor_b <= kept_9;
      end
      5'd13: begin
        step <= step + 5'd1;
        kept_0 <= error[15];
        if (difference_70[16]) begin
          logic [21:0] wide_6;
          wide_6 = {{6{choice_70[15]}}, choice_70};
          kept_19 <= {{9{wide_6[21]}}, wide_6};
          if (difference_70[16:15] == 2'd3) begin
            factor_a <= difference_70[15:0];
          end else begin
            factor_a <= 16'd32768;
          end
        end else begin
          logic [21:0] wide_7;
          wide_7 = {{6{choice_70_2[15]}}, choice_70_2};
          kept_19 <= {{9{wide_7[21]}}, wide_7};
          if (difference_70[16:15] == 2'd0) begin
            factor_a <= difference_70[15:0];
          end else begin
            factor_a <= 16'd32767;
          end
        end
        kept_20 <= product[15:0];
        factor_b <= {1'b0, k_p_i};
      end
      5'd14, 5'd18: begin
        logic both_102;
        both_102 = product[31] && product[30:14] != 17'd131071;  // line 102
        case (step)
          5'd14: begin
            logic [15:0] choice_102;
            logic [21:0] wide;
            choice_102 =  // line 102
                both_102 ? ((sum_102_2[32:30] == 3'd7) ? sum_102_2[30:15] : 16'd32768) :
                (sum_102_2[32:30] == 3'd0) ? sum_102_2[30:15] :
                16'd32767;
            wide = {6'd0, choice_102};
            step <= step + 5'd1;
            kept_19 <= {{9{wide[21]}}, wide};
            factor_a <= kept_19[15:0];
            factor_b <= {1'b0, k_i_i};
          end
          default: begin  // 5'd18
            if (enable_i) begin
              logic below_111;
              logic at_most_110;
              below_111 = $signed(kept_19[20:0]) < $signed({{5{kept_16[15]}}, kept_16});
              at_most_110 = $signed(kept_19[20:0]) <= $signed({7'd0, kept_14[13:0]});  // line 110
              if (at_most_110 || kept_0) begin
                if (!(below_111 && kept_0)) begin
                  integral_gamma <= kept_13[27:0];
                end
                if (at_most_110) begin
                  if (below_111) begin
                    kept_15 <= kept_16;
                  end else begin
                    kept_15 <= kept_19[15:0];
                  end
                end
              end
              kept_0 <= $signed({7'd0, kept_14[13:0]}) < $signed(kept_19[20:0]) || below_111;
            end else begin
              integral_gamma <= 28'd0;
              kept_0 <= 1'b0;
              kept_15 <= 16'd0;
            end
            step <= step + 5'd1;
            if (both_102) begin
              if (sum_102_2[32:30] == 3'd7) begin
                kept_16 <= sum_102_2[30:15];
              end else begin
                kept_16 <= 16'd32768;
              end
            end else if (sum_102_2[32:30] == 3'd0) begin
              kept_16 <= sum_102_2[30:15];
            end else begin
              kept_16 <= 16'd32767;
            end
            factor_a <= speed_i;
            factor_b <= {1'b0, emf_i};
          end
        endcase
      end
      5'd15: begin
        step <= step + 5'd1;
        kept_21 <= product[30:12];
        factor_a <= kept_17;
        factor_b <= {1'b0, k_i_i};
      end
      5'd16: begin
        logic [28:0] sum_108;
        logic [27:0] moved;
        sum_108 = {integral_gamma[27], integral_gamma} + wide_108;  // line 108
        moved =  // line 108
            sum_108[28] ? ((sum_108[28:27] == 2'd3) ? sum_108[27:0] : 28'd134217728) :
            (sum_108[28:27] == 2'd0) ? sum_108[27:0] :
            28'd134217727;
        step <= step + 5'd1;
        kept_13 <= {4'd0, moved};
        factor_a <= kept_13[15:0];
        factor_b <= kept_10;
      end
      5'd17: begin
        logic [19:0] sum_109;
        logic [16:0] ahead;
        logic [20:0] wanted;
        logic [28:0] sum_108_2;
        logic [21:0] wide_2;
        sum_109 = {{4{kept_13[27]}}, kept_13[27:12]} + {kept_21[18], kept_21};  // line 109
        ahead = -wide_71;  // line 71
        wanted = {sum_109[19], sum_109} + {{4{ahead[16]}}, ahead};  // line 109
        sum_108_2 = {integral_delta[27], integral_delta} + wide_108;  // line 108
        wide_2 = {1'b0, wanted};
        step <= step + 5'd1;
        kept_19 <= {{9{wide_2[21]}}, wide_2};
        if (sum_108_2[28]) begin
          if (sum_108_2[28:27] == 2'd3) begin
            kept_22 <= sum_108_2[27:0];
          end else begin
            kept_22 <= 28'd134217728;
          end
        end else if (sum_108_2[28:27] == 2'd0) begin
          kept_22 <= sum_108_2[27:0];
        end else begin
          kept_22 <= 28'd134217727;
        end
        factor_a <= kept_20;
        factor_b <= kept_2;
      end
      5'd19: begin
        logic [15:0] choice_72;
        logic [16:0] sum_82_2;
        logic [21:0] wide_3;
        choice_72 = kept_15[15] ? -kept_15 : kept_15;  // line 72
        sum_82_2 = {kept_12[15], kept_12} + wide_61_3;  // line 82
        wide_3 = {6'd0, sum_82_2[15:0]};
        step <= step + 5'd1;
        kept_3 <= {2'd0, sum_82_2[16:15] == 2'd0};
        kept_4 <= choice_72[15];
        kept_5 <= sum_82_2[16:15] == 2'd3;
        kept_19 <= {{9{wide_3[21]}}, wide_3};
        kept_21 <= {4'd0, choice_72[14:0]};
        kept_23 <= sum_82_2[16];
        factor_a <= {1'b0, choice_72[14:0]};
        factor_b <= 16'd13;
      end
      5'd21: begin
        step <= step + 5'd1;
        kept_7 <= {3'd0, product[18:15]};
        kept_21 <= {9'd0, product[14:5]};
        factor_a <= kept_21[15:0];
        factor_b <= 16'd9;
      end
      5'd22, 5'd24: begin
        logic [4:0] sum_74;
        sum_74 = {1'b0, kept_7[3:0]} + {1'b0, product[3:0]};  // line 74
        case (step)
          5'd22: begin
            logic [17:0] far;
            far = {2'd0, kept_18} - {3'd0, sum_74, kept_21[9:0]};  // line 77
            step <= step + 5'd1;
            kept_21 <= {1'b0, far};
            factor_a <= {15'd0, kept_4};
            factor_b <= 16'd65529;
          end
          default: begin  // 5'd24
            logic [16:0] near;
            logic [17:0] wide_78;
            near = {2'd0, kept_11[14:0]} - {3'd0, sum_74, kept_18[8:0]};  // line 76
            wide_78 = {near[16], near};  // line 78
            step <= step + 5'd1;
            kept_4 <= $signed(wide_78) < $signed(kept_21[17:0]);
            kept_11 <= {14'd0, wide_78};
            factor_a <= kept_20;
            factor_b <= kept_12;
          end
        endcase
      end
      5'd23: begin
        step <= step + 5'd1;
        kept_7 <= {3'd0, product[18:15]};
        kept_18 <= {7'd0, product[14:6]};
        factor_a <= kept_17;
        factor_b <= {1'b0, k_p_i};
      end
      5'd25: begin
        logic [19:0] sum_109_2;
        logic [16:0] ahead_2;
        logic [20:0] wanted_2;
        logic [17:0] left;
        logic [14:0] limit;
        logic [21:0] wide_5;
        sum_109_2 = {{4{kept_22[27]}}, kept_22[27:12]} + {product[30], product[30:12]};  // line 109
        ahead_2 = {kept_16[15], kept_16} + wide_71;  // line 80
        wanted_2 = {sum_109_2[19], sum_109_2} + {{4{ahead_2[16]}}, ahead_2};  // line 109
        left = kept_4 ? kept_11[17:0] : kept_21[17:0];  // line 78
        limit =  // line 80
            left[17] ? 15'd0 :
            (left[17:15] == 3'd0) ? left[14:0] :
            15'd32767;
        wide_5 = {1'b0, wanted_2};
        step <= step + 5'd1;
        kept_12 <= {1'b0, limit};
        kept_16 <= {1'b0, limit};
        kept_18 <= -{1'b0, limit};
        kept_19 <= {{9{wide_5[21]}}, wide_5};
        factor_a <= kept_15;
        factor_b <= kept_13[15:0];
      end
      5'd26: begin
        logic [16:0] difference_82;
        difference_82 = {kept_2[15], kept_2} - wide_61_3;  // line 82
        if (enable_i) begin
          logic below_111_2;
          logic at_most_110_2;
          logic [15:0] choice_79;
          below_111_2 = $signed(kept_19[20:0]) < $signed({{5{kept_18[15]}}, kept_18});  // line 111
          at_most_110_2 = $signed(kept_19[20:0]) <= $signed({6'd0, kept_12[14:0]});  // line 110
          choice_79 = at_most_110_2 ? (below_111_2 ? kept_18 : kept_19[15:0]) : kept_16;  // line 79
          if (at_most_110_2 || kept_17[15]) begin
            if (!(below_111_2 && kept_17[15])) begin
              integral_delta <= kept_22;
            end
            if (at_most_110_2) begin
              if (below_111_2) begin
                factor_a <= kept_18;
              end else begin
                factor_a <= kept_19[15:0];
              end
            end else begin
              factor_a <= kept_16;
            end
          end else begin
            factor_a <= kept_16;
          end
          kept_11 <= {{16{choice_79[15]}}, choice_79};
          kept_23 <=
              kept_0 || $signed({6'd0, kept_12[14:0]}) < $signed(kept_19[20:0]) || below_111_2;
        end else begin
          integral_delta <= 28'd0;
          kept_11 <= 32'd0;
          kept_23 <= kept_0;
          factor_a <= 16'd0;
        end
        step <= step + 5'd1;
        kept_0 <= difference_82[16:15] == 2'd3;
        kept_2 <= difference_82[15:0];
        kept_4 <= difference_82[16:15] == 2'd0;
        kept_5 <= difference_82[16];
        factor_b <= kept_13[15:0];
      end
      5'd27: begin
        logic [15:0] _cosine_2;
        _cosine_2 =  // line 82
            kept_5 ? (kept_0 ? kept_2 : 16'd32768) :
            kept_4 ? kept_2 :
            16'd32767;
        step <= step + 5'd1;
        kept_11 <= {{16{_cosine_2[15]}}, _cosine_2};
        kept_13 <= product;
        factor_a <= kept_11[15:0];
        if (kept_5) begin
          if (kept_0) begin
            factor_b <= kept_2;
          end else begin
            factor_b <= 16'd32768;
          end
        end else if (kept_4) begin
          factor_b <= kept_2;
        end else begin
          factor_b <= 16'd32767;
        end
      end
      5'd28: begin
        step <= step + 5'd1;
        kept_11 <= product;
        factor_a <= kept_15;
        factor_b <= kept_11[15:0];
      end
      5'd29: begin
        logic [32:0] product_5;
        product_5 = {kept_13[31], kept_13} + wide_61_2;  // line 84
        step <= step + 5'd1;
        kept_0 <= product_5[32] && product_5[31:14] != 18'd262143;
        kept_14 <= product_5;
      end
      5'd30: begin
        logic [32:0] product_4;
        product_4 = wide_61_2 - wide_64;  // line 83
        step <= step + 5'd1;
        kept_0 <= product_4[32] && product_4[31:14] != 18'd262143;
        if (kept_0) begin
          if (sum_102[33:30] == 4'd15) begin
            kept_2 <= sum_102[30:15];
          end else begin
            kept_2 <= 16'd32768;
          end
        end else if (sum_102[33:30] == 4'd0) begin
          kept_2 <= sum_102[30:15];
        end else begin
          kept_2 <= 16'd32767;
        end
        kept_14 <= product_4;
      end
      default: begin  // 5'd31
        step <= 5'd0;
        if (kept_0) begin
          if (sum_102[33:30] == 4'd15) begin
            v_alpha_held <= sum_102[30:15];
          end else begin
            v_alpha_held <= 16'd32768;
          end
        end else if (sum_102[33:30] == 4'd0) begin
          v_alpha_held <= sum_102[30:15];
        end else begin
          v_alpha_held <= 16'd32767;
        end
        v_beta_held <= kept_2;
        i_gamma_held <= kept_10;
        i_delta_held <= kept_9;
        limited_held <= kept_23;
      end
    endcase
    product <= product_next;  // line 84
    done <= step == 5'd31;
    missed <= start_i && step != 5'd0;
    if (rst) begin
      integral_gamma <= 28'sd0;
      integral_delta <= 28'sd0;
      step <= 5'd0;
      kept_0 <= 1'b0;
      kept_1 <= 8'd0;
      kept_2 <= 16'd0;
      kept_3 <= 3'd0;
      kept_4 <= 1'b0;
      kept_5 <= 1'b0;
      kept_6 <= 8'd0;
      kept_7 <= 7'd0;
      kept_8 <= 8'd0;
      kept_9 <= 16'd0;
      kept_10 <= 16'd0;
      kept_11 <= 32'd0;
      kept_12 <= 16'd0;
      kept_13 <= 32'd0;
      kept_14 <= 33'd0;
      kept_15 <= 16'd0;
      kept_16 <= 16'd0;
      kept_17 <= 16'd0;
      kept_18 <= 16'd0;
      kept_19 <= 31'd0;
      kept_20 <= 16'd0;
      kept_21 <= 19'd0;
      kept_22 <= 28'd0;
      kept_23 <= 1'b0;
      kQuarterWave_entry <= 15'd0;
      factor_a <= 16'd0;
      factor_b <= 16'd0;
      product <= 32'd0;
      v_alpha_held <= 16'sd0;
      v_beta_held <= 16'sd0;
      i_gamma_held <= 16'sd0;
      i_delta_held <= 16'sd0;
      limited_held <= 1'b0;
      done <= 1'b0;
      missed <= 1'b0;
    end
  end

  assign v_alpha_o = v_alpha_held;
  assign v_beta_o = v_beta_held;
  assign i_gamma_o = i_gamma_held;
  assign i_delta_o = i_delta_held;
  assign limited_o = limited_held;
  assign done_o = done;
  assign busy_o = step != 5'd0;
  assign missed_o = missed;

  // What nothing reads, for the linters.
  wire unused =
      &{1'b0, kept_19[30:21], sum_61[7:0], sum_61_2[22:0], sum_102[14:0], error[14:0],
      sum_67[11:0], sum_102_2[14:0], sum_82[7:0]};
endmodule
