// current_sense: steplock::CurrentSense, printed by hlsgen from hls/sinusoidal/current_sense.hpp:20.
// Do not edit: change the C++ and print again.

module current_sense (
    input  logic        clk,
    input  logic        rst,  // synchronous, active high
    input  logic        codes_valid_i,  // one clock: the codes are of a new sample
    input  logic [11:0] codes_u_i,  // s0.11, current of phase u
    input  logic [11:0] codes_v_i,  // s0.11, current of phase v
    input  logic [11:0] codes_dc_i,  // u0.12, dc voltage
    input  logic        calibrate_i,  // gates are off: samples are offsets
    input  logic [14:0] over_current_i,  // u0.15
    output logic        taken_o,  // one clock: a sample has been taken
    output logic        measured_o,  // the offsets of this calibration stand
    output logic        over_o,  // a current is beyond the limit
    output logic [15:0] i_u_o,  // s0.15
    output logic [15:0] i_v_o,  // s0.15
    output logic [11:0] v_dc_o  // u0.12
);
  logic [15:0] offset_u;  // s0.15
  logic [15:0] offset_v;  // s0.15
  logic [15:0] i_u;  // s0.15
  logic [15:0] i_v;  // s0.15
  logic [11:0] v_dc;  // u0.12
  logic [4:0] samples;  // of this calibration, up to 16
  logic taken;

  wire [16:0] i_w = {i_u[15], i_u} + {i_v[15], i_v};  // line 45
  wire [15:0] difference_46 = -{1'b0, over_current_i};  // line 46
  wire either =
      $signed(i_v) < $signed(difference_46) || $signed({2'd0, over_current_i}) < $signed(i_w) ||
      $signed(i_w) < $signed({difference_46[15], difference_46});

  always_ff @(posedge clk) begin
    if (codes_valid_i) begin
      if (calibrate_i) begin
        if (!samples[4]) begin
          logic [15:0] choice_63;
          logic [15:0] choice_64;
          choice_63 = (samples == 5'd0) ? 16'd0 : offset_u;  // line 63
          choice_64 = (samples == 5'd0) ? 16'd0 : offset_v;  // line 64
          offset_u <= choice_63 + {{4{codes_u_i[11]}}, codes_u_i};
          offset_v <= choice_64 + {{4{codes_v_i[11]}}, codes_v_i};
        end
        i_u <= 16'd0;
        i_v <= 16'd0;
      end else begin
        logic [15:0] joined_72;
        logic [16:0] difference_72;
        logic [15:0] joined_72_2;
        logic [16:0] difference_72_2;
        joined_72 = {codes_u_i, 4'd0};  // line 72
        difference_72 = {joined_72[15], joined_72} - {offset_u[15], offset_u};  // line 72
        joined_72_2 = {codes_v_i, 4'd0};  // line 72
        difference_72_2 = {joined_72_2[15], joined_72_2} - {offset_v[15], offset_v};  // line 72
        if (difference_72[16]) begin
          if (difference_72[16:15] == 2'd3) begin
            i_u <= difference_72[15:0];
          end else begin
            i_u <= 16'd32768;
          end
        end else if (difference_72[16:15] == 2'd0) begin
          i_u <= difference_72[15:0];
        end else begin
          i_u <= 16'd32767;
        end
        if (difference_72_2[16]) begin
          if (difference_72_2[16:15] == 2'd3) begin
            i_v <= difference_72_2[15:0];
          end else begin
            i_v <= 16'd32768;
          end
        end else if (difference_72_2[16:15] == 2'd0) begin
          i_v <= difference_72_2[15:0];
        end else begin
          i_v <= 16'd32767;
        end
      end
      v_dc <= codes_dc_i;
    end
    if (calibrate_i) begin
      if (!(!codes_valid_i || samples[4])) begin
        samples <= samples + 5'd1;
      end
    end else begin
      samples <= 5'd0;
    end
    taken <= codes_valid_i;
    if (rst) begin
      offset_u <= 16'sd0;
      offset_v <= 16'sd0;
      i_u <= 16'sd0;
      i_v <= 16'sd0;
      v_dc <= 12'd0;
      samples <= 5'd0;
      taken <= 1'b0;
    end
  end

  assign taken_o = taken;
  assign measured_o = samples[4];
  assign over_o =
      $signed({1'b0, over_current_i}) < $signed(i_u) ||
      $signed(i_u) < $signed(difference_46) || $signed({1'b0, over_current_i}) < $signed(i_v) ||
      either;
  assign i_u_o = i_u;
  assign i_v_o = i_v;
  assign v_dc_o = v_dc;
endmodule
