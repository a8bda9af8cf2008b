// A first start of six_step_axi, without a motor: configuration from a list of words, run, gates that drive, the fault pin, gates that
// do not.  For Icarus, from the root of the project:
//
//     iverilog -g2012 -o first_start.vvp -s first_start -c rtl/six_step_axi.f rtl/bench/axi_host.sv rtl/bench/first_start.sv
//     vvp -n first_start.vvp +words=rtl/words/m2310p_servo.mem
//
// It prints PASSED; or FAILED and why, and its exit code is 1.
//
// Doc: docs/integration.md   Test: tests/rtl/bench.sh

`timescale 1ns / 1ps

module first_start #(
    // With the Hall decoder the drive first observes whether its rotor turns: -P first_start.WITH_HALL_DECODER=1
    parameter logic WITH_HALL_DECODER = 1'b0
);
  localparam int kLeastWords = 10, kWait = 3_000_000, kFaultClocks = 3;

  logic clk = 1'b0, rst = 1'b1, fault = 1'b0;
  always #20 clk = ~clk;

  wire awvalid, awready, wvalid, wready, bvalid, bready, arvalid, arready, rvalid, rready;
  wire [11:0] awaddr, araddr;
  wire [31:0] wdata, rdata;
  wire [3:0] wstrb;
  wire [1:0] bresp, rresp;
  wire uh, ul, vh, vl, wh, wl, interrupt, locked, latched;
  wire [5:0] gates = {uh, ul, vh, vl, wh, wl};

  six_step_axi #(.WITH_HALL_DECODER(WITH_HALL_DECODER)) dut (
      .clk(clk), .rst(rst),
      .pins_comparator_u_i(1'b0), .pins_comparator_v_i(1'b0), .pins_comparator_w_i(1'b0),
      .pins_limit_i(1'b0), .pins_fault_i(fault),
      .pins_hall_u_i(1'b0), .pins_hall_v_i(1'b0), .pins_hall_w_i(1'b0),
      .axi_awvalid_i(awvalid), .axi_awaddr_i(awaddr), .axi_wvalid_i(wvalid), .axi_wdata_i(wdata), .axi_wstrb_i(wstrb),
      .axi_bready_i(bready), .axi_arvalid_i(arvalid), .axi_araddr_i(araddr), .axi_rready_i(rready),
      .gates_uh_o(uh), .gates_ul_o(ul), .gates_vh_o(vh), .gates_vl_o(vl), .gates_wh_o(wh), .gates_wl_o(wl),
      .interrupt_o(interrupt), .locked_o(locked), .fault_o(latched),
      .axi_awready_o(awready), .axi_wready_o(wready), .axi_bvalid_o(bvalid), .axi_bresp_o(bresp),
      .axi_arready_o(arready), .axi_rvalid_o(rvalid), .axi_rdata_o(rdata), .axi_rresp_o(rresp)
  );
  axi_host host (
      .clk(clk), .awvalid(awvalid), .awaddr(awaddr), .awready(awready), .wvalid(wvalid), .wdata(wdata), .wstrb(wstrb),
      .wready(wready), .bvalid(bvalid), .bresp(bresp), .bready(bready), .arvalid(arvalid), .araddr(araddr),
      .arready(arready), .rvalid(rvalid), .rdata(rdata), .rresp(rresp), .rready(rready)
  );

  // Both gates of a leg: never.
  always @(posedge clk) begin
    if (!rst && ((uh && ul) || (vh && vl) || (wh && wl))) fail("both gates of a leg are on");
  end

  logic failed = 1'b0;
  task automatic fail(input string why);
    if (!failed) $display("FAILED: %s", why);
    failed = 1'b1;
    $fatal(1);
  endtask

  string file;
  int errors, count, clocks = 0;
  logic [31:0] value;
  initial begin
    if (!$value$plusargs("words=%s", file)) fail("no +words=FILE.mem");
    repeat (4) @(negedge clk);
    rst = 1'b0;
    repeat (4) @(negedge clk);
    host.configure(file, errors, count);
    if (count < kLeastWords) fail("the list of words is not there, or empty");
    if (errors != 0) fail($sformatf("%0d of %0d words are not kept", errors, count));
    if (gates != 6'd0) fail("a gate is on before run");
    host.write(12'h00c, 32'd3);  // CONTROL: configured, run
    clocks = 0;
    while (gates == 6'd0 && clocks < kWait) begin
      @(negedge clk);
      clocks = clocks + 1;
    end
    if (gates == 6'd0) fail($sformatf("no gate is on %0d clocks after run", kWait));
    $display("%0d words; the first gate is on %0d clocks after run", count, clocks);
    fault = 1'b1;
    repeat (kFaultClocks) @(negedge clk);
    #1 if (gates != 6'd0) fail($sformatf("a gate is on %0d clocks after the fault pin", kFaultClocks));
    repeat (100) @(negedge clk);
    if (gates != 6'd0 || !latched) fail("the fault is not latched");
    host.read(12'h014, value);  // FAULT
    if (value[0] !== 1'b1 || value[7:4] !== 4'd1) fail("FAULT does not say fault pin");
    if (!failed) $display("PASSED");
    $finish;
  end
endmodule
