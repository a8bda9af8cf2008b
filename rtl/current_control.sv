// current_control: steplock::CurrentControl, printed by hlsgen from hls/sinusoidal/current_control.hpp:29.
// A sample takes 25 clocks, and in no order fewer than 24: 186 operations, 21 products, 2 entries of tables
// on 1 multiplier of 16 x 16 bits; 469 register bits, 262 of them between steps.
// Do not edit: change the C++ and print again.

module current_control (
    input  logic        clk,
    input  logic        rst,  // synchronous, active high
    input  logic        enable_i,  // false: no voltage, integrators at 0
    input  logic [15:0] i_u_i,  // s0.15
    input  logic [15:0] i_v_i,  // s0.15
    input  logic [15:0] angle_i,  // u0.16, electrical turns, of the gamma axis
    input  logic [15:0] speed_i,  // s0.15
    input  logic [15:0] set_gamma_i,  // s0.15
    input  logic [15:0] set_delta_i,  // s0.15
    input  logic [14:0] k_p_i,  // u3.12
    input  logic [14:0] k_i_i,  // u0.15, per sample
    input  logic [14:0] inductance_i,  // u0.15, voltage per current and speed
    input  logic [14:0] emf_i,  // u0.15, voltage per speed
    input  logic [14:0] limit_i,  // u0.15, length of the voltage vector
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
  logic kept_0;  // in steps 1-1, 5-5, 6-6, 9-9, 11-11, 17-24
  logic [7:0] kept_1;  // in steps 1-1
  logic [15:0] kept_2;  // in steps 1-1, 2-4, 5-5 sine, 6-6 sine, 10-24 i_gamma
  logic [2:0] kept_3;  // in steps 1-4, 5-5, 6-6
  logic kept_4;  // in steps 1-6, 11-16, 20-24
  logic [15:0] kept_5;  // in steps 1-16, 17-18 gamma_voltage, 19-19 limit, 20-20, 24-24
  logic [32:0] kept_6;  // in steps 3-3, 4-6, 7-7, 8-8, 9-9 product, 10-10, 11-11, 12-24 i_delta
  logic [20:0] kept_7;  // in steps 3-5, 12-13 coupling, 14-15, 16-16 wanted, 17-17 emf, 18-18 ahead, 19-19 wanted
  logic kept_8;  // in steps 5-5, 6-6, 20-20, 23-23, 24-24
  logic [31:0] kept_9;  // in steps 6-21, 22-23
  logic [31:0] kept_10;  // in steps 7-20, 21-21
  logic [32:0] kept_11;  // in steps 11-11 product, 13-16 moved, 18-20 moved, 23-23 product, 24-24 product
  logic [15:0] kept_12;  // in steps 13-19 error
  logic [16:0] kept_13;  // in steps 15-15, 16-17, 18-18
  logic [31:0] kept_14;  // in steps 20-22
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

  wire [9:0] sum_55 = angle_i[15:6] + 10'd256;  // line 55
  wire [16:0] wide_55 = {kept_2[15], kept_2};  // line 55
  wire [32:0] wide_55_2 = {product[31], product};  // line 55
  wire [32:0] sum_55_2 = wide_55_2 + 33'd4194304;  // line 55
  wire [16:0] wide_55_3 = {{7{sum_55_2[32]}}, sum_55_2[32:23]};  // line 55
  wire [32:0] wide_58 = {kept_6[31], kept_6[31:0]};  // line 58
  wire [16:0] wide_55_4 = {kept_7[15], kept_7[15:0]};  // line 55
  wire [33:0] sum_90 = {kept_6[32], kept_6} + 34'd16384;  // line 90
  wire [16:0] difference_63 = {set_gamma_i[15], set_gamma_i} - wide_55;  // line 63
  wire [15:0] error =  // line 63
      difference_63[16] ? ((difference_63[16:15] == 2'd3) ? difference_63[15:0] : 16'd32768) :
      (difference_63[16:15] == 2'd0) ? difference_63[15:0] :
      16'd32767;
  wire [28:0] wide_96 = {product[30], product[30:3]};  // line 96
  wire [31:0] sum_90_2 = {product[30], product[30:0]} + 32'd16384;  // line 90
  wire [33:0] sum_90_3 = {kept_11[32], kept_11} + 34'd16384;  // line 90
  wire [32:0] sum_90_4 = wide_55_2 + 33'd16384;  // line 90
  wire [16:0] wide_64 = {kept_13[15], kept_13[15:0]};  // line 64
  wire [15:0] choice_65 = kept_5[15] ? -kept_5 : kept_5;  // line 65
  wire [20:0] seven = {2'd0, choice_65, 3'd0} - {5'd0, choice_65};  // line 66
  wire [7:0] choice_55_2 = (step == 5'd0) ? angle_i[13:6] ^ {8{sum_55[8]}} : kept_1;  // line 55

  logic [14:0] entry_55;  // kQuarterWave
  always_comb begin
    case (choice_55_2)
      8'd0: entry_55 = 15'd101;
      8'd1: entry_55 = 15'd302;
      8'd2: entry_55 = 15'd503;
      8'd3: entry_55 = 15'd704;
      8'd4: entry_55 = 15'd905;
      8'd5: entry_55 = 15'd1106;
      8'd6: entry_55 = 15'd1307;
      8'd7: entry_55 = 15'd1507;
      8'd8: entry_55 = 15'd1708;
      8'd9: entry_55 = 15'd1909;
      8'd10: entry_55 = 15'd2110;
      8'd11: entry_55 = 15'd2310;
      8'd12: entry_55 = 15'd2511;
      8'd13: entry_55 = 15'd2711;
      8'd14: entry_55 = 15'd2911;
      8'd15: entry_55 = 15'd3112;
      8'd16: entry_55 = 15'd3312;
      8'd17: entry_55 = 15'd3512;
      8'd18: entry_55 = 15'd3712;
      8'd19: entry_55 = 15'd3911;
      8'd20: entry_55 = 15'd4111;
      8'd21: entry_55 = 15'd4310;
      8'd22: entry_55 = 15'd4509;
      8'd23: entry_55 = 15'd4708;
      8'd24: entry_55 = 15'd4907;
      8'd25: entry_55 = 15'd5106;
      8'd26: entry_55 = 15'd5305;
      8'd27: entry_55 = 15'd5503;
      8'd28: entry_55 = 15'd5701;
      8'd29: entry_55 = 15'd5899;
      8'd30: entry_55 = 15'd6096;
      8'd31: entry_55 = 15'd6294;
      8'd32: entry_55 = 15'd6491;
      8'd33: entry_55 = 15'd6688;
      8'd34: entry_55 = 15'd6885;
      8'd35: entry_55 = 15'd7081;
      8'd36: entry_55 = 15'd7277;
      8'd37: entry_55 = 15'd7473;
      8'd38: entry_55 = 15'd7669;
      8'd39: entry_55 = 15'd7864;
      8'd40: entry_55 = 15'd8059;
      8'd41: entry_55 = 15'd8254;
      8'd42: entry_55 = 15'd8448;
      8'd43: entry_55 = 15'd8642;
      8'd44: entry_55 = 15'd8836;
      8'd45: entry_55 = 15'd9030;
      8'd46: entry_55 = 15'd9223;
      8'd47: entry_55 = 15'd9416;
      8'd48: entry_55 = 15'd9608;
      8'd49: entry_55 = 15'd9800;
      8'd50: entry_55 = 15'd9992;
      8'd51: entry_55 = 15'd10183;
      8'd52: entry_55 = 15'd10374;
      8'd53: entry_55 = 15'd10564;
      8'd54: entry_55 = 15'd10754;
      8'd55: entry_55 = 15'd10944;
      8'd56: entry_55 = 15'd11133;
      8'd57: entry_55 = 15'd11322;
      8'd58: entry_55 = 15'd11511;
      8'd59: entry_55 = 15'd11699;
      8'd60: entry_55 = 15'd11886;
      8'd61: entry_55 = 15'd12074;
      8'd62: entry_55 = 15'd12260;
      8'd63: entry_55 = 15'd12446;
      8'd64: entry_55 = 15'd12632;
      8'd65: entry_55 = 15'd12817;
      8'd66: entry_55 = 15'd13002;
      8'd67: entry_55 = 15'd13187;
      8'd68: entry_55 = 15'd13370;
      8'd69: entry_55 = 15'd13554;
      8'd70: entry_55 = 15'd13736;
      8'd71: entry_55 = 15'd13919;
      8'd72: entry_55 = 15'd14101;
      8'd73: entry_55 = 15'd14282;
      8'd74: entry_55 = 15'd14462;
      8'd75: entry_55 = 15'd14643;
      8'd76: entry_55 = 15'd14822;
      8'd77: entry_55 = 15'd15001;
      8'd78: entry_55 = 15'd15180;
      8'd79: entry_55 = 15'd15358;
      8'd80: entry_55 = 15'd15535;
      8'd81: entry_55 = 15'd15712;
      8'd82: entry_55 = 15'd15888;
      8'd83: entry_55 = 15'd16063;
      8'd84: entry_55 = 15'd16238;
      8'd85: entry_55 = 15'd16413;
      8'd86: entry_55 = 15'd16586;
      8'd87: entry_55 = 15'd16759;
      8'd88: entry_55 = 15'd16932;
      8'd89: entry_55 = 15'd17104;
      8'd90: entry_55 = 15'd17275;
      8'd91: entry_55 = 15'd17445;
      8'd92: entry_55 = 15'd17615;
      8'd93: entry_55 = 15'd17784;
      8'd94: entry_55 = 15'd17953;
      8'd95: entry_55 = 15'd18121;
      8'd96: entry_55 = 15'd18288;
      8'd97: entry_55 = 15'd18454;
      8'd98: entry_55 = 15'd18620;
      8'd99: entry_55 = 15'd18785;
      8'd100: entry_55 = 15'd18950;
      8'd101: entry_55 = 15'd19113;
      8'd102: entry_55 = 15'd19276;
      8'd103: entry_55 = 15'd19438;
      8'd104: entry_55 = 15'd19600;
      8'd105: entry_55 = 15'd19761;
      8'd106: entry_55 = 15'd19921;
      8'd107: entry_55 = 15'd20080;
      8'd108: entry_55 = 15'd20238;
      8'd109: entry_55 = 15'd20396;
      8'd110: entry_55 = 15'd20553;
      8'd111: entry_55 = 15'd20709;
      8'd112: entry_55 = 15'd20865;
      8'd113: entry_55 = 15'd21019;
      8'd114: entry_55 = 15'd21173;
      8'd115: entry_55 = 15'd21326;
      8'd116: entry_55 = 15'd21479;
      8'd117: entry_55 = 15'd21630;
      8'd118: entry_55 = 15'd21781;
      8'd119: entry_55 = 15'd21930;
      8'd120: entry_55 = 15'd22079;
      8'd121: entry_55 = 15'd22227;
      8'd122: entry_55 = 15'd22375;
      8'd123: entry_55 = 15'd22521;
      8'd124: entry_55 = 15'd22667;
      8'd125: entry_55 = 15'd22812;
      8'd126: entry_55 = 15'd22956;
      8'd127: entry_55 = 15'd23099;
      8'd128: entry_55 = 15'd23241;
      8'd129: entry_55 = 15'd23382;
      8'd130: entry_55 = 15'd23522;
      8'd131: entry_55 = 15'd23662;
      8'd132: entry_55 = 15'd23801;
      8'd133: entry_55 = 15'd23938;
      8'd134: entry_55 = 15'd24075;
      8'd135: entry_55 = 15'd24211;
      8'd136: entry_55 = 15'd24346;
      8'd137: entry_55 = 15'd24480;
      8'd138: entry_55 = 15'd24613;
      8'd139: entry_55 = 15'd24746;
      8'd140: entry_55 = 15'd24877;
      8'd141: entry_55 = 15'd25007;
      8'd142: entry_55 = 15'd25137;
      8'd143: entry_55 = 15'd25265;
      8'd144: entry_55 = 15'd25393;
      8'd145: entry_55 = 15'd25519;
      8'd146: entry_55 = 15'd25645;
      8'd147: entry_55 = 15'd25770;
      8'd148: entry_55 = 15'd25893;
      8'd149: entry_55 = 15'd26016;
      8'd150: entry_55 = 15'd26138;
      8'd151: entry_55 = 15'd26259;
      8'd152: entry_55 = 15'd26378;
      8'd153: entry_55 = 15'd26497;
      8'd154: entry_55 = 15'd26615;
      8'd155: entry_55 = 15'd26732;
      8'd156: entry_55 = 15'd26848;
      8'd157: entry_55 = 15'd26962;
      8'd158: entry_55 = 15'd27076;
      8'd159: entry_55 = 15'd27189;
      8'd160: entry_55 = 15'd27300;
      8'd161: entry_55 = 15'd27411;
      8'd162: entry_55 = 15'd27521;
      8'd163: entry_55 = 15'd27629;
      8'd164: entry_55 = 15'd27737;
      8'd165: entry_55 = 15'd27843;
      8'd166: entry_55 = 15'd27949;
      8'd167: entry_55 = 15'd28053;
      8'd168: entry_55 = 15'd28157;
      8'd169: entry_55 = 15'd28259;
      8'd170: entry_55 = 15'd28360;
      8'd171: entry_55 = 15'd28460;
      8'd172: entry_55 = 15'd28560;
      8'd173: entry_55 = 15'd28658;
      8'd174: entry_55 = 15'd28755;
      8'd175: entry_55 = 15'd28850;
      8'd176: entry_55 = 15'd28945;
      8'd177: entry_55 = 15'd29039;
      8'd178: entry_55 = 15'd29131;
      8'd179: entry_55 = 15'd29223;
      8'd180: entry_55 = 15'd29313;
      8'd181: entry_55 = 15'd29403;
      8'd182: entry_55 = 15'd29491;
      8'd183: entry_55 = 15'd29578;
      8'd184: entry_55 = 15'd29664;
      8'd185: entry_55 = 15'd29749;
      8'd186: entry_55 = 15'd29832;
      8'd187: entry_55 = 15'd29915;
      8'd188: entry_55 = 15'd29997;
      8'd189: entry_55 = 15'd30077;
      8'd190: entry_55 = 15'd30156;
      8'd191: entry_55 = 15'd30234;
      8'd192: entry_55 = 15'd30311;
      8'd193: entry_55 = 15'd30387;
      8'd194: entry_55 = 15'd30462;
      8'd195: entry_55 = 15'd30535;
      8'd196: entry_55 = 15'd30607;
      8'd197: entry_55 = 15'd30679;
      8'd198: entry_55 = 15'd30749;
      8'd199: entry_55 = 15'd30818;
      8'd200: entry_55 = 15'd30885;
      8'd201: entry_55 = 15'd30952;
      8'd202: entry_55 = 15'd31017;
      8'd203: entry_55 = 15'd31082;
      8'd204: entry_55 = 15'd31145;
      8'd205: entry_55 = 15'd31206;
      8'd206: entry_55 = 15'd31267;
      8'd207: entry_55 = 15'd31327;
      8'd208: entry_55 = 15'd31385;
      8'd209: entry_55 = 15'd31442;
      8'd210: entry_55 = 15'd31498;
      8'd211: entry_55 = 15'd31553;
      8'd212: entry_55 = 15'd31607;
      8'd213: entry_55 = 15'd31659;
      8'd214: entry_55 = 15'd31710;
      8'd215: entry_55 = 15'd31760;
      8'd216: entry_55 = 15'd31809;
      8'd217: entry_55 = 15'd31857;
      8'd218: entry_55 = 15'd31903;
      8'd219: entry_55 = 15'd31949;
      8'd220: entry_55 = 15'd31993;
      8'd221: entry_55 = 15'd32036;
      8'd222: entry_55 = 15'd32077;
      8'd223: entry_55 = 15'd32118;
      8'd224: entry_55 = 15'd32157;
      8'd225: entry_55 = 15'd32195;
      8'd226: entry_55 = 15'd32232;
      8'd227: entry_55 = 15'd32267;
      8'd228: entry_55 = 15'd32302;
      8'd229: entry_55 = 15'd32335;
      8'd230: entry_55 = 15'd32367;
      8'd231: entry_55 = 15'd32397;
      8'd232: entry_55 = 15'd32427;
      8'd233: entry_55 = 15'd32455;
      8'd234: entry_55 = 15'd32482;
      8'd235: entry_55 = 15'd32508;
      8'd236: entry_55 = 15'd32533;
      8'd237: entry_55 = 15'd32556;
      8'd238: entry_55 = 15'd32578;
      8'd239: entry_55 = 15'd32599;
      8'd240: entry_55 = 15'd32619;
      8'd241: entry_55 = 15'd32637;
      8'd242: entry_55 = 15'd32655;
      8'd243: entry_55 = 15'd32671;
      8'd244: entry_55 = 15'd32685;
      8'd245: entry_55 = 15'd32699;
      8'd246: entry_55 = 15'd32711;
      8'd247: entry_55 = 15'd32722;
      8'd248: entry_55 = 15'd32732;
      8'd249: entry_55 = 15'd32741;
      8'd250: entry_55 = 15'd32748;
      8'd251: entry_55 = 15'd32755;
      8'd252: entry_55 = 15'd32759;
      8'd253: entry_55 = 15'd32763;
      8'd254: entry_55 = 15'd32766;
      default: entry_55 = 15'd32767;
    endcase
  end

  wire [31:0] product_next = $signed(factor_a) * $signed(factor_b);  // line 72

  always_ff @(posedge clk) begin
    if (rst) begin
      integral_gamma <= 28'sd0;
      integral_delta <= 28'sd0;
      step <= 5'd0;
      kept_0 <= 1'b0;
      kept_1 <= 8'd0;
      kept_2 <= 16'd0;
      kept_3 <= 3'd0;
      kept_4 <= 1'b0;
      kept_5 <= 16'd0;
      kept_6 <= 33'd0;
      kept_7 <= 21'd0;
      kept_8 <= 1'b0;
      kept_9 <= 32'd0;
      kept_10 <= 32'd0;
      kept_11 <= 33'd0;
      kept_12 <= 16'd0;
      kept_13 <= 17'd0;
      kept_14 <= 32'd0;
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
    end else begin
      case (step)
        5'd0: begin
          logic [6:0] differ_55;
          logic [16:0] joined_57;
          logic [17:0] sum_57;
          differ_55 = {angle_i[5:0], 1'b0} ^ 7'h40;  // line 55
          joined_57 = {i_v_i, 1'b0};  // line 57
          sum_57 = {joined_57[16], joined_57} + {{2{i_u_i[15]}}, i_u_i};  // line 57
          step <= {4'd0, start_i};
          kept_0 <= sum_55[9];
          kept_1 <= angle_i[13:6] ^ {8{angle_i[14]}};
          kept_2 <= {1'b0, sum_57[14:0]};
          kept_3 <= sum_57[17:15];
          kept_4 <= sum_57[17];
          kept_5 <= -{2'd0, limit_i[14:1]};
          kQuarterWave_entry <= entry_55;
          factor_a <= {{9{differ_55[6]}}, differ_55};
          factor_b <= 16'd402;
        end
        5'd1, 5'd2: begin
          logic [15:0] difference_55;
          difference_55 = -{1'b0, kQuarterWave_entry};  // line 55
          case (step)
            5'd1: begin
              step <= step + 5'd1;
              if (kept_0) begin
                kept_2 <= difference_55;
              end else begin
                kept_2 <= {1'b0, kQuarterWave_entry};
              end
              kQuarterWave_entry <= entry_55;
              factor_a <= {1'b0, kept_2[14:0]};
              factor_b <= 16'd18919;
            end
            default: begin  // 5'd2
              step <= step + 5'd1;
              kept_6 <= {1'b0, {16{product[15]}}, product[15:0]};
              kept_7 <= {5'd0, angle_i[15] ? difference_55 : {1'b0, kQuarterWave_entry}};
              factor_a <= product[15:0];
              if (angle_i[15]) begin
                factor_b <= difference_55;
              end else begin
                factor_b <= {1'b0, kQuarterWave_entry};
              end
            end
          endcase
        end
        5'd3: begin
          step <= step + 5'd1;
          kept_6 <= {18'd0, product[29:15]};
          factor_a <= kept_6[15:0];
          factor_b <= kept_2;
        end
        5'd4: begin
          logic [16:0] difference_55_2;
          difference_55_2 = wide_55 - wide_55_3;  // line 55
          step <= step + 5'd1;
          kept_0 <= difference_55_2[16:15] == 2'd3;
          kept_2 <= difference_55_2[15:0];
          kept_3 <= {2'd0, difference_55_2[16:15] == 2'd0};
          kept_8 <= difference_55_2[16];
          factor_a <= {{13{kept_3[2]}}, kept_3};
          factor_b <= 16'd18919;
        end
        5'd5, 5'd6: begin
          logic [15:0] choice_55;
          choice_55 = kept_0 ? kept_2 : 16'd32768;  // line 55
          case (step)
            5'd5: begin
              logic [15:0] _cosine;
              logic [16:0] sum_55_3;
              _cosine =  // line 55
                  kept_8 ? choice_55 :
                  kept_3[0] ? kept_2 :
                  16'd32767;
              sum_55_3 = wide_55_4 + wide_55_3;  // line 55
              step <= step + 5'd1;
              kept_0 <= sum_55_3[16:15] == 2'd3;
              kept_2 <= sum_55_3[15:0];
              kept_3 <= {2'd0, sum_55_3[16]};
              kept_8 <= sum_55_3[16:15] == 2'd0;
              kept_9 <= {{16{_cosine[15]}}, _cosine};
              factor_a <= i_u_i;
              if (kept_8) begin
                if (kept_0) begin
                  factor_b <= kept_2;
                end else begin
                  factor_b <= 16'd32768;
                end
              end else if (kept_3[0]) begin
                factor_b <= kept_2;
              end else begin
                factor_b <= 16'd32767;
              end
            end
            default: begin  // 5'd6
              logic [18:0] sum_57_2;
              logic [15:0] _sine;
              sum_57_2 = {4'd0, kept_6[14:0]} + product[18:0];  // line 57
              _sine =  // line 55
                  kept_3[0] ? choice_55 :
                  kept_8 ? kept_2 :
                  16'd32767;
              step <= step + 5'd1;
              if (kept_4) begin
                logic [15:0] choice_57;
                choice_57 = (sum_57_2[18:15] == 4'd15) ? sum_57_2[15:0] : 16'd32768;  // line 57
                kept_6 <= {1'b0, {16{choice_57[15]}}, choice_57};
                if (sum_57_2[18:15] == 4'd15) begin
                  factor_a <= sum_57_2[15:0];
                end else begin
                  factor_a <= 16'd32768;
                end
              end else begin
                logic [15:0] choice_57_2;
                choice_57_2 = (sum_57_2[18:15] == 4'd0) ? sum_57_2[15:0] : 16'd32767;  // line 57
                kept_6 <= {1'b0, {16{choice_57_2[15]}}, choice_57_2};
                if (sum_57_2[18:15] == 4'd0) begin
                  factor_a <= sum_57_2[15:0];
                end else begin
                  factor_a <= 16'd32767;
                end
              end
              kept_10 <= {{16{_sine[15]}}, _sine};
              if (kept_3[0]) begin
                if (kept_0) begin
                  factor_b <= kept_2;
                end else begin
                  factor_b <= 16'd32768;
                end
              end else if (kept_8) begin
                factor_b <= kept_2;
              end else begin
                factor_b <= 16'd32767;
              end
            end
          endcase
        end
        5'd7: begin
          step <= step + 5'd1;
          kept_6 <= {1'b0, product};
          factor_a <= kept_6[15:0];
          factor_b <= kept_9[15:0];
        end
        5'd8: begin
          logic [32:0] product_2;
          product_2 = wide_58 + wide_55_2;  // line 58
          step <= step + 5'd1;
          kept_0 <= product_2[32] && product_2[31:14] != 18'd262143;
          kept_6 <= product_2;
          factor_a <= i_u_i;
          factor_b <= kept_10[15:0];
        end
        5'd9: begin
          step <= step + 5'd1;
          if (kept_0) begin
            if (sum_90[33:30] == 4'd15) begin
              kept_2 <= sum_90[30:15];
            end else begin
              kept_2 <= 16'd32768;
            end
          end else if (sum_90[33:30] == 4'd0) begin
            kept_2 <= sum_90[30:15];
          end else begin
            kept_2 <= 16'd32767;
          end
          kept_6 <= {1'b0, product};
          factor_a <= speed_i;
          factor_b <= {1'b0, inductance_i};
        end
        5'd10: begin
          logic [32:0] product_3;
          logic [16:0] wide_2;
          logic [32:0] wide_3;
          product_3 = wide_58 - wide_55_2;  // line 59
          wide_2 = {difference_63[15], difference_63[15:0]};
          wide_3 = {2'd0, {14{wide_2[16]}}, wide_2};
          step <= step + 5'd1;
          kept_0 <= product_3[32] && product_3[31:14] != 18'd262143;
          kept_4 <= error[15];
          if (difference_63[16]) begin
            if (difference_63[16:15] == 2'd3) begin
              kept_6 <= wide_3;
              factor_a <= difference_63[15:0];
            end else begin
              kept_6 <= 33'd2147450880;
              factor_a <= 16'd32768;
            end
          end else if (difference_63[16:15] == 2'd0) begin
            kept_6 <= wide_3;
            factor_a <= difference_63[15:0];
          end else begin
            kept_6 <= 33'd32767;
            factor_a <= 16'd32767;
          end
          kept_11 <= product_3;
          factor_b <= {1'b0, k_i_i};
        end
        5'd11, 5'd16: begin
          logic [15:0] coupling;
          coupling =  // line 90
              (product[30] && product[29:14] != 16'd65535) ?
              ((sum_90_2[31:30] == 2'd3) ? sum_90_2[30:15] : 16'd32768) :
              (sum_90_2[31:30] == 2'd0) ? sum_90_2[30:15] :
              16'd32767;
          case (step)
            5'd11: begin
              logic [15:0] i_delta;
              logic [16:0] wide;
              i_delta =  // line 90
                  kept_0 ? ((sum_90_3[33:30] == 4'd15) ? sum_90_3[30:15] : 16'd32768) :
                  (sum_90_3[33:30] == 4'd0) ? sum_90_3[30:15] :
                  16'd32767;
              wide = {1'b0, i_delta};
              step <= step + 5'd1;
              kept_6 <= {2'd0, {14{wide[16]}}, wide};
              kept_7 <= {5'd0, coupling};
              factor_a <= kept_6[15:0];
              factor_b <= {1'b0, k_p_i};
            end
            default: begin  // 5'd16
              if (enable_i) begin
                logic below_99;
                logic at_most_98;
                below_99 = $signed(kept_7) < $signed({{5{kept_5[15]}}, kept_5});  // line 99
                at_most_98 = $signed(kept_7) <= $signed({7'd0, limit_i[14:1]});  // line 98
                if (at_most_98 || kept_4) begin
                  if (!(below_99 && kept_4)) begin
                    integral_gamma <= kept_11[27:0];
                  end
                  if (at_most_98) begin
                    if (!below_99) begin
                      kept_5 <= kept_7[15:0];
                    end
                  end else begin
                    kept_5 <= {2'd0, limit_i[14:1]};
                  end
                end else begin
                  kept_5 <= {2'd0, limit_i[14:1]};
                end
                kept_0 <= $signed({7'd0, limit_i[14:1]}) < $signed(kept_7) || below_99;
              end else begin
                integral_gamma <= 28'd0;
                kept_0 <= 1'b0;
                kept_5 <= 16'd0;
              end
              step <= step + 5'd1;
              kept_7 <= {5'd0, coupling};
              factor_a <= kept_12;
              factor_b <= {1'b0, k_p_i};
            end
          endcase
        end
        5'd12: begin
          logic [28:0] sum_96;
          logic [27:0] moved;
          logic [16:0] difference_68;
          sum_96 = {integral_gamma[27], integral_gamma} + wide_96;  // line 96
          moved =  // line 96
              sum_96[28] ? ((sum_96[28:27] == 2'd3) ? sum_96[27:0] : 28'd134217728) :
              (sum_96[28:27] == 2'd0) ? sum_96[27:0] :
              28'd134217727;
          difference_68 = {set_delta_i[15], set_delta_i} - {kept_6[15], kept_6[15:0]};  // line 68
          step <= step + 5'd1;
          kept_11 <= {5'd0, moved};
          if (difference_68[16]) begin
            if (difference_68[16:15] == 2'd3) begin
              kept_12 <= difference_68[15:0];
            end else begin
              kept_12 <= 16'd32768;
            end
          end else if (difference_68[16:15] == 2'd0) begin
            kept_12 <= difference_68[15:0];
          end else begin
            kept_12 <= 16'd32767;
          end
          factor_a <= kept_7[15:0];
          factor_b <= kept_6[15:0];
        end
        5'd13, 5'd18: begin
          logic [19:0] sum_97;
          sum_97 = {{4{kept_11[27]}}, kept_11[27:12]} + {product[30], product[30:12]};  // line 97
          case (step)
            5'd13: begin
              step <= step + 5'd1;
              kept_7 <= {1'b0, sum_97};
              factor_a <= kept_7[15:0];
              factor_b <= kept_2;
            end
            default: begin  // 5'd18
              logic [17:0] left;
              logic [14:0] limit;
              left = {3'd0, limit_i} - {kept_13[16], kept_13};  // line 67
              limit =  // line 69
                  left[17] ? 15'd0 :
                  (left[17:15] == 3'd0) ? left[14:0] :
                  15'd32767;
              step <= step + 5'd1;
              kept_5 <= {1'b0, limit};
              kept_7 <= {sum_97[19], sum_97} + {{4{kept_7[16]}}, kept_7[16:0]};
              factor_a <= kept_5;
              factor_b <= kept_10[15:0];
            end
          endcase
        end
        5'd14, 5'd15: begin
          logic [15:0] choice_90;
          choice_90 =  // line 90
              (product[31] && product[30:14] != 17'd131071) ?
              ((sum_90_4[32:30] == 3'd7) ? sum_90_4[30:15] : 16'd32768) :
              (sum_90_4[32:30] == 3'd0) ? sum_90_4[30:15] :
              16'd32767;
          case (step)
            5'd14: begin
              step <= step + 5'd1;
              kept_13 <= {1'b0, choice_90};
              factor_a <= speed_i;
              factor_b <= {1'b0, emf_i};
            end
            default: begin  // 5'd15
              logic [16:0] ahead;
              ahead = -wide_64;  // line 64
              step <= step + 5'd1;
              kept_7 <= {kept_7[19], kept_7[19:0]} + {{4{ahead[16]}}, ahead};
              kept_13 <= {1'b0, choice_90};
              factor_a <= kept_12;
              factor_b <= {1'b0, k_i_i};
            end
          endcase
        end
        5'd17: begin
          logic [28:0] sum_96_2;
          logic [27:0] moved_2;
          logic [16:0] ahead_2;
          sum_96_2 = {integral_delta[27], integral_delta} + wide_96;  // line 96
          moved_2 =  // line 96
              sum_96_2[28] ? ((sum_96_2[28:27] == 2'd3) ? sum_96_2[27:0] : 28'd134217728) :
              (sum_96_2[28:27] == 2'd0) ? sum_96_2[27:0] :
              28'd134217727;
          ahead_2 = wide_64 + wide_55_4;  // line 69
          step <= step + 5'd1;
          kept_7 <= {4'd0, ahead_2};
          kept_11 <= {5'd0, moved_2};
          kept_13 <= seven[20:4];
          factor_a <= kept_5;
          factor_b <= kept_9[15:0];
        end
        5'd19: begin
          logic [15:0] difference_99;
          logic below_99_2;
          logic at_most_98_2;
          difference_99 = -{1'b0, kept_5[14:0]};  // line 99
          below_99_2 = $signed(kept_7) < $signed({{5{difference_99[15]}}, difference_99});
          at_most_98_2 = $signed(kept_7) <= $signed({6'd0, kept_5[14:0]});  // line 98
          step <= step + 5'd1;
          kept_4 <= enable_i && ($signed({6'd0, kept_5[14:0]}) < $signed(kept_7) || below_99_2);
          if (at_most_98_2) begin
            if (below_99_2) begin
              kept_5 <= difference_99;
            end else begin
              kept_5 <= kept_7[15:0];
            end
          end else begin
            kept_5 <= {1'b0, kept_5[14:0]};
          end
          kept_8 <= !(at_most_98_2 || kept_12[15]) || (below_99_2 && kept_12[15]);
          kept_14 <= product;
        end
        5'd20: begin
          logic [15:0] delta_voltage;
          delta_voltage = enable_i ? kept_5 : 16'd0;  // line 68
          if (enable_i) begin
            if (!kept_8) begin
              integral_delta <= kept_11[27:0];
            end
            factor_a <= kept_5;
          end else begin
            integral_delta <= 28'd0;
            factor_a <= 16'd0;
          end
          step <= step + 5'd1;
          kept_10 <= {{16{delta_voltage[15]}}, delta_voltage};
          factor_b <= kept_10[15:0];
        end
        5'd21: begin
          step <= step + 5'd1;
          kept_9 <= product;
          factor_a <= kept_10[15:0];
          factor_b <= kept_9[15:0];
        end
        5'd22: begin
          logic [32:0] product_4;
          product_4 = {kept_14[31], kept_14} - wide_55_2;  // line 71
          step <= step + 5'd1;
          kept_8 <= product_4[32] && product_4[31:14] != 18'd262143;
          kept_11 <= product_4;
        end
        5'd23: begin
          logic [32:0] product_5;
          product_5 = {kept_9[31], kept_9} + wide_55_2;  // line 72
          step <= step + 5'd1;
          if (kept_8) begin
            if (sum_90_3[33:30] == 4'd15) begin
              kept_5 <= sum_90_3[30:15];
            end else begin
              kept_5 <= 16'd32768;
            end
          end else if (sum_90_3[33:30] == 4'd0) begin
            kept_5 <= sum_90_3[30:15];
          end else begin
            kept_5 <= 16'd32767;
          end
          kept_8 <= product_5[32] && product_5[31:14] != 18'd262143;
          kept_11 <= product_5;
        end
        5'd24: begin
          step <= 5'd0;
          v_alpha_held <= kept_5;
          if (kept_8) begin
            if (sum_90_3[33:30] == 4'd15) begin
              v_beta_held <= sum_90_3[30:15];
            end else begin
              v_beta_held <= 16'd32768;
            end
          end else if (sum_90_3[33:30] == 4'd0) begin
            v_beta_held <= sum_90_3[30:15];
          end else begin
            v_beta_held <= 16'd32767;
          end
          i_gamma_held <= kept_2;
          i_delta_held <= kept_6[15:0];
          limited_held <= kept_0 || kept_4;
        end
        default: step <= step + 5'd1;
      endcase
      product <= product_next;  // line 72
      done <= step == 5'd24;
      missed <= start_i && step != 5'd0;
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
      &{1'b0, kept_10[31:16], sum_55[7:0], sum_55_2[22:0], sum_90[14:0], error[14:0],
      sum_90_2[14:0], sum_90_3[14:0], sum_90_4[14:0], seven[3:0]};
endmodule
