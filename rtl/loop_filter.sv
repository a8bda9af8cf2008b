// loop_filter: steplock::LoopFilter, printed by hlsgen from hls/six_step/loop_filter.hpp:37.
// Do not edit: change the C++ and print again.

module loop_filter (
    input  logic        clk,
    input  logic        rst,  // synchronous, active high
    input  logic [2:0]  loop_i,
    input  logic [15:0] error_i,  // s0.16, turns of one step; held between updates
    input  logic        update_i,  // strobe: the error is new
    input  logic        tick_i,  // strobe: time base of ramp and per-second form
    input  logic [19:0] ramp_i,  // u0.32, VCO turns per clock, per tick
    input  logic [1:0]  gentle_i,  // the ramp is quartered so often
    input  logic        bandwidth_i,
    input  logic [9:0]  delay_i,  // clocks / 2^divide
    input  logic [15:0] ki_i,  // u2.14
    input  logic [15:0] kp_i,  // u2.14
    input  logic [15:0] pole_i,  // u1.15
    input  logic [25:0] scale_i,  // u0.32, stands for the frequency in the per-second form
    input  logic [25:0] minimum_i,  // u0.32, VCO turns per clock
    input  logic [25:0] maximum_i,  // u0.32, VCO turns per clock
    input  logic [25:0] hand_over_i,  // u0.32, VCO turns per clock
    input  logic [25:0] stall_i,  // u0.32, VCO turns per clock
    output logic [25:0] frequency_o,  // u0.32, VCO turns per clock
    output logic        fast_o,  // frequency >= hand_over
    output logic        slow_o,  // frequency < stall
    output logic        busy_o  // an update is being worked on
);
  localparam logic [2:0] Loop_kStop = 3'd0;
  localparam logic [2:0] Loop_kRamp = 3'd1;
  localparam logic [2:0] Loop_kTrack = 3'd2;
  localparam logic [2:0] Loop_kHall = 3'd4;
  localparam logic [3:0] Stage_kIdle = 4'd0;
  localparam logic [3:0] Stage_kDelay = 4'd1;
  localparam logic [3:0] Stage_kScale = 4'd2;
  localparam logic [3:0] Stage_kIntegral = 4'd3;
  localparam logic [3:0] Stage_kProportional = 4'd4;
  localparam logic [3:0] Stage_kPole = 4'd5;
  localparam logic [3:0] Stage_kKeep = 4'd6;
  localparam logic [3:0] Stage_kLow = 4'd7;
  localparam logic [3:0] Stage_kHigh = 4'd8;
  localparam logic [3:0] Stage_kSlow = 4'd9;
  localparam logic [3:0] Stage_kOut = 4'd10;

  logic [3:0] stage;
  logic started;  // the stage's product is under way
  logic [33:0] work;  // e', p, v, and the next y
  logic [33:0] x;  // s-2.36, the integrator
  logic [29:0] y;  // u0.36, behind the pole
  logic fast;
  logic slow;
  logic at_top;  // the output stands at a limit
  logic at_bottom;

  wire [9:0] choice_114 = (loop_i == Loop_kTrack) ? delay_i : 10'd0;  // line 114
  wire [21:0] choice_73 =  // line 73
      (loop_i == Loop_kRamp) ? {2'd0, ramp_i} :
      (loop_i != Loop_kTrack || bandwidth_i) ? y[29:8] :
      scale_i[25:4];
  wire both_129 =  // line 129
      loop_i == Loop_kHall && (error_i[15] || !error_i[14]) && (!error_i[15] || error_i[14]);
  wire [14:0] choice_73_2 = (stage == Stage_kPole) ? pole_i[15:1] : 15'd16384 - pole_i[15:1];
  wire [15:0] wide_73 = {1'b0, choice_73_2};  // line 73
  wire [15:0] choice_73_3 =  // line 73
      (stage == Stage_kIntegral) ?
      ((loop_i == Loop_kTrack) ? ki_i : {1'b0, both_129 ? 15'd4096 : 15'd16384}) :
      (stage == Stage_kProportional) ? kp_i :
      wide_73;

  wire [55:0] multiplier_product;
  wire multiplier_done;
  wire unused_multiplier_busy;
  serial_multiplier_34_22 multiplier (
      .clk(clk),
      .rst(rst),
      .start_i(stage - 4'd1 < 4'd6 && !started),
      .a_i((stage == Stage_kDelay || stage == Stage_kKeep) ? {4'd0, y} : work),
      .b_i((stage == Stage_kDelay) ? {12'd0, choice_114} :
        (stage == Stage_kScale) ? choice_73 :
        {6'd0, choice_73_3}),
      .shift_i(4'd0),
      .product_o(multiplier_product),
      .done_o(multiplier_done),
      .busy_o(unused_multiplier_busy)
  );

  always_ff @(posedge clk) begin
    if (loop_i == Loop_kStop) begin
      stage <= Stage_kIdle;
      started <= 1'b0;
      x <= 34'd0;
      y <= 30'd0;
      fast <= 1'b0;
      slow <= 1'b0;
      at_top <= 1'b0;
      at_bottom <= 1'b0;
    end else begin
      case (stage)
        Stage_kIdle: begin
          if ((loop_i == Loop_kRamp || (loop_i == Loop_kTrack && !bandwidth_i)) ?
              tick_i : update_i) begin
            stage <= Stage_kDelay;
          end
        end
        Stage_kDelay, Stage_kScale, Stage_kProportional, Stage_kPole, Stage_kKeep,
        Stage_kIntegral: begin
          logic [8:0] choice_135;
          logic [10:0] choice_135_2;
          logic [12:0] wide_135;
          logic [12:0] choice_135_3;
          logic [15:0] error;
          logic [33:0] base;
          logic [33:0] base_2;  // line 83
          logic [33:0] sum;
          choice_135 = (gentle_i == 2'd2) ? 9'd256 : 9'd64;  // line 135
          choice_135_2 = (gentle_i == 2'd1) ? 11'd1024 : {2'd0, choice_135};  // line 135
          wide_135 = {2'd0, choice_135_2};  // line 135
          choice_135_3 = (gentle_i == 2'd0) ? 13'd4096 : wide_135;  // line 135
          error = (loop_i == Loop_kRamp) ? {3'd0, choice_135_3} : error_i;  // line 135
          base = {{12{error[15]}}, error, 6'd0};  // line 136
          case (stage)
            Stage_kDelay: base_2 = base;
            Stage_kIntegral, Stage_kProportional: base_2 = x;
            Stage_kKeep: base_2 = work;
            default: base_2 = 34'd0;
          endcase
          sum = base_2 + multiplier_product[47:14];  // line 140
          case (stage)
            Stage_kDelay, Stage_kScale, Stage_kProportional, Stage_kPole, Stage_kKeep: begin
              if (multiplier_done) begin
                stage <= stage + 4'd1;
                work <= sum;
              end
              started <= !multiplier_done;
            end
            default: begin  // Stage_kIntegral
              if (multiplier_done) begin
                if (loop_i != Loop_kTrack) begin
                  stage <= Stage_kLow;
                  work <= sum;
                end else begin
                  stage <= stage + 4'd1;
                  if (!(work[33] ? at_bottom : at_top)) begin
                    x <= sum;
                  end
                end
              end
              started <= !multiplier_done;
            end
          endcase
        end
        default: begin
          logic [25:0] choice_165;
          logic [25:0] limit;  // line 74
          logic below_75;
          choice_165 = (loop_i == Loop_kRamp) ? 26'd0 : minimum_i;  // line 165
          case (stage)
            Stage_kLow: limit = choice_165;
            Stage_kHigh: limit = maximum_i;
            Stage_kSlow: limit = stall_i;
            default: limit = hand_over_i;
          endcase
          below_75 = $signed(work[33:4]) < $signed({4'd0, limit});  // line 75
          case (stage)
            Stage_kLow: begin
              stage <= Stage_kHigh;
              if (below_75) begin
                work <= {4'd0, choice_165, 4'd0};
              end
              at_bottom <= below_75;
            end
            Stage_kHigh: begin
              stage <= Stage_kSlow;
              if (!below_75) begin
                work <= {4'd0, maximum_i, 4'd0};
              end
              at_top <= !below_75;
            end
            Stage_kSlow: begin
              stage <= Stage_kOut;
              slow <= below_75;
            end
            default: begin
              stage <= Stage_kIdle;
              if (loop_i != Loop_kTrack) begin
                x <= work;
              end
              y <= work[29:0];
              fast <= ($signed({4'd0, limit}) <= $signed(work[33:4]));
            end
          endcase
        end
      endcase
    end
    if (rst) begin
      stage <= Stage_kIdle;
      started <= 1'b0;
      work <= 34'sd0;
      x <= 34'sd0;
      y <= 30'd0;
      fast <= 1'b0;
      slow <= 1'b0;
      at_top <= 1'b0;
      at_bottom <= 1'b0;
    end
  end

  assign frequency_o = y[29:4];
  assign fast_o = fast;
  assign slow_o = slow;
  assign busy_o = stage != Stage_kIdle;

  // What nothing reads, for the linters.
  wire unused =
      &{1'b0, pole_i[0], scale_i[3:0], multiplier_product[13:0], multiplier_product[55:48]};
endmodule
