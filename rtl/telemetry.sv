// telemetry: steplock::Telemetry, printed by hlsgen from hls/six_step/telemetry.hpp:16.
// Do not edit: change the C++ and print again.

module telemetry #(
    parameter logic COUNTS = 1'b1
) (
    input  logic        clk,
    input  logic        rst,  // synchronous, active high
    input  logic        clear_i,  // wins over every event
    input  logic        crossing_i,  // a zero crossing was found
    input  logic        missed_i,  // a step ended without one
    input  logic        freewheel_long_i,  // a step freewheeled for too long
    input  logic        limit_hit_i,  // the current limit cut a pulse
    input  logic        retry_i,  // a try failed
    output logic [15:0] crossings_o,  // events, stops at 65535
    output logic [15:0] missed_o,  // events, stops at 65535
    output logic [15:0] freewheel_long_o,  // events, stops at 65535
    output logic [15:0] limit_hits_o,  // events, stops at 65535
    output logic [15:0] retries_o  // events, stops at 65535
);
  logic [15:0] counts_crossings;  // events, stops at 65535
  logic [15:0] counts_missed;  // events, stops at 65535
  logic [15:0] counts_freewheel_long;  // events, stops at 65535
  logic [15:0] counts_limit_hits;  // events, stops at 65535
  logic [15:0] counts_retries;  // events, stops at 65535

  always_ff @(posedge clk) begin
    if (clear_i || !COUNTS) begin
      counts_crossings <= 16'd0;
      counts_missed <= 16'd0;
      counts_freewheel_long <= 16'd0;
      counts_limit_hits <= 16'd0;
      counts_retries <= 16'd0;
    end else begin
      if (crossing_i && counts_crossings != 16'd65535) begin
        counts_crossings <= counts_crossings + 16'd1;
      end
      if (missed_i && counts_missed != 16'd65535) begin
        counts_missed <= counts_missed + 16'd1;
      end
      if (freewheel_long_i && counts_freewheel_long != 16'd65535) begin
        counts_freewheel_long <= counts_freewheel_long + 16'd1;
      end
      if (limit_hit_i && counts_limit_hits != 16'd65535) begin
        counts_limit_hits <= counts_limit_hits + 16'd1;
      end
      if (retry_i && counts_retries != 16'd65535) begin
        counts_retries <= counts_retries + 16'd1;
      end
    end
    if (rst) begin
      counts_crossings <= 16'd0;
      counts_missed <= 16'd0;
      counts_freewheel_long <= 16'd0;
      counts_limit_hits <= 16'd0;
      counts_retries <= 16'd0;
    end
  end

  assign crossings_o = counts_crossings;
  assign missed_o = counts_missed;
  assign freewheel_long_o = counts_freewheel_long;
  assign limit_hits_o = counts_limit_hits;
  assign retries_o = counts_retries;
endmodule
