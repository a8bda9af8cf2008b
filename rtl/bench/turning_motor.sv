// A motor that turns: six_step_axi, its host and motor.sv.  It starts, and holds its lock.
//
//     tools/bench icarus turning_motor [+dump=FILE.vcd]
//     tools/bench verilator turning_motor [+long]
//
// The lock comes after 28 ms: half a minute of Icarus, half a second of Verilator.  With +long follow the way to its set speed, a load, a reversal, a fault that is cleared, a flying start or another one, and a stop.
// The parameters of motor.sv are those of drives/maxon_ec45_flat.toml; for another drive give it that one's.  It prints what happened and PASSED; or FAILED and why, and its exit code is 1.
//
// Doc: docs/integration.md   Test: tests/rtl/turning_motor.sh

`timescale 1ns / 1ps

module turning_motor #(
    // With the Hall decoder the drive first looks whether its rotor spins: -P turning_motor.WITH_HALL_DECODER=1
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

  wire [2:0] high, low, comparator;
  wire limit, locked, latched;
  wire [5:0] gates = {high, low};
  hosted_drive #(.WITH_HALL_DECODER(WITH_HALL_DECODER)) drive (
      .clk(clk), .rst(rst), .comparator(comparator), .limit(limit), .fault(fault), .high(high), .low(low), .locked(locked), .latched(latched)
  );
  judge judge (
      .clk(clk), .rst(rst), .high(high), .low(low), .locked(locked), .latched(latched), .rpm(motor.rpm), .peak_a(motor.peak_a)
  );
  motor motor (.clk(clk), .high(high), .low(low), .comparator(comparator), .limit(limit));

  string file;
  int errors, count, ms;
  real told_rpm;
  logic [31:0] value;
  initial begin
    if ($value$plusargs("dump=%s", file)) begin
      $dumpfile(file);
      $dumpvars(0, turning_motor);
    end
    if (!$value$plusargs("config=%s", file)) judge.fail("no +config=FILE.mem");
    repeat (4) @(negedge clk);
    rst = 1'b0;
    repeat (4) @(negedge clk);
    drive.host.configure(file, errors, count);
    if (errors != 0 || count == 0) judge.fail($sformatf("%0d of %0d words are not kept", errors, count));
    drive.host.write(kControl, 32'd3);  // configured, run
    judge.locks(LATEST);
    repeat (kAfter) begin
      @(negedge clk);
      if (!locked || latched) judge.fail("the lock is lost");
    end
    // The drive's own frequency is the rotor's: six steps a turn and pole pair.
    drive.host.write(12'h02c, 32'd1);  // SNAPSHOT
    drive.host.read(12'h030, value);  // TELEMETRY_SPEED
    told_rpm = value * kClockHz / 4294967296.0 * 10.0 / kPolePairs;
    $display("%0.0f r/min %0.1f ms later, %0.0f by the drive", motor.rpm, kAfter * 1.0e3 / kClockHz, told_rpm);
    // The set speed rises by 3.1 r/min a millisecond, and the loop's integral takes 1 / 0.16 steps, 5 ms: the drive's speed may be as much behind.
    if (told_rpm < 0.98 * motor.rpm || told_rpm > 1.02 * motor.rpm) judge.fail("the drive's speed is not the rotor's");
    if ($test$plusargs("long")) long;
    $display("PASSED");
    $finish;
  end

  // A load, a reversal, a fault and a start after it, a stop.
  task automatic long;
    drive.host.write(kTarget, 32'($rtoi(kSetRpm * kPolePairs / 10.0 / kClockHz * 4294967296.0)));
    judge.arrives(kSetRpm, 0.02, 500, "it does not come to its set speed");
    motor.load_nm = kHalfOfRated;
    repeat (200 * kMs) @(negedge clk);
    judge.arrives(kSetRpm, 0.02, 100, "it does not carry its load");
    motor.load_nm = 0.0;
    drive.host.write(kSet, kReverse);
    judge.arrives(-kSetRpm, 0.02, 2000, "it does not turn round");
    fault = 1'b1;
    repeat (3) @(negedge clk);
    if (gates != 6'd0) judge.fail("a gate is on 3 clocks after the fault pin");
    fault = 1'b0;
    repeat (100) @(negedge clk);
    if (gates != 6'd0 || !latched) judge.fail("the fault is not latched");
    drive.host.write(kClear, kRun);
    drive.host.write(kFault, 32'd1);
    repeat (10) @(negedge clk);
    drive.host.read(kFault, value);
    if (value[0]) judge.fail("the fault is not cleared");
    drive.host.write(kSet, kRun);
    judge.arrives(-kSetRpm, 0.02, 2000, "it does not start again");
    drive.host.write(kSet, kBrake);
    drive.host.write(kClear, kRun);
    drive.host.until_stopped(kMs, 3000, ms);
    if (ms == 3000 || gates != 6'd0) judge.fail("it does not stop");
    $display("stopped after %0d ms, at %0.0f r/min", ms, motor.rpm);
  endtask
endmodule
