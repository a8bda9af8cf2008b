// clock_watch: silent while the clock runs, at any speed that it takes, low within 18 ticks of the other oscillator once it stands, on
// either level, and high again when it runs.  Prints PASSED; or FAILED and why.
`timescale 1ns / 1ps

module clock_watch_bench;
  localparam realtime kTick = 166.7;  // 6 MHz
  realtime half = 41.7;               // 12 MHz
  logic clk = 1'b0, other = 1'b0, runs = 1'b1;
  always #(half) if (runs) clk = ~clk;
  always #(kTick / 2.0) other = ~other;
  wire alive;
  clock_watch dut (.clk(clk), .other(other), .alive(alive));

  int frequencies = 0;
  logic failed = 1'b0, may_fall = 1'b1;
  task automatic fail(input string why);
    if (!failed) $display("FAILED: %s", why);
    failed = 1'b1;
  endtask
  always @(negedge alive) if (!may_fall) fail($sformatf("it falls while the clock runs with a half period of %0.1f ns", half));

  task automatic stop_and_go(input logic level);
    wait (clk == level);
    #1 runs = 1'b0;
    may_fall = 1'b1;
    repeat (18) @(posedge other);
    #1 if (alive) fail($sformatf("the clock stands at %0d, and it is high 18 ticks later", level));
    repeat (1000) begin
      @(posedge other) #1 if (alive) fail("the clock stands, and it rises");
    end
    runs = 1'b1;
    repeat (26) @(posedge other);
    #1 if (!alive) fail("the clock runs again, and it is low 26 ticks later");
    may_fall = 1'b0;
  endtask

  initial begin
    if (alive) fail("it is high from the start");
    repeat (26) @(posedge other);
    #1 if (!alive) fail("the clock runs, and it is low");
    may_fall = 1'b0;
    // From half of the other's frequency to eighteen times it, in steps that meet every phase.
    for (half = kTick; half > 4.6; half = half * 0.93) begin
      frequencies = frequencies + 1;
      repeat (3000) @(posedge other);
      stop_and_go(1'b0);
      stop_and_go(1'b1);
    end
    if (!failed) $display("PASSED at %0d frequencies", frequencies);
    $finish;
  end
endmodule
