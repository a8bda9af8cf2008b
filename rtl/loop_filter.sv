// loop_filter: steplock::LoopFilter, printed by hlsgen from hls/six_step/loop_filter.hpp:34.
// Do not edit: change the C++ and print again.

module loop_filter (
    input  logic        clk,
    input  logic        rst,  // synchronous, active high
    input  logic [2:0]  loop_i,
    input  logic [15:0] error_i,  // s0.16, turns of one step; held between updates
    input  logic        update_i,  // strobe: the error is new
    input  logic        tick_i,  // strobe: time base of ramp and per-second form
    input  logic        load_i,  // takes load_frequency and drops work in flight
    input  logic [25:0] load_frequency_i,  // u0.32, VCO turns per clock
    input  logic [19:0] ramp_i,  // u0.32, VCO turns per clock, per tick
    input  logic        bandwidth_i,
    input  logic [9:0]  delay_i,  // clocks / 2^divide
    input  logic [15:0] ki_i,  // u2.14
    input  logic [15:0] kp_i,  // u2.14
    input  logic [15:0] pole_i,  // u1.15
    input  logic [25:0] scale_i,  // u0.32, stands for the frequency in the per-second form
    input  logic [25:0] minimum_i,  // u0.32, VCO turns per clock
    input  logic [25:0] maximum_i,  // u0.32, VCO turns per clock
    output logic [25:0] frequency_o,  // u0.32, VCO turns per clock
    output logic        busy_o  // an update is being worked on
);
  localparam logic [2:0] Loop_kHold = 3'd0;
  localparam logic [2:0] Loop_kRamp = 3'd1;
  localparam logic [2:0] Loop_kTrack = 3'd2;
  localparam logic [2:0] Loop_kHall = 3'd4;
  localparam logic [2:0] Stage_kIdle = 3'd0;
  localparam logic [2:0] Stage_kDelay = 3'd1;
  localparam logic [2:0] Stage_kScale = 3'd2;
  localparam logic [2:0] Stage_kIntegral = 3'd3;
  localparam logic [2:0] Stage_kBoundX = 3'd4;
  localparam logic [2:0] Stage_kProportional = 3'd5;
  localparam logic [2:0] Stage_kPole = 3'd6;
  localparam logic [2:0] Stage_kBoundY = 3'd7;

  logic [2:0] stage;
  logic started;  // the stage's product is under way
  logic [36:0] work;  // frequency, then e', p, v and the next y
  logic [36:0] x;  // u0.40, the integrator
  logic [33:0] y;  // u0.40, behind the pole
  logic at_top;  // the output stands at a limit
  logic at_bottom;

  wire [33:0] choice_63 = (stage == Stage_kPole) ? y : 34'd0;  // line 63
  wire [9:0] choice_95 = (loop_i == Loop_kTrack) ? delay_i : 10'd0;  // line 95
  wire [25:0] choice_96 = (loop_i != Loop_kTrack || bandwidth_i) ? y[33:8] : scale_i;  // line 96
  wire [14:0] choice_97 = (loop_i == Loop_kHall) ? 15'd4096 : 15'd16384;  // line 97
  wire [15:0] choice_63_2 =  // line 63
      (stage == Stage_kIntegral) ? ((loop_i == Loop_kTrack) ? ki_i : {1'b0, choice_97}) :
      (stage == Stage_kProportional) ? kp_i : pole_i;
  wire [1:0] choice_109 = (loop_i == Loop_kRamp) ? 2'd3 : 2'd1;  // line 109
  wire choice =
      (loop_i == Loop_kRamp || (loop_i == Loop_kTrack && !bandwidth_i)) ? tick_i : update_i;
  wire both_106 = loop_i != Loop_kHold && choice;  // line 106
  wire [1:0] choice_2 = (stage == Stage_kProportional) ? 2'd2 : 2'd3;
  wire [2:0] wide = {choice_2[1], choice_2};

  logic [2:0] choice_3;
  always_comb begin
    case (stage)
      Stage_kDelay: choice_3 = Stage_kScale;
      Stage_kScale: choice_3 = Stage_kIntegral;
      Stage_kIntegral: choice_3 = Stage_kBoundX;
      default: choice_3 = wide;
    endcase
  end

  wire [62:0] multiplier_product;
  wire multiplier_done;
  wire unused_multiplier_busy;
  serial_multiplier_37_26 multiplier (
      .clk(clk),
      .rst(rst),
      .start_i(!(stage == Stage_kIdle || stage == Stage_kBoundX || stage == Stage_kBoundY) &&
        !started),
      .a_i(work - {3'd0, choice_63}),
      .b_i((stage == Stage_kDelay) ? {16'd0, choice_95} :
        (stage == Stage_kScale) ? choice_96 : {10'd0, choice_63_2}),
      .product_o(multiplier_product),
      .done_o(multiplier_done),
      .busy_o(unused_multiplier_busy)
  );

  logic [2:0] choice_4;
  always_comb begin
    case (stage)
      Stage_kIdle: choice_4 = both_106 ? {1'b0, choice_109} : stage;
      Stage_kBoundX: choice_4 = (loop_i == Loop_kTrack) ? Stage_kProportional : Stage_kBoundY;
      Stage_kBoundY: choice_4 = Stage_kIdle;
      default: choice_4 = multiplier_done ? choice_3 : stage;
    endcase
  end

  logic choice_5;
  always_comb begin
    case (stage)
      Stage_kIdle, Stage_kBoundX, Stage_kBoundY: choice_5 = started;
      default: choice_5 = !multiplier_done;
    endcase
  end

  wire [27:0] choice_107 = (loop_i == Loop_kRamp) ? {ramp_i, 8'd0} : {2'd0, y[33:8]};  // line 107
  wire [33:0] low = (loop_i == Loop_kRamp) ? 34'd0 : {minimum_i, 8'd0};  // line 141
  wire [33:0] joined_142 = {maximum_i, 8'd0};  // line 142
  wire [36:0] x_2 =  // line 143
      ($signed(x) < $signed({3'd0, low})) ? {3'd0, low} :
      ($signed(x) < $signed({3'd0, joined_142})) ? x : {3'd0, joined_142};
  wire [21:0] sum_114 =  // line 114
      {{6{error_i[15]}}, error_i} + {multiplier_product[36], multiplier_product[36:16]};
  wire [21:0] choice_114 = ($signed(sum_114) < 22'sd32767) ? sum_114 : 22'd32767;  // line 114
  wire [21:0] choice_114_2 = ($signed(choice_114) < -22'sd32768) ? 22'd4161536 : choice_114;
  wire [36:0] wide_114 = {{15{choice_114_2[21]}}, choice_114_2};  // line 114
  wire [36:0] part_118 = multiplier_product[44:8];  // line 118
  wire [36:0] sum_128 = x + multiplier_product[50:14];  // line 128
  wire [36:0] sum_132 = {3'd0, y} + multiplier_product[51:15];  // line 132

  logic [36:0] choice_6;
  always_comb begin
    case (stage)
      Stage_kDelay: choice_6 = wide_114;
      Stage_kScale: choice_6 = part_118;
      Stage_kIntegral: choice_6 = work;
      Stage_kProportional: choice_6 = sum_128;
      default: choice_6 = sum_132;
    endcase
  end

  logic [36:0] choice_7;
  always_comb begin
    case (stage)
      Stage_kIdle: choice_7 = both_106 ? {9'd0, choice_107} : work;
      Stage_kBoundX: choice_7 = (loop_i == Loop_kTrack) ? work : x_2;
      Stage_kBoundY: choice_7 = work;
      default: choice_7 = multiplier_done ? choice_6 : work;
    endcase
  end

  wire [33:0] joined_65 = {load_frequency_i, 8'd0};  // line 65
  wire both = multiplier_done && stage == Stage_kIntegral && !(work[36] ? at_bottom : at_top);

  logic [36:0] choice_8;
  always_comb begin
    case (stage)
      Stage_kIdle, Stage_kBoundY: choice_8 = x;
      Stage_kBoundX: choice_8 = x_2;
      default: choice_8 = both ? sum_128 : x;
    endcase
  end

  wire choice_9 = (stage == Stage_kBoundY) ? $signed({3'd0, joined_142}) < $signed(work) : at_top;
  wire choice_10 = (stage == Stage_kBoundY) ? work[36] : at_bottom;

  always_ff @(posedge clk) begin
    if (rst) begin
      stage <= Stage_kIdle;
      started <= 1'b0;
      work <= 37'sd0;
      x <= 37'sd0;
      y <= 34'd0;
      at_top <= 1'b0;
      at_bottom <= 1'b0;
    end else begin
      if (load_i) begin
        stage <= Stage_kIdle;
        x <= {3'd0, joined_65};
        y <= joined_65;
      end else begin
        stage <= choice_4;
        work <= choice_7;
        x <= choice_8;
        if (stage == Stage_kBoundY) begin
          if (work[36]) begin
            y <= 34'd0;
          end else if ($signed(work) < $signed({3'd0, joined_142})) begin
            y <= work[33:0];
          end else begin
            y <= joined_142;
          end
        end
      end
      started <= !load_i && choice_5;
      at_top <= !load_i && choice_9;
      at_bottom <= !load_i && choice_10;
    end
  end

  assign frequency_o = y[33:8];
  assign busy_o = stage != Stage_kIdle;

  // What nothing reads, for the linters.
  wire unused = &{1'b0, multiplier_product[7:0], multiplier_product[62:52]};
endmodule
