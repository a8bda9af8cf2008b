// A motor that turns with sinusoidal currents: sinusoidal_axi, its host, its ADCs and motor.sv.  It starts, locks and comes to
// its set speed; then a load, a stop, an ADC that falls silent, and another start.
//
//     tools/bench verilator turning_sinusoidal
//     tools/bench icarus turning_sinusoidal +first_ms=4 [+dump=FILE.vcd]      the calibration and the pattern that pulls the rotor
//
// The motor's parameters are those of drives/m2310p_sinusoidal.toml.  It prints what happened and PASSED; or FAILED and why, and its exit code is 1.
//
// Doc: docs/integration.md   Test: tests/rtl/turning_sinusoidal.sh

`timescale 1ns / 1ps

module turning_sinusoidal #(
    parameter int LATEST = 12_000_000  // clocks until it has to be in lock
);
  localparam real kClockHz = 24.0e6, kPwmHz = 20.0e3;
  localparam int kPolePairs = 4;
  localparam int kMs = 24_000;  // clocks
  localparam logic [11:0] kControl = 12'h00c, kStatus = 12'h010, kFault = 12'h014, kSnapshot = 12'h02c, kSpeed = 12'h030, kSet = 12'h044,
                          kClear = 12'h048;
  localparam logic [31:0] kRun = 32'd2, kBrake = 32'd8;
  localparam real kSetRpm = 3000.0, kLoad = 0.1;  // N m, half of the rated torque

  logic clk = 1'b0, rst = 1'b1, fault = 1'b0;
  always #20 clk = ~clk;

  wire [2:0] high, low, comparator;
  wire limit, locked, latched;
  wire [5:0] gates = {high, low};
  hosted_sinusoidal #(.current_a(20.0), .voltage_v(36.0)) drive (
      .clk(clk), .rst(rst), .current_u_a(motor.i[0]), .current_v_a(motor.i[1]), .bus_v(motor.bus_v), .fault(fault),
      .high(high), .low(low), .locked(locked), .latched(latched)
  );
  judge judge (
      .clk(clk), .rst(rst), .high(high), .low(low), .locked(locked), .latched(latched), .rpm(motor.rpm), .peak_a(motor.peak_a)
  );
  motor #(
      .step_clocks(1), .resistance_ohm(0.38), .inductance_h(0.2e-3), .flux_vs(6.37e-3), .pole_pairs(4), .inertia_kgm2(7.06e-6), .coulomb_nm(3e-3),
      .viscous_nms(5e-6), .bus_v(24.0), .diode_v(0.55), .limit_a(15.0)
  ) motor (.clk(clk), .high(high), .low(low), .comparator(comparator), .limit(limit));

  string file;
  int errors, count, ms, first_ms;
  real told_rpm;
  logic [31:0] value;
  initial begin
    if ($value$plusargs("dump=%s", file)) begin
      $dumpfile(file);
      $dumpvars(0, turning_sinusoidal);
    end
    if (!$value$plusargs("config=%s", file)) judge.fail("no +config=FILE.mem");
    if (!$value$plusargs("first_ms=%d", first_ms)) first_ms = 0;
    repeat (4) @(negedge clk);
    rst = 1'b0;
    repeat (4) @(negedge clk);
    drive.host.configure(file, errors, count);
    if (errors != 0 || count == 0) judge.fail($sformatf("%0d of %0d words are not kept", errors, count));
    if (gates != 6'd0) judge.fail("a gate is on before run");
    drive.host.write(kControl, 32'd3);  // configured, run
    if (first_ms > 0) begin
      repeat (first_ms * kMs) @(negedge clk);
      drive.host.read(kStatus, value);
      $display("state %0d after %0d ms, %0.2f A at most", value[3:0], first_ms, motor.peak_a);
      if (latched) judge.fail("the drive's fault is latched");
      if (value[3:0] != 4'd3) judge.fail("it does not pull the rotor");
      $display("PASSED");
      $finish;
    end
    judge.locks(LATEST);
    judge.arrives(kSetRpm, 0.01, 500, "it does not come to its set speed");
    // The estimated speed is the rotor's: 1/16 of an electrical turn a sample is the whole of s0.15.
    drive.host.write(kSnapshot, 32'd1);
    drive.host.read(kSpeed, value);
    told_rpm = $itor($signed(value[15:0])) / 32768.0 / 16.0 * kPwmHz * 60.0 / kPolePairs;
    $display("%0.0f r/min by the drive", told_rpm);
    if (told_rpm < 0.99 * motor.rpm || told_rpm > 1.01 * motor.rpm) judge.fail("the drive's speed is not the rotor's");
    motor.load_nm = kLoad;
    repeat (100 * kMs) @(negedge clk);
    judge.arrives(kSetRpm, 0.01, 100, "it does not carry its load");
    motor.load_nm = 0.0;
    drive.host.write(kSet, kBrake);
    drive.host.write(kClear, kRun);
    drive.host.until_stopped(kMs, 3000, ms);
    if (ms == 3000 || gates != 6'd0) judge.fail("it does not stop");
    $display("stopped after %0d ms, at %0.0f r/min", ms, motor.rpm);
    drive.host.write(kSet, kRun);
    judge.locks(LATEST);
    drive.lost = 1'b1;
    repeat (2 * kMs) @(negedge clk);
    drive.host.read(kFault, value);
    if (gates != 6'd0 || !latched || value[7:4] != 4'd3) judge.fail("ADCs that fall silent are no fault");
    $display("without samples: fault, reason %0d, gates off", value[7:4]);
    $display("PASSED");
    $finish;
  end
endmodule
