// sigma_delta: steplock::SigmaDelta<6>, printed by hlsgen from hls/sinusoidal/sigma_delta.hpp:31.
// Do not edit: change the C++ and print again.

module sigma_delta (
    input  logic        clk,
    input  logic        rst,  // synchronous, active high
    input  logic        sample_i,  // strobe
    input  logic        data_u_i,
    input  logic        data_v_i,
    input  logic        data_dc_i,
    input  logic [5:0]  words_half_i,  // clocks of half an mclk period; 0: off
    input  logic [15:0] words_delay_i,  // bits from the strobe to the window
    output logic        mclk_o,  // pin
    output logic        codes_valid_o,  // one clock: the codes are of a new sample
    output logic [11:0] codes_u_o,  // s0.11, current of phase u
    output logic [11:0] codes_v_o,  // s0.11, current of phase v
    output logic [11:0] codes_dc_o,  // u0.12, dc voltage
    output logic        missed_o  // one clock: a window was cut or not begun when the next one was due
);
  (* ASYNC_REG = "TRUE", syn_preserve = 1,
     altera_attribute = "-name SYNCHRONIZER_IDENTIFICATION FORCED" *)
  logic
      first_u,
      first_v,
      first_dc,
      second_u,
      second_v,
      second_dc;
  logic mclk;
  logic [5:0] clocks;  // left of this half period, without this one
  logic [1:0] rises;  // mclk rose in the last clocks
  logic waits;  // for the window
  logic [15:0] left;  // bits to it
  logic missed;

  wire both_57 = waits && left == 16'd0;  // line 57

  wire u_busy;
  wire u_done;
  wire [17:0] u_value;
  sinc3 u (
      .clk(clk),
      .rst(rst),
      .start_i(both_57),
      .valid_i(rises[1]),
      .bit_i(second_u),
      .busy_o(u_busy),
      .done_o(u_done),
      .value_o(u_value)
  );

  wire [18:0] sum_88 = {u_value[17], u_value} + 19'd32;  // line 88

  wire unused_v_busy;
  wire unused_v_done;
  wire [17:0] v_value;
  sinc3 v (
      .clk(clk),
      .rst(rst),
      .start_i(both_57),
      .valid_i(rises[1]),
      .bit_i(second_v),
      .busy_o(unused_v_busy),
      .done_o(unused_v_done),
      .value_o(v_value)
  );

  wire [18:0] sum_88_2 = {v_value[17], v_value} + 19'd32;  // line 88

  wire unused_dc_busy;
  wire unused_dc_done;
  wire [17:0] dc_value;
  sinc3 dc (
      .clk(clk),
      .rst(rst),
      .start_i(both_57),
      .valid_i(rises[1]),
      .bit_i(second_dc),
      .busy_o(unused_dc_busy),
      .done_o(unused_dc_done),
      .value_o(dc_value)
  );

  wire [18:0] sum_91 = {dc_value[17], dc_value} + 19'd16;  // line 91
  wire both_78 = words_half_i != 6'd0 && clocks == 6'd0;  // line 78
  wire [5:0] choice_81 = (clocks == 6'd0) ? words_half_i : clocks;  // line 81

  always_ff @(posedge clk) begin
    first_u <= data_u_i;
    first_v <= data_v_i;
    first_dc <= data_dc_i;
    second_u <= first_u;
    second_v <= first_v;
    second_dc <= first_dc;
    mclk <= !(both_78 ^ !mclk);  // line 80
    clocks <= choice_81 - 6'd1;  // line 81
    rises <= {rises[0], 1'b0} | {1'b0, both_78 && !mclk};  // line 79
    if (both_57) begin
      waits <= sample_i;
      if (u_busy || !sample_i) begin
        missed <= u_busy;
      end else begin
        missed <= left != 16'd0;
      end
    end else begin
      waits <= waits || sample_i;
      if (sample_i) begin
        missed <= waits && left != 16'd0;
      end else begin
        missed <= 1'b0;
      end
    end
    if (sample_i) begin
      left <= words_delay_i;
    end else if (!both_57 && waits && rises[1]) begin
      left <= left - 16'd1;
    end
    if (rst) begin
      first_u <= 1'b0;
      first_v <= 1'b0;
      first_dc <= 1'b0;
      second_u <= 1'b0;
      second_v <= 1'b0;
      second_dc <= 1'b0;
      mclk <= 1'b0;
      clocks <= 6'd0;
      rises <= 2'd0;
      waits <= 1'b0;
      left <= 16'd0;
      missed <= 1'b0;
    end
  end

  assign mclk_o = mclk;
  assign codes_valid_o = u_done;
  assign codes_u_o =
      (u_value[17] && u_value[16:5] != 12'd4095) ?
      ((sum_88[18:17] == 2'd3) ? sum_88[17:6] : -12'sd2048) :
      (sum_88[18:17] == 2'd0) ? sum_88[17:6] :
      12'sd2047;
  assign codes_v_o =
      (v_value[17] && v_value[16:5] != 12'd4095) ?
      ((sum_88_2[18:17] == 2'd3) ? sum_88_2[17:6] : -12'sd2048) :
      (sum_88_2[18:17] == 2'd0) ? sum_88_2[17:6] :
      12'sd2047;
  assign codes_dc_o =
      (dc_value[17] && dc_value[16:4] != 13'd8191) ? 12'd0 :
      (sum_91[18:17] == 2'd0) ? sum_91[16:5] :
      12'd4095;
  assign missed_o = missed;

  // What nothing reads, for the linters.
  wire unused = &{1'b0, sum_88[5:0], sum_88_2[5:0], sum_91[4:0]};
endmodule
