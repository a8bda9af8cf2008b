// pwm_generator: steplock::PwmGenerator, printed by hlsgen from hls/bridge/pwm_generator.hpp:28.
// Do not edit: change the C++ and print again.

module pwm_generator (
    input  logic        clk,
    input  logic        rst,  // synchronous, active high
    input  logic [13:0] on_clocks_i,  // clocks of on-time; the period or more is 100 %
    input  logic [13:0] period_i,  // clocks
    input  logic [13:0] minimum_i,  // clocks
    input  logic        centred_i,  // pulse in the middle of the period
    input  logic [7:0]  tick_periods_i,  // periods per tick; 0 counts as 1
    output logic        on_o,  // the pulse
    output logic        start_o,  // first clock of a period
    output logic        tick_o  // first clock of every `tick_periods`-th period
);
  logic [13:0] left;  // clocks of the period, with this one
  logic [12:0] lead;  // clocks to the pulse
  logic [13:0] pulse;  // clocks of the pulse
  logic [7:0] periods;  // periods to the next tick
  logic first;  // this is the first clock of the period
  logic waiting;  // the pulse is still to come
  logic always_;  // 100 %
  logic on;  // the pulse, one clock later
  logic start;  // as first_, in step with on_
  logic tick;  // as first_, in every `tick_periods`-th period

  wire [1:0] inverse_65 = ~{1'b0, left[13:1] == 13'd0};  // line 65
  wire [13:0] choice = (left[13:1] == 13'd0) ? period_i : 14'd16383;
  wire both_51 = waiting && lead == 13'd0;  // line 51
  wire both_53 = on && !first;  // line 53

  always_ff @(posedge clk) begin
    left <= (left & {{12{inverse_65[1]}}, inverse_65}) + choice;  // line 65
    if (left[13:1] == 13'd0) begin
      logic [14:0] rest;
      logic at_most_70;
      rest = {1'b0, period_i} - {1'b0, on_clocks_i};  // line 67
      at_most_70 = minimum_i <= on_clocks_i;  // line 70
      if (centred_i) begin
        lead <= rest[13:1];
      end else begin
        lead <= 13'd0;
      end
      pulse <= on_clocks_i;
      waiting <= at_most_70;
      always_ <= at_most_70 && $signed(rest) < $signed({1'b0, minimum_i});
    end else begin
      if (both_51) begin
        pulse <= pulse - 14'd1;
      end else begin
        if (waiting) begin
          lead <= lead - 13'd1;
        end
        if (both_53) begin
          pulse <= pulse - 14'd1;
        end
      end
      waiting <= both_51 ^ waiting;
    end
    if (first) begin
      if (left != 14'd0) begin
        if (periods[7:1] == 7'd0) begin
          periods <= tick_periods_i;
        end else begin
          periods <= periods - 8'd1;
        end
      end
      tick <= left != 14'd0 && periods[7:1] == 7'd0;
    end else begin
      tick <= 1'b0;
    end
    first <= left[13:1] == 13'd0;  // line 47
    if (left == 14'd0 || always_) begin
      on <= left != 14'd0;
    end else begin
      on <= (both_51 || both_53) && pulse != 14'd0;
    end
    start <= first && left != 14'd0;  // line 55
    if (rst) begin
      left <= 14'd0;
      lead <= 13'd0;
      pulse <= 14'd0;
      periods <= 8'd0;
      first <= 1'b0;
      waiting <= 1'b0;
      always_ <= 1'b0;
      on <= 1'b0;
      start <= 1'b0;
      tick <= 1'b0;
    end
  end

  assign on_o = on;
  assign start_o = start;
  assign tick_o = tick;
endmodule
