// Watches a clock by another oscillator, which is not made from it: `alive` falls when the clock has stopped, and rises when it runs again.
//
// Gates are registers of the clock: when that stops, what is on stays on, and no fault pin is read any more.  So a board whose clock comes from
// outside puts `alive` behind the gates, a look-up table each, and holds the reset while it is low: a clock that comes back finds a drive
// that stands.
//
//     ask    every kRound ticks of `other` a bit is turned, once the clock has handed the last one back
//     fall   kRound + 2 to 2 kRound + 2 ticks after the clock's last edge: 3.0 us at 6 MHz
//     rise   as long after its first ones; low after configuration
//     clock  no slower than other / 2: its two flip-flops and the two of `other` have to be through within a round
//
// Doc: docs/boards.md   Test: tests/boards/clock_watch.sv

module clock_watch (
    input  logic clk,
    input  logic other,
    output logic alive  // of `other`; asynchronous to the clock
);
  localparam logic [3:0] kRound = 4'd8;
  logic ask = 1'b0;
  logic [3:0] ticks = 4'd0;
  initial alive = 1'b0;
  (* ASYNC_REG = "TRUE", syn_preserve = 1,
     altera_attribute = "-name SYNCHRONIZER_IDENTIFICATION FORCED" *)
  logic [1:0] seen = 2'b00, answer = 2'b00;

  always_ff @(posedge clk) seen <= {seen[0], ask};
  always_ff @(posedge other) begin
    answer <= {answer[0], seen[1]};
    ticks <= ticks == kRound - 4'd1 ? 4'd0 : ticks + 4'd1;
    if (ticks == kRound - 4'd1) begin
      alive <= answer[1] == ask;
      if (answer[1] == ask) ask <= !ask;  // a clock that stands hands nothing back, however long
    end
  end
endmodule
