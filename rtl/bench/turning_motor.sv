// A motor that turns: six_step_axi, its host and motor.sv.  It starts, locks and accelerates.
//
//     iverilog -g2012 -o turning_motor.vvp -s turning_motor -c rtl/six_step_axi.f rtl/bench/*.sv
//     vvp -n turning_motor.vvp +words=rtl/words/maxon_ec45_flat.mem [+dump=FILE.vcd]
//
//   or verilator --binary --timing -O3 -Wno-fatal -Wno-TIMESCALEMOD --top-module turning_motor -f rtl/six_step_axi.f rtl/bench/axi_host.sv rtl/bench/motor.sv \
//         rtl/bench/turning_motor.sv
//     obj_dir/Vturning_motor +words=rtl/words/maxon_ec45_flat.mem [+long]
//
// The lock comes after 28 ms: half a minute of Icarus, half a second of Verilator.  With +long follow a load, a reversal, a fault that is cleared, a flying start or another one, and a stop.
// The parameters of motor.sv are those of drives/maxon_ec45_flat.toml; for another drive give it that one's.  It prints what happened and PASSED; or FAILED and why, and its exit code is 1.
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
  localparam int kMs = 24_000;  // clocks
  localparam logic [11:0] kControl = 12'h00c, kStatus = 12'h010, kFault = 12'h014, kTarget = 12'h0cc, kSet = 12'h044, kClear = 12'h048;
  localparam logic [31:0] kRun = 32'd2, kReverse = 32'd4, kBrake = 32'd8;
  localparam real kSetRpm = 1800.0, kHalfOfRated = 0.041;  // N m

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
      .pins_comparator_u_i(comparator[0]), .pins_comparator_v_i(comparator[1]), .pins_comparator_w_i(comparator[2]),
      .pins_limit_i(limit), .pins_fault_i(fault),
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
    repeat (4) @(negedge clk);
    rst = 1'b0;
    repeat (4) @(negedge clk);
    host.configure(file, errors, count);
    if (errors != 0 || count == 0) fail($sformatf("%0d of %0d words are not kept", errors, count));
    host.write(kControl, 32'd3);  // configured, run
    while (!locked && clocks < LATEST) begin
      @(negedge clk);
      clocks = clocks + 1;
      if (latched) fail("the drive's fault is latched");
    end
    if (!locked) fail($sformatf("no lock within %0d clocks", LATEST));
    $display("locked after %0.2f ms at %0.0f r/min, %0.2f A at most", clocks * 1.0e3 / kClockHz, motor.rpm, motor.peak_a);
    locked_rpm = motor.rpm;
    repeat (kAfter) begin
      @(negedge clk);
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
    if ($test$plusargs("long")) long;
    $display("PASSED");
    $finish;
  end

  // Until the rotor turns at `wanted` within 2 %, and in lock.
  task automatic arrives(input real wanted, input int most_ms, input string why);
    int ms;
    ms = 0;
    while (ms < most_ms && !(locked && motor.rpm / wanted > 0.98 && motor.rpm / wanted < 1.02)) begin
      repeat (kMs) @(negedge clk);
      ms = ms + 1;
    end
    if (ms == most_ms) fail(why);
    $display("%0.0f r/min: %0.0f after %0d ms", wanted, motor.rpm, ms);
  endtask

  // A load, a reversal, a fault and a start after it, a stop.
  task automatic long;
    host.write(kTarget, 32'($rtoi(kSetRpm * kPolePairs / 10.0 / kClockHz * 4294967296.0)));
    arrives(kSetRpm, 500, "it does not come to its set speed");
    motor.load_nm = kHalfOfRated;
    repeat (200 * kMs) @(negedge clk);
    arrives(kSetRpm, 100, "it does not carry its load");
    motor.load_nm = 0.0;
    host.write(kSet, kReverse);
    arrives(-kSetRpm, 2000, "it does not turn round");
    fault = 1'b1;
    repeat (3) @(negedge clk);
    if (gates != 6'd0) fail("a gate is on 3 clocks after the fault pin");
    fault = 1'b0;
    repeat (100) @(negedge clk);
    if (gates != 6'd0 || !latched) fail("the fault is not latched");
    host.write(kClear, kRun);
    host.write(kFault, 32'd1);
    repeat (10) @(negedge clk);
    host.read(kFault, value);
    if (value[0]) fail("the fault is not cleared");
    host.write(kSet, kRun);
    arrives(-kSetRpm, 2000, "it does not start again");
    host.write(kSet, kBrake);
    host.write(kClear, kRun);
    clocks = 0;
    do begin
      repeat (kMs) @(negedge clk);
      clocks = clocks + 1;
      host.read(kStatus, value);
    end while (!value[11] && clocks < 3000);
    if (!value[11] || gates != 6'd0) fail("it does not stop");
    $display("stopped after %0d ms, at %0.0f r/min", clocks, motor.rpm);
  endtask
endmodule
