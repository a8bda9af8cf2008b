// loop_filter: steplock::LoopFilter, printed by hlsgen from hls/six_step/loop_filter.hpp:38.
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

  logic [10:0] at_bits;  // public, for a set to be a port
  logic starts;  // this is the first clock of a product, or there is none
  logic [33:0] base;  // what the product is added to, or comes instead
  logic [2:0] loop;  // a clock ago
  logic [33:0] work;  // e', p, v, and the next y
  logic [33:0] x;  // s-2.36, the integrator
  logic [33:0] addend;  // the product, or the result
  logic adds;  // the integrator takes it
  logic clears;  // it is cleared
  logic follows;  // to take the result
  logic [29:0] y;  // u0.36, behind the pole
  logic [28:0] not_limit;  // complement of what this stage compares with
  logic fast;
  logic slow;
  logic below;  // the last clock's comparison: less
  logic shown;  // y is new, and whether it is fast still in below_
  logic at_top;  // the output stands at a limit
  logic at_bottom;

  wire [14:0] choice_74 =  // line 74
      at_bits[5] ? pole_i[15:1] :
      at_bits[6] ? 15'd16384 - pole_i[15:1] :
      15'd0;
  wire [15:0] wide_74 = {1'b0, choice_74};  // line 74
  wire [15:0] sum_127 = error_i + 16'd16384;  // line 127
  wire [14:0] choice_136 = (loop == Loop_kHall && !sum_127[15]) ? 15'd4096 : 15'd16384;  // line 136
  wire [15:0] wide_136 = {1'b0, choice_136};  // line 136
  wire [15:0] choice_74_2 =  // line 74
      at_bits[3] ? ((loop == Loop_kTrack) ? ki_i : wide_136) :
      at_bits[4] ? kp_i :
      wide_74;
  wire [21:0] choice_74_3 =  // line 74
      (loop == Loop_kRamp) ? {2'd0, ramp_i} :
      (loop != Loop_kTrack || bandwidth_i) ? y[29:8] :
      scale_i[25:4];
  wire [9:0] choice_120 = (loop == Loop_kTrack) ? delay_i : 10'd0;  // line 120
  wire choice_193 = shown ? !below : fast;  // line 193

  wire [55:0] multiplier_product;
  wire multiplier_done;
  wire unused_multiplier_busy;
  wire unused_multiplier_ends;
  serial_multiplier_34_22 multiplier (
      .clk(clk),
      .rst(rst),
      .start_i(starts),
      .a_i(((at_bits[6:1] & 6'h21) == 6'd0) ? work : {4'd0, y}),
      .b_i(at_bits[1] ? {12'd0, choice_120} :
        at_bits[2] ? choice_74_3 :
        {6'd0, choice_74_2}),
      .shift_i(4'd0),
      .product_o(multiplier_product),
      .done_o(multiplier_done),
      .busy_o(unused_multiplier_busy),
      .ends_o(unused_multiplier_ends)
  );

  wire both_158 = at_bits[3] && loop == Loop_kTrack;  // line 158
  wire [33:0] sum = base + multiplier_product[47:14];  // line 144
  wire follows_next = at_bits[10] && loop != Loop_kTrack;  // line 167
  wire [25:0] limit =  // line 196
      ((at_bits[6:3] & 4'h9) == 4'd0) ?
      (at_bits[7] ? maximum_i :
      at_bits[8] ? stall_i :
      hand_over_i) :
      (loop == Loop_kRamp) ? 26'd0 :
      minimum_i;
  wire [26:0] inverse_200 = ~{1'b0, limit};  // line 200
  wire [30:0] sum_77 = {1'b0, work[33:4] ^ 30'h20000000} + {2'd0, not_limit} + 31'd1;  // line 77

  always_ff @(posedge clk) begin
    if (loop == Loop_kStop) begin
      at_bits <= 11'd1;
      starts <= 1'b1;
      y <= 30'd0;
      slow <= 1'b0;
      at_top <= 1'b0;
      at_bottom <= 1'b0;
    end else begin
      logic choice_80;
      logic either;
      choice_80 = (loop == Loop_kRamp || (loop == Loop_kTrack && !bandwidth_i)) ? tick_i : update_i;
      either = at_bits[10:7] != 4'd0 || multiplier_done;
      if (at_bits[0] ? choice_80 : either) begin
        if (!at_bits[3] || loop == Loop_kTrack) begin
          at_bits <= {at_bits[9:0], at_bits[10]};
        end else begin
          at_bits <= 11'd128;
        end
      end
      starts <= at_bits[0] || either;
      if (at_bits[10]) begin
        y <= work[29:0];
        slow <= below;
      end
      if (at_bits[9]) begin
        at_top <= !below;
      end
      if (at_bits[8]) begin
        at_bottom <= below;
      end
    end
    if (at_bits[0]) begin
      logic [8:0] choice_149;
      logic [10:0] choice_149_2;
      logic [12:0] wide_149;
      logic [12:0] choice_149_3;
      logic [15:0] choice_149_4;
      choice_149 = (gentle_i == 2'd2) ? 9'd256 : 9'd64;  // line 149
      choice_149_2 = (gentle_i == 2'd1) ? 11'd1024 : {2'd0, choice_149};  // line 149
      wide_149 = {2'd0, choice_149_2};  // line 149
      choice_149_3 = (gentle_i == 2'd0) ? 13'd4096 : wide_149;  // line 149
      choice_149_4 = (loop == Loop_kRamp) ? {3'd0, choice_149_3} : error_i;  // line 149
      base <= {{12{choice_149_4[15]}}, choice_149_4, 6'd0};
    end else if (!at_bits[1]) begin
      if (at_bits[4:3] == 2'd0) begin
        if (at_bits[6]) begin
          base <= work;
        end else begin
          logic [29:0] choice;
          choice =
              at_bits[7] ? ((loop == Loop_kRamp) ? 30'd0 : {minimum_i, 4'd0}) :
              at_bits[8] ? {maximum_i, 4'd0} :
              30'd0;
          base <= {4'd0, choice};
        end
      end else begin
        base <= x;
      end
    end
    loop <= loop_i;
    if (multiplier_done && !both_158) begin
      work <= sum;
      adds <= follows;
    end else begin
      if ((at_bits[8] && below) || (at_bits[9] && !below)) begin
        work <= sum;
      end
      if (follows || !multiplier_done) begin
        adds <= follows;
      end else begin
        adds <= both_158 && !(work[33] ? at_bottom : at_top);
      end
    end
    if (clears) begin
      x <= 34'd0;
    end else if (adds) begin
      x <= x + addend;
    end
    if (follows_next) begin
      addend <= work;
    end else if (multiplier_done) begin
      addend <= multiplier_product[47:14];
    end
    case (loop)
      Loop_kStop: clears <= 1'b1;
      Loop_kTrack: clears <= 1'b0;
      default: clears <= at_bits[10];
    endcase
    follows <= follows_next;  // line 167
    not_limit <= {{2{inverse_200[26]}}, inverse_200};  // line 200
    fast <= loop != Loop_kStop && choice_193;
    below <= !sum_77[30];  // line 77
    shown <= loop != Loop_kStop && at_bits[10];
    if (rst) begin
      at_bits <= 11'd1;
      starts <= 1'b1;
      base <= 34'sd0;
      loop <= Loop_kStop;
      work <= 34'sd0;
      x <= 34'sd0;
      addend <= 34'sd0;
      adds <= 1'b0;
      clears <= 1'b0;
      follows <= 1'b0;
      y <= 30'd0;
      not_limit <= 29'd0;
      fast <= 1'b0;
      slow <= 1'b0;
      below <= 1'b0;
      shown <= 1'b0;
      at_top <= 1'b0;
      at_bottom <= 1'b0;
    end
  end

  assign frequency_o = y[29:4];
  assign fast_o = choice_193;
  assign slow_o = slow;
  assign busy_o = !at_bits[0];

  // What nothing reads, for the linters.
  wire unused =
      &{1'b0, pole_i[0], scale_i[3:0], sum_127[14:0], multiplier_product[13:0],
      multiplier_product[55:48], sum_77[29:0]};
endmodule
