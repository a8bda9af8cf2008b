// What the benches ask of a drive: it comes to a lock, to a speed, to a stop; and never both gates of a leg.  What does not hold is
// printed as FAILED and why, and ends the simulation with exit code 1.
//
//     judge.locks(4_800_000)     judge.arrives(1800.0, 0.02, 500, "it does not come to its set speed")     judge.fail("why")
//
// Doc: docs/integration.md   Test: tests/rtl/bench.sh

`timescale 1ns / 1ps

module judge #(
    parameter real clock_hz = 24.0e6
) (
    input logic       clk,
    input logic       rst,
    input logic [2:0] high,  // gates U, V, W
    input logic [2:0] low,
    input logic       locked,
    input logic       latched,
    input real        rpm,  // of the rotor; 0 without one
    input real        peak_a  // the highest current of a phase so far
);
  localparam int kMs = $rtoi(clock_hz / 1000.0);  // clocks

  logic failed = 1'b0;
  task automatic fail(input string why);
    if (!failed) $display("FAILED: %s", why);
    failed = 1'b1;
    $fatal(1);
  endtask
  always @(posedge clk) if (!rst && (high & low) != 3'd0) fail("both gates of a leg are on");

  // In lock within so many clocks.
  task automatic locks(input int latest);
    int clocks;
    clocks = 0;
    while (!locked && clocks < latest) begin
      @(negedge clk);
      clocks = clocks + 1;
      if (latched) fail("the drive's fault is latched");
    end
    if (!locked) fail($sformatf("no lock within %0d clocks", latest));
    $display("locked after %0.2f ms at %0.0f r/min, %0.2f A at most", clocks * 1.0e3 / clock_hz, rpm, peak_a);
  endtask

  // In lock at `wanted`, by no more than that part of it off, within so many ms.
  task automatic arrives(input real wanted, input real off, input int most_ms, input string why);
    int ms;
    ms = 0;
    while (ms < most_ms && !(locked && rpm / wanted > 1.0 - off && rpm / wanted < 1.0 + off)) begin
      repeat (kMs) @(negedge clk);
      ms = ms + 1;
    end
    if (ms == most_ms) fail(why);
    $display("%0.0f r/min: %0.0f after %0d ms", wanted, rpm, ms);
  endtask
endmodule
