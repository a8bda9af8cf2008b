// start_counters: steplock::StartCounters, printed by hlsgen from hls/six_step/start_counters.hpp:24.
// Do not edit: change the C++ and print again.

module start_counters (
    input  logic        clk,
    input  logic        rst,  // synchronous, active high
    input  logic        tick_i,  // the slow time base
    input  logic [10:0] state_bits_i,  // public, for a set to be a port
    input  logic        entered_i,  // this is the first clock of the state
    input  logic        failed_i,  // strobe: a try failed
    input  logic        braking_i,  // strobe: a braking interval begins
    input  logic        update_i,  // strobe: the phase detector has a new error
    input  logic        good_i,  // with `update`: it is a small one
    input  logic        turns_reverse_i,  // while observing: the code last moved downwards
    input  logic [11:0] words_settle_i,  // first pattern, so that a rotor opposite to the reset place moves
    input  logic [11:0] words_reset_i,  // reset pattern: t_r of Eq. (22)
    input  logic [15:0] words_reset_duty_i,  // twice that from the third try on, and so start_duty
    input  logic [15:0] words_start_duty_i,  // during acceleration and pull-in
    input  logic [19:0] words_ramp_i,  // u0.32 per tick: the VCO's acceleration; a quarter after each failed try
    input  logic [25:0] words_hand_over_i,  // f_a: the end of the ramp
    input  logic [15:0] words_window_i,  // u0.16: a crossing closer than this to its place is a good one
    input  logic [5:0]  words_good_crossings_i,  // in a row, for lock (and for catching)
    input  logic [11:0] words_pull_in_i,  // time limit from hand-over to lock
    input  logic [11:0] words_observe_i,  // time to look for a rotor that already spins; 0 skips it
    input  logic [11:0] words_slow_down_i,  // time limit for slowing to hand-over speed before a reversal
    input  logic [11:0] words_brake_i,  // one braking interval, between two looks
    input  logic [15:0] words_brake_duty_i,
    input  logic [11:0] words_rest_i,  // gates off between a failure and the next try
    input  logic [3:0]  words_retries_i,  // failed tries before the fault latches
    output logic        over_o,  // with `tick`: the state's time
    output logic        enough_o,  // good crossings in a row, the last one in the clock before
    output logic        tried_o,  // no more tries are left
    output logic        braked_o,  // no more braking intervals are left
    output logic        turns_reverse_o,  // direction at the last update
    output logic [1:0]  gentle_o,  // failed tries, as far as they make the next one gentler
    output logic        strong_o  // two or more of them
);
  logic [14:0] ticks;  // left in this state
  logic late;  // there was a tick in the state's first clock
  logic last;  // no ticks are left
  logic [3:0] retries;  // failed tries
  logic tried;  // no more are left
  logic [7:0] brakes;  // braking intervals of this stop
  logic braked;  // no more are left
  logic [5:0] good;  // good crossings in a row
  logic nearly;  // one more is enough
  logic enough;  // that one came in the last clock
  logic turns_reverse;  // direction at the last update

  wire over = tick_i && last && !entered_i;  // line 49
  wire [1:0] gentle = (retries[3:2] == 2'd0) ? retries[1:0] : 2'd3;  // line 125
  wire [6:0] sum_116 = {1'b0, good} + 7'd1;  // line 116

  always_ff @(posedge clk) begin
    if (entered_i) begin
      logic [14:0] wide_75;
      logic [14:0] once;
      logic [14:0] then;
      logic [14:0] once_2;
      logic [14:0] then_2;
      logic [14:0] either_76;
      logic [14:0] either_78;
      logic [14:0] either_79;
      logic [12:0] once_3;
      logic [14:0] then_3;
      wide_75 =  // line 75
          {3'd0,
          (state_bits_i[1] ? words_observe_i : 12'd0) | (state_bits_i[2] ? words_brake_i : 12'd0)};
      once = {3'd0, words_settle_i} << gentle[0];  // line 69
      then = gentle[1] ? {once[12:0], 2'd0} : once;  // line 70
      once_2 = {3'd0, words_reset_i} << gentle[0];  // line 69
      then_2 = gentle[1] ? {once_2[12:0], 2'd0} : once_2;  // line 70
      either_76 = wide_75 | (state_bits_i[3] ? then : 15'd0) | (state_bits_i[4] ? then_2 : 15'd0);
      either_78 =  // line 78
          either_76 | {3'd0, state_bits_i[6] ? words_pull_in_i : 12'd0} |
          {3'd0, state_bits_i[8] ? words_slow_down_i : 12'd0};
      either_79 =  // line 79
          either_78 | {3'd0, state_bits_i[9] ? words_rest_i : 12'd0} |
          {4'd0, state_bits_i[7], 10'd0};
      once_3 = gentle[0] ? 13'd8190 : 13'd4095;  // line 69
      then_3 = gentle[1] ? {once_3, 2'd0} : {2'd0, once_3};  // line 70
      ticks <= either_79 | (state_bits_i[5] ? then_3 : 15'd0);
      good <= 6'd0;
      enough <= 1'b0;
    end else begin
      if ((tick_i || late) && ticks != 15'd0) begin
        ticks <= ticks - 15'd1;
      end
      if (update_i) begin
        if (good_i) begin
          logic either_113;
          either_113 = !state_bits_i[1] || !(turns_reverse_i ^ turns_reverse);  // line 113
          if (either_113) begin
            good <= sum_116[5:0];
          end else begin
            good <= 6'd0;
          end
          enough <= either_113 && nearly;
        end else begin
          good <= 6'd0;
          enough <= 1'b0;
        end
        turns_reverse <= turns_reverse_i;
      end else begin
        enough <= 1'b0;
      end
    end
    late <= tick_i && entered_i;  // line 87
    last <= !entered_i && ticks == 15'd0;  // line 88
    if (state_bits_i[0]) begin
      retries <= 4'd0;
      brakes <= 8'd0;
    end else if (over && state_bits_i[7]) begin
      retries <= 4'd0;
      brakes <= 8'd0;
    end else begin
      if (failed_i) begin
        retries <= retries + 4'd1;
      end
      if (state_bits_i[7]) begin
        brakes <= 8'd0;
      end else if (braking_i) begin
        brakes <= brakes + 8'd1;
      end
    end
    tried <= (words_retries_i <= retries);  // line 97
    braked <= brakes == 8'd255;  // line 103
    nearly <= ({1'b0, words_good_crossings_i} <= sum_116);  // line 116
    if (rst) begin
      ticks <= 15'd0;
      late <= 1'b0;
      last <= 1'b0;
      retries <= 4'd0;
      tried <= 1'b0;
      brakes <= 8'd0;
      braked <= 1'b0;
      good <= 6'd0;
      nearly <= 1'b0;
      enough <= 1'b0;
      turns_reverse <= 1'b0;
    end
  end

  assign over_o = over;
  assign enough_o = enough;
  assign tried_o = tried;
  assign braked_o = braked;
  assign turns_reverse_o = turns_reverse;
  assign gentle_o = gentle;
  assign strong_o = retries[3:1] != 3'd0;

  // What nothing reads, for the linters.
  wire unused =
      &{1'b0, state_bits_i[10], words_reset_duty_i, words_start_duty_i, words_ramp_i,
      words_hand_over_i, words_window_i, words_brake_duty_i};
endmodule
