// sinusoidal_axi, its host, and the ADCs that it asks: what the benches of the sinusoidal drive share.
//
// At `sample` the currents of phases U and V and the dc voltage are held; the codes come kConversion clocks later.
//
//     code of a current   round(i / (current_a / 2^11)), clipped to s0.11     of the voltage   round(v / (voltage_v / 2^12)), clipped to u0.12
//
// Doc: docs/integration.md   Test: tests/rtl/turning_sinusoidal.sh

`timescale 1ns / 1ps

module hosted_sinusoidal #(
    parameter real current_a = 20.0,  // [adc] of the drive file: full scale
    parameter real voltage_v = 36.0
) (
    input  logic       clk,
    input  logic       rst,
    input  real        current_u_a,
    input  real        current_v_a,
    input  real        bus_v,
    input  logic       fault,
    output logic [2:0] high,  // gates U, V, W
    output logic [2:0] low,
    output logic       locked,
    output logic       latched
);
  localparam int kConversion = 40;  // clocks

  wire awvalid, awready, wvalid, wready, bvalid, bready, arvalid, arready, rvalid, rready, interrupt, sample;
  wire [11:0] awaddr, araddr;
  wire [31:0] wdata, rdata;
  wire [3:0] wstrb;
  wire [1:0] bresp, rresp;
  logic valid = 1'b0;
  logic [11:0] code_u = 12'd0, code_v = 12'd0, code_dc = 12'd0;

  sinusoidal_axi dut (
      .clk(clk), .rst(rst), .fault_i(fault), .clock_khz_i(20'd24_000),
      .codes_valid_i(valid), .codes_u_i(code_u), .codes_v_i(code_v), .codes_dc_i(code_dc),
      .axi_awvalid_i(awvalid), .axi_awaddr_i(awaddr), .axi_wvalid_i(wvalid), .axi_wdata_i(wdata), .axi_wstrb_i(wstrb),
      .axi_bready_i(bready), .axi_arvalid_i(arvalid), .axi_araddr_i(araddr), .axi_rready_i(rready),
      .gates_uh_o(high[0]), .gates_ul_o(low[0]), .gates_vh_o(high[1]), .gates_vl_o(low[1]), .gates_wh_o(high[2]), .gates_wl_o(low[2]),
      .sample_o(sample), .interrupt_o(interrupt), .locked_o(locked), .fault_o(latched),
      .axi_awready_o(awready), .axi_wready_o(wready), .axi_bvalid_o(bvalid), .axi_bresp_o(bresp),
      .axi_arready_o(arready), .axi_rvalid_o(rvalid), .axi_rdata_o(rdata), .axi_rresp_o(rresp)
  );
  axi_host host (
      .clk(clk), .awvalid(awvalid), .awaddr(awaddr), .awready(awready), .wvalid(wvalid), .wdata(wdata), .wstrb(wstrb),
      .wready(wready), .bvalid(bvalid), .bresp(bresp), .bready(bready), .arvalid(arvalid), .araddr(araddr),
      .arready(arready), .rvalid(rvalid), .rdata(rdata), .rresp(rresp), .rready(rready)
  );

  function automatic int clipped(input real value, input int low_end, input int high_end);
    real rounded;
    rounded = value < 0.0 ? -$floor(0.5 - value) : $floor(value + 0.5);
    return rounded < low_end ? low_end : rounded > high_end ? high_end : $rtoi(rounded);
  endfunction

  int left = 0;
  logic lost = 1'b0;  // what a bench sets: the ADCs do not answer
  always @(posedge clk) begin
    valid <= left == 1 && !lost;
    if (left > 0) left <= left - 1;
    if (sample) begin
      left <= kConversion;
      code_u <= 12'(clipped(current_u_a / current_a * 2048.0, -2048, 2047));
      code_v <= 12'(clipped(current_v_a / current_a * 2048.0, -2048, 2047));
      code_dc <= 12'(clipped(bus_v / voltage_v * 4096.0, 0, 4095));
    end
  end
endmodule
