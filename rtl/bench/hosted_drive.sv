// six_step_axi with its host: what the benches have in common.  Its pins and gates are ports, the host is called by its name:
// drive.host.write(12'h00c, 32'd1).
//
// Doc: docs/integration.md   Test: tests/rtl/bench.sh

`timescale 1ns / 1ps

module hosted_drive #(
    // With it the drive first looks whether its rotor spins.
    parameter logic WITH_HALL_DECODER = 1'b0
) (
    input  logic       clk,
    input  logic       rst,
    input  logic [2:0] comparator,  // U, V, W
    input  logic       limit,
    input  logic       fault,
    output logic [2:0] high,  // gates U, V, W
    output logic [2:0] low,
    output logic       locked,
    output logic       latched
);
  wire awvalid, awready, wvalid, wready, bvalid, bready, arvalid, arready, rvalid, rready, interrupt;
  wire [11:0] awaddr, araddr;
  wire [31:0] wdata, rdata;
  wire [3:0] wstrb;
  wire [1:0] bresp, rresp;

  six_step_axi #(.WITH_HALL_DECODER(WITH_HALL_DECODER)) dut (
      .clk(clk), .rst(rst), .clock_khz_i(20'd24_000),
      .pins_comparator_u_i(comparator[0]), .pins_comparator_v_i(comparator[1]), .pins_comparator_w_i(comparator[2]),
      .pins_limit_i(limit), .pins_fault_i(fault),
      .pins_hall_u_i(1'b0), .pins_hall_v_i(1'b0), .pins_hall_w_i(1'b0),
      .axi_awvalid_i(awvalid), .axi_awaddr_i(awaddr), .axi_wvalid_i(wvalid), .axi_wdata_i(wdata), .axi_wstrb_i(wstrb),
      .axi_bready_i(bready), .axi_arvalid_i(arvalid), .axi_araddr_i(araddr), .axi_rready_i(rready),
      .gates_uh_o(high[0]), .gates_ul_o(low[0]), .gates_vh_o(high[1]), .gates_vl_o(low[1]), .gates_wh_o(high[2]), .gates_wl_o(low[2]),
      .interrupt_o(interrupt), .locked_o(locked), .fault_o(latched),
      .axi_awready_o(awready), .axi_wready_o(wready), .axi_bvalid_o(bvalid), .axi_bresp_o(bresp),
      .axi_arready_o(arready), .axi_rvalid_o(rvalid), .axi_rdata_o(rdata), .axi_rresp_o(rresp)
  );
  axi_host host (
      .clk(clk), .awvalid(awvalid), .awaddr(awaddr), .awready(awready), .wvalid(wvalid), .wdata(wdata), .wstrb(wstrb),
      .wready(wready), .bvalid(bvalid), .bresp(bresp), .bready(bready), .arvalid(arvalid), .araddr(araddr),
      .arready(arready), .rvalid(rvalid), .rdata(rdata), .rresp(rresp), .rready(rready)
  );
endmodule
