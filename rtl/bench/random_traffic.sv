// Random traffic for six_step_axi: a host that does what it likes, and comparators, current limit, Hall sensors and fault pin that do so,
// while six_step_axi_properties looks on.
//
//     tools/bench verilator random_traffic [+clocks=200000] [+seed=1]
//
// Doc: docs/integration.md   Test: tests/rtl/properties.sh

`timescale 1ns / 1ps

module random_traffic #(
    // With it the drive first observes whether its rotor turns, and its gates are on for less of the time.
    parameter logic WITH_HALL_DECODER = 1'b0
);
  logic clk = 1'b0;
  always #20 clk = ~clk;

  logic [2:0] comparator = 3'd0, hall = 3'd0;
  logic limit = 1'b0, fault = 1'b0;
  wire rst, random, awvalid, awready, wvalid, wready, bvalid, bready, arvalid, arready, rvalid, rready, interrupt, locked, latched;
  wire [11:0] awaddr, araddr;
  wire [31:0] wdata, rdata;
  wire [3:0] wstrb;
  wire [1:0] bresp, rresp;
  wire uh, ul, vh, vl, wh, wl;
  traffic traffic (
      .clk(clk), .rst(rst), .random(random), .gates({uh, ul, vh, vl, wh, wl}), .latched(latched),
      .awvalid(awvalid), .awaddr(awaddr), .awready(awready), .wvalid(wvalid), .wdata(wdata), .wstrb(wstrb), .wready(wready),
      .bvalid(bvalid), .bresp(bresp), .bready(bready), .arvalid(arvalid), .araddr(araddr), .arready(arready),
      .rvalid(rvalid), .rdata(rdata), .rresp(rresp), .rready(rready)
  );
  six_step_axi #(.WITH_HALL_DECODER(WITH_HALL_DECODER)) dut (
      .clk(clk), .rst(rst),
      .pins_comparator_u_i(comparator[0]), .pins_comparator_v_i(comparator[1]), .pins_comparator_w_i(comparator[2]),
      .pins_limit_i(limit), .pins_fault_i(fault),
      .pins_hall_u_i(hall[0]), .pins_hall_v_i(hall[1]), .pins_hall_w_i(hall[2]),
      .axi_awvalid_i(awvalid), .axi_awaddr_i(awaddr), .axi_wvalid_i(wvalid), .axi_wdata_i(wdata), .axi_wstrb_i(wstrb),
      .axi_bready_i(bready), .axi_arvalid_i(arvalid), .axi_araddr_i(araddr), .axi_rready_i(rready),
      .gates_uh_o(uh), .gates_ul_o(ul), .gates_vh_o(vh), .gates_vl_o(vl), .gates_wh_o(wh), .gates_wl_o(wl),
      .interrupt_o(interrupt), .locked_o(locked), .fault_o(latched),
      .axi_awready_o(awready), .axi_wready_o(wready), .axi_bvalid_o(bvalid), .axi_bresp_o(bresp),
      .axi_arready_o(arready), .axi_rvalid_o(rvalid), .axi_rdata_o(rdata), .axi_rresp_o(rresp)
  );
  six_step_axi_properties properties (
      .clk(clk), .rst(rst), .pins_fault_i(fault),
      .axi_awvalid_i(awvalid), .axi_awready_o(awready), .axi_wvalid_i(wvalid), .axi_wready_o(wready), .axi_bvalid_o(bvalid), .axi_bready_i(bready),
      .axi_arvalid_i(arvalid), .axi_arready_o(arready), .axi_rvalid_o(rvalid), .axi_rready_i(rready),
      .axi_awaddr_i(awaddr), .axi_wdata_i(wdata), .axi_rdata_o(rdata), .axi_wstrb_i(wstrb), .axi_bresp_o(bresp), .axi_rresp_o(rresp),
      .gates_uh_o(uh), .gates_ul_o(ul), .gates_vh_o(vh), .gates_vl_o(vl), .gates_wh_o(wh), .gates_wl_o(wl),
      .locked_o(locked), .fault_o(latched)
  );

  // Between the edges, at which the host moves, so that every simulator sees the same.
  dice #(.SALT(1)) dice ();
  always @(posedge clk) begin
    #5;
    if (dice.draw(200) == 0) comparator = 3'(dice.draw(8));
    if (dice.draw(2000) == 0) hall = 3'(dice.draw(8));
    limit = dice.now_and_then(limit, 400, 20);
    fault = dice.now_and_then(fault, 8000, 10);
    if (!random || rst) {limit, fault} = 2'd0;
  end
  initial traffic.play;
endmodule
