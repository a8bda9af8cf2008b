// A motor that turns: six_step_axi, its host and motor.sv.  It starts, locks and accelerates.
//
//     iverilog -g2012 -o turning_motor.vvp -s turning_motor -c rtl/six_step_axi.f rtl/bench/*.sv
//     vvp -n turning_motor.vvp +words=rtl/words/maxon_ec45_flat.mem [+dump=FILE.vcd]
//
// The lock comes after 27 ms, half a minute of Icarus.  The parameters of motor.sv are those of drives/maxon_ec45_flat.toml; for another drive give it that one's.  It prints what happened
// and PASSED; or FAILED and why, and its exit code is 1.
//
// Doc: docs/integration.md   Test: tests/rtl/turning_motor.sh

`timescale 1ns / 1ps

module turning_motor #(
    // With the Hall decoder the drive first observes whether its rotor turns: -P turning_motor.WITH_HALL_DECODER=1
    parameter logic WITH_HALL_DECODER = 1'b0,
    parameter int LATEST = 4_800_000  // clocks until it has to be in lock
);
  localparam real kClockHz = 24.0e6;
  localparam int kPolePairs = 8, kAfter = 48_000;

  logic clk = 1'b0, rst = 1'b1;
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
      .pins_comparator_u_i(comparator[0]), .pins_comparator_v_i(comparator[1]), .pins_comparator_w_i(comparator[2]),
      .pins_limit_i(limit), .pins_fault_i(1'b0),
      .pins_hall_u_i(1'b0), .pins_hall_v_i(1'b0), .pins_hall_w_i(1'b0),
      .axi_awvalid_i(awvalid), .axi_awaddr_i(awaddr), .axi_wvalid_i(wvalid), .axi_wdata_i(wdata), .axi_wstrb_i(wstrb),
      .axi_bready_i(bready), .axi_arvalid_i(arvalid), .axi_araddr_i(araddr), .axi_rready_i(rready),
      .gates_uh_o(uh), .gates_ul_o(ul), .gates_vh_o(vh), .gates_vl_o(vl), .gates_wh_o(wh), .gates_wl_o(wl),
      .interrupt_o(interrupt), .locked_o(locked), .fault_o(latched),
      .axi_awready_o(awready), .axi_wready_o(wready), .axi_bvalid_o(bvalid), .axi_bresp_o(bresp),
      .axi_arready_o(arready), .axi_rvalid_o(rvalid), .axi_rdata_o(rdata), .axi_rresp_o(rresp)
  );
  wire [2:0] comparator;
  wire limit;
  motor motor (.clk(clk), .high({wh, vh, uh}), .low({wl, vl, ul}), .comparator(comparator), .limit(limit));
  axi_host host (
      .clk(clk), .awvalid(awvalid), .awaddr(awaddr), .awready(awready), .wvalid(wvalid), .wdata(wdata), .wstrb(wstrb),
      .wready(wready), .bvalid(bvalid), .bresp(bresp), .bready(bready), .arvalid(arvalid), .araddr(araddr),
      .arready(arready), .rvalid(rvalid), .rdata(rdata), .rresp(rresp), .rready(rready)
  );

  logic failed = 1'b0;
  task automatic fail(input string why);
    if (!failed) $display("FAILED: %s", why);
    failed = 1'b1;
    $fatal(1);
  endtask
  // Both gates of a leg: never.
  always @(posedge clk) begin
    if (!rst && ((uh && ul) || (vh && vl) || (wh && wl))) fail("both gates of a leg are on");
  end

  string file;
  int errors, count, clocks = 0;
  real locked_rpm, told_rpm;
  logic [31:0] value;
  initial begin
    if ($value$plusargs("dump=%s", file)) begin
      $dumpfile(file);
      $dumpvars(0, turning_motor);
    end
    if (!$value$plusargs("words=%s", file)) fail("no +words=FILE.mem");
    $readmemh(file, host.words);
    repeat (4) @(posedge clk);
    rst <= 1'b0;
    repeat (4) @(posedge clk);
    host.configure(errors, count);
    if (errors != 0 || count == 0) fail($sformatf("%0d of %0d words are not kept", errors, count));
    host.write(12'h00c, 32'd3);  // CONTROL: configured, run
    while (!locked && clocks < LATEST) begin
      @(posedge clk);
      clocks = clocks + 1;
      if (latched) fail("the drive's fault is latched");
    end
    if (!locked) fail($sformatf("no lock within %0d clocks", LATEST));
    $display("locked after %0.2f ms at %0.0f r/min, %0.2f A at most", clocks * 1.0e3 / kClockHz, motor.rpm, motor.peak_a);
    locked_rpm = motor.rpm;
    repeat (kAfter) begin
      @(posedge clk);
      if (!locked || latched) fail("the lock is lost");
    end
    // The drive's own frequency is the rotor's: six steps a turn and pole pair.
    host.write(12'h02c, 32'd1);  // SNAPSHOT
    host.read(12'h030, value);  // TELEMETRY_SPEED
    told_rpm = value * kClockHz / 4294967296.0 * 10.0 / kPolePairs;
    $display("%0.0f r/min %0.1f ms later, %0.0f by the drive", motor.rpm, kAfter * 1.0e3 / kClockHz, told_rpm);
    if (motor.rpm <= locked_rpm) fail("it does not accelerate");
    // The set speed rises by 6.6 r/min a millisecond, and the loop's integral takes 1 / 0.16 steps, 5 ms: the drive's speed may be as much behind.
    if (told_rpm < 0.98 * motor.rpm || told_rpm > 1.02 * motor.rpm) fail("the drive's speed is not the rotor's");
    $display("PASSED");
    $finish;
  end
endmodule
