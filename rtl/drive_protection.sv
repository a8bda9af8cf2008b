// drive_protection: steplock::DriveProtection, printed by hlsgen from hls/sinusoidal/drive_protection.hpp:22.
// Do not edit: change the C++ and print again.

module drive_protection (
    input  logic        clk,
    input  logic        rst,  // synchronous, active high
    input  logic        restart_i,  // all counts to 0
    input  logic        period_i,  // a PWM period begins: a sample is due
    input  logic        sampled_i,  // one has been worked through
    input  logic        over_current_i,
    input  logic        regulating_i,
    input  logic        saturated_i,  // a regulator is at its limit
    input  logic        locked_i,
    input  logic        fast_i,  // fast enough for the EMF's test
    input  logic        slow_i,
    input  logic        plausible_i,  // the EMF belongs to the speed
    input  logic [14:0] words_over_current_i,  // u0.15, any phase
    input  logic [19:0] words_saturated_i,  // a regulator at its limit for more than this; 0: no test
    input  logic [19:0] words_slow_i,  // slow for more than this longer than not; 0: no test
    input  logic [19:0] words_emf_i,  // an EMF that does not belong to the speed for more; 0: no test
    input  logic [3:0]  words_lost_samples_i,  // in a row; 0: no test
    output logic [3:0]  fatal_o,  // ends the run
    output logic [3:0]  failed_o  // ends the try
);
  localparam logic [3:0] SinusoidalReason_kNone = 4'd0;
  localparam logic [3:0] SinusoidalReason_kOverCurrent = 4'd2;
  localparam logic [3:0] SinusoidalReason_kLostSample = 4'd3;
  localparam logic [3:0] SinusoidalReason_kSaturated = 4'd4;
  localparam logic [3:0] SinusoidalReason_kTooSlow = 4'd5;
  localparam logic [3:0] SinusoidalReason_kEmf = 4'd6;

  logic [3:0] fatal;
  logic [3:0] failed;
  logic [19:0] saturated;  // samples in a row
  logic [19:0] slow;  // samples, balance
  logic [19:0] emf;  // samples in a row
  logic [3:0] lost;  // periods in a row
  logic awaited;  // a sample is due

  always_ff @(posedge clk) begin
    if (restart_i) begin
      fatal <= SinusoidalReason_kNone;
      failed <= SinusoidalReason_kNone;
      saturated <= 20'd0;
      slow <= 20'd0;
      emf <= 20'd0;
      lost <= 4'd0;
    end else if (sampled_i) begin
      logic [20:0] sum_75;
      logic [19:0] choice_57;
      logic [19:0] choice_57_2;
      logic [20:0] sum_56;
      logic [19:0] choice_56;
      logic [19:0] choice_56_2;
      logic both_55;
      logic [20:0] sum_55;
      logic [19:0] choice_55;
      logic both_59;
      sum_75 = {1'b0, slow} + 21'd1;  // line 75
      choice_57 =  // line 57
          slow_i ? ((sum_75[20] && sum_75[19:0] != 20'd1048575) ? 20'd1048575 : sum_75[19:0]) :
          (slow == 20'd0) ? 20'd0 :
          slow - 20'd1;
      choice_57_2 = locked_i ? choice_57 : 20'd0;  // line 57
      sum_56 = {1'b0, emf} + 21'd1;  // line 56
      choice_56 = (sum_56[20] && sum_56[19:0] != 20'd1048575) ? 20'd1048575 : sum_56[19:0];
      choice_56_2 = (!(locked_i && fast_i) || plausible_i) ? 20'd0 : choice_56;  // line 56
      both_55 = regulating_i && saturated_i;  // line 55
      sum_55 = {1'b0, saturated} + 21'd1;  // line 55
      choice_55 = (sum_55[20] && sum_55[19:0] != 20'd1048575) ? 20'd1048575 : sum_55[19:0];
      both_59 = words_saturated_i != 20'd0 && words_saturated_i < (both_55 ? choice_55 : 20'd0);
      if (over_current_i) begin
        fatal <= SinusoidalReason_kOverCurrent;
      end else begin
        fatal <= SinusoidalReason_kNone;
      end
      if (both_59) begin
        failed <= SinusoidalReason_kSaturated;
        emf <= choice_56_2;
      end else if (words_emf_i != 20'd0 && words_emf_i < choice_56_2) begin
        failed <= SinusoidalReason_kEmf;
        emf <= choice_56;
      end else begin
        if (words_slow_i != 20'd0 && words_slow_i < choice_57_2) begin
          failed <= SinusoidalReason_kTooSlow;
        end else begin
          failed <= SinusoidalReason_kNone;
        end
        emf <= choice_56_2;
      end
      if (both_59 || both_55) begin
        saturated <= choice_55;
      end else begin
        saturated <= 20'd0;
      end
      slow <= choice_57_2;
      lost <= 4'd0;
    end else if (period_i && awaited) begin
      logic [4:0] sum_64;
      sum_64 = {1'b0, lost} + 5'd1;  // line 64
      if (words_lost_samples_i == 4'd0 || sum_64 < {1'b0, words_lost_samples_i}) begin
        if (!(sum_64[4] && sum_64[3:0] != 4'd15)) begin
          lost <= sum_64[3:0];
        end
      end else begin
        fatal <= SinusoidalReason_kLostSample;
      end
    end
    awaited <= period_i || (awaited && !sampled_i);
    if (rst) begin
      fatal <= SinusoidalReason_kNone;
      failed <= SinusoidalReason_kNone;
      saturated <= 20'd0;
      slow <= 20'd0;
      emf <= 20'd0;
      lost <= 4'd0;
      awaited <= 1'b0;
    end
  end

  assign fatal_o = fatal;
  assign failed_o = failed;

  // What nothing reads, for the linters.
  wire unused = &{1'b0, words_over_current_i};
endmodule
