// A first start of six_step_axi, without a motor: configuration from a list of words, run, gates that drive, the fault pin, gates that
// do not.
//
//     tools/bench icarus first_start [+config=FILE.mem]
//
// It prints PASSED; or FAILED and why, and its exit code is 1.
//
// Doc: docs/integration.md   Test: tests/rtl/bench.sh

`timescale 1ns / 1ps

module first_start #(
    // With the Hall decoder the drive first looks whether its rotor spins: -P first_start.WITH_HALL_DECODER=1
    parameter logic WITH_HALL_DECODER = 1'b0
);
  localparam int kLeastWords = 10, kWait = 3_000_000, kFaultClocks = 3;

  logic clk = 1'b0, rst = 1'b1, fault = 1'b0;
  always #20 clk = ~clk;

  wire [2:0] high, low;
  wire locked, latched;
  wire [5:0] gates = {high, low};
  hosted_drive #(.WITH_HALL_DECODER(WITH_HALL_DECODER)) drive (
      .clk(clk), .rst(rst), .comparator(3'd0), .limit(1'b0), .fault(fault), .high(high), .low(low), .locked(locked), .latched(latched)
  );
  judge judge (.clk(clk), .rst(rst), .high(high), .low(low), .locked(locked), .latched(latched), .rpm(0.0), .peak_a(0.0));

  string file;
  int errors, count, clocks = 0;
  logic [31:0] value;
  initial begin
    if (!$value$plusargs("config=%s", file)) judge.fail("no +config=FILE.mem");
    repeat (4) @(negedge clk);
    rst = 1'b0;
    repeat (4) @(negedge clk);
    drive.host.configure(file, errors, count);
    if (count < kLeastWords) judge.fail("the configuration is not there, or empty");
    if (errors != 0) judge.fail($sformatf("%0d of %0d words are not kept", errors, count));
    if (gates != 6'd0) judge.fail("a gate is on before run");
    drive.host.write(12'h00c, 32'd3);  // CONTROL: configured, run
    clocks = 0;
    while (gates == 6'd0 && clocks < kWait) begin
      @(negedge clk);
      clocks = clocks + 1;
    end
    if (gates == 6'd0) judge.fail($sformatf("no gate is on %0d clocks after run", kWait));
    $display("%0d words; the first gate is on %0d clocks after run", count, clocks);
    fault = 1'b1;
    repeat (kFaultClocks) @(negedge clk);
    #1 if (gates != 6'd0) judge.fail($sformatf("a gate is on %0d clocks after the fault pin", kFaultClocks));
    repeat (100) @(negedge clk);
    if (gates != 6'd0 || !latched) judge.fail("the fault is not latched");
    drive.host.read(12'h014, value);  // FAULT
    if (value[0] !== 1'b1 || value[7:4] !== 4'd1) judge.fail("FAULT does not say fault pin");
    if (!judge.failed) $display("PASSED");
    $finish;
  end
endmodule
