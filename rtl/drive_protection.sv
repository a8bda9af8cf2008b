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
    end else begin
      if (sampled_i) begin
        if (over_current_i) begin
          fatal <= SinusoidalReason_kOverCurrent;
        end else begin
          fatal <= SinusoidalReason_kNone;
        end
        if (regulating_i && saturated_i) begin
          logic [20:0] sum_60;
          sum_60 = {1'b0, saturated} + 21'd1;  // line 60
          if (sum_60[20] && sum_60[19:0] != 20'd1048575) begin
            saturated <= 20'd1048575;
          end else begin
            saturated <= sum_60[19:0];
          end
        end else begin
          saturated <= 20'd0;
        end
        if (locked_i) begin
          if (slow_i) begin
            logic [20:0] sum_76;
            sum_76 = {1'b0, slow} + 21'd1;  // line 76
            if (sum_76[20] && sum_76[19:0] != 20'd1048575) begin
              slow <= 20'd1048575;
            end else begin
              slow <= sum_76[19:0];
            end
          end else if (slow != 20'd0) begin
            slow <= slow - 20'd1;
          end
          if (!fast_i || plausible_i) begin
            emf <= 20'd0;
          end else begin
            logic [20:0] sum_61;
            sum_61 = {1'b0, emf} + 21'd1;  // line 61
            if (sum_61[20] && sum_61[19:0] != 20'd1048575) begin
              emf <= 20'd1048575;
            end else begin
              emf <= sum_61[19:0];
            end
          end
        end else begin
          slow <= 20'd0;
          emf <= 20'd0;
        end
        lost <= 4'd0;
      end else if (period_i && awaited) begin
        logic [4:0] sum_65;
        sum_65 = {1'b0, lost} + 5'd1;  // line 65
        if (words_lost_samples_i == 4'd0 || sum_65 < {1'b0, words_lost_samples_i}) begin
          if (!(sum_65[4] && sum_65[3:0] != 4'd15)) begin
            lost <= sum_65[3:0];
          end
        end else begin
          fatal <= SinusoidalReason_kLostSample;
        end
      end
      if (words_saturated_i != 20'd0 && words_saturated_i < saturated) begin
        failed <= SinusoidalReason_kSaturated;
      end else if (words_emf_i != 20'd0 && words_emf_i < emf) begin
        failed <= SinusoidalReason_kEmf;
      end else if (words_slow_i != 20'd0 && words_slow_i < slow) begin
        failed <= SinusoidalReason_kTooSlow;
      end else begin
        failed <= SinusoidalReason_kNone;
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
