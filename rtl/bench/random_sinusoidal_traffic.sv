// Random traffic for sinusoidal_axi: a host that does what it likes, converters whose codes jump or do not come, and a fault pin, while
// sinusoidal_axi_properties looks on.
//
//     tools/bench verilator random_sinusoidal_traffic [+clocks=200000] [+seed=1]
//
// Doc: docs/integration.md   Test: tests/rtl/properties.sh

`timescale 1ns / 1ps

module random_sinusoidal_traffic;
  localparam int kConversion = 40;  // clocks
  localparam int kBus = 2731;       // code of the dc voltage: 24 of 36 V

  logic clk = 1'b0;
  always #20 clk = ~clk;

  logic fault = 1'b0, valid = 1'b0;
  logic [11:0] code_u = 12'd0, code_v = 12'd0, code_dc = 12'(kBus);
  wire sample;
  wire rst, random, awvalid, awready, wvalid, wready, bvalid, bready, arvalid, arready, rvalid, rready, interrupt, locked, latched;
  wire [11:0] awaddr, araddr;
  wire [31:0] wdata, rdata;
  wire [3:0] wstrb;
  wire [1:0] bresp, rresp;
  wire uh, ul, vh, vl, wh, wl;
  // Seldom, since a drive that is stopped calibrates its converters anew before a gate is on, which takes longer than a busy host lets it run.
  traffic #(.WRITES(400)) traffic (
      .clk(clk), .rst(rst), .random(random), .gates({uh, ul, vh, vl, wh, wl}), .latched(latched),
      .awvalid(awvalid), .awaddr(awaddr), .awready(awready), .wvalid(wvalid), .wdata(wdata), .wstrb(wstrb), .wready(wready),
      .bvalid(bvalid), .bresp(bresp), .bready(bready), .arvalid(arvalid), .araddr(araddr), .arready(arready),
      .rvalid(rvalid), .rdata(rdata), .rresp(rresp), .rready(rready)
  );
  sinusoidal_axi dut (
      .clk(clk), .rst(rst), .fault_i(fault),
      .codes_valid_i(valid), .codes_u_i(code_u), .codes_v_i(code_v), .codes_dc_i(code_dc),
      .axi_awvalid_i(awvalid), .axi_awaddr_i(awaddr), .axi_wvalid_i(wvalid), .axi_wdata_i(wdata), .axi_wstrb_i(wstrb),
      .axi_bready_i(bready), .axi_arvalid_i(arvalid), .axi_araddr_i(araddr), .axi_rready_i(rready),
      .gates_uh_o(uh), .gates_ul_o(ul), .gates_vh_o(vh), .gates_vl_o(vl), .gates_wh_o(wh), .gates_wl_o(wl),
      .sample_o(sample), .interrupt_o(interrupt), .locked_o(locked), .fault_o(latched),
      .axi_awready_o(awready), .axi_wready_o(wready), .axi_bvalid_o(bvalid), .axi_bresp_o(bresp),
      .axi_arready_o(arready), .axi_rvalid_o(rvalid), .axi_rdata_o(rdata), .axi_rresp_o(rresp)
  );
  sinusoidal_axi_properties properties (
      .clk(clk), .rst(rst), .fault_i(fault),
      .axi_awvalid_i(awvalid), .axi_awready_o(awready), .axi_wvalid_i(wvalid), .axi_wready_o(wready), .axi_bvalid_o(bvalid), .axi_bready_i(bready),
      .axi_arvalid_i(arvalid), .axi_arready_o(arready), .axi_rvalid_o(rvalid), .axi_rready_i(rready),
      .axi_awaddr_i(awaddr), .axi_wdata_i(wdata), .axi_rdata_o(rdata), .axi_wstrb_i(wstrb), .axi_bresp_o(bresp), .axi_rresp_o(rresp),
      .gates_uh_o(uh), .gates_ul_o(ul), .gates_vh_o(vh), .gates_vl_o(vl), .gates_wh_o(wh), .gates_wl_o(wl),
      .locked_o(locked), .fault_o(latched)
  );

  // Between the edges, at which the host moves, so that every simulator sees the same.  Currents stay within a few codes, or the drive
  // would never get behind its calibration; now and then one is anything, the bus is, or a sample is lost.
  dice #(.SALT(1)) dice ();
  int left = 0;
  function automatic logic wild(input int between);
    int drawn;
    drawn = dice.draw(between);
    return random && drawn == 0;
  endfunction
  function automatic logic [11:0] code(input int middle);
    logic [11:0] any, near;
    any = 12'(dice.bits());
    near = 12'(middle + dice.draw(9) - 4);
    return wild(200) ? any : near;
  endfunction
  always @(posedge clk) begin
    #5;
    valid = !wild(400) && left == 1;
    if (left > 0) left = left - 1;
    if (sample) begin
      left = kConversion;
      code_u = code(0);
      code_v = code(0);
      code_dc = code(kBus);
    end
    fault = dice.now_and_then(fault, 3000, 10);
    if (!random || rst) fault = 1'b0;
  end
  initial traffic.play;
endmodule
