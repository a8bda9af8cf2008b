// The two exact ends of the PWM generator, rtl/pwm_generator.sv, for every sequence of the other words:
// an on-time of 0 is never on; an on-time of the period or more is on from the first clock of the first
// period, without a gap, even while the period changes.
//
//! connect left dut.left
//! connect pulse dut.pulse
//! connect lead dut.lead
//! connect waiting dut.waiting
//! connect always_on dut.always_
//! connect first dut.first

module pwm_generator_proof (
    input logic        clk,
    input logic        rst,
    input logic        full,
    input logic [13:0] on_clocks,
    input logic [13:0] period,
    input logic [13:0] minimum,
    input logic        centred,
    input logic [7:0]  tick_periods
);
  logic on, start, tick;
  pwm_generator dut (
      .clk(clk),
      .rst(rst),
      .on_clocks_i(on_clocks),
      .period_i(period),
      .minimum_i(minimum),
      .centred_i(centred),
      .tick_periods_i(tick_periods),
      .on_o(on),
      .start_o(start),
      .tick_o(tick)
  );

  // Which end is looked at: free, but the same throughout.
  reg kept_full = 0, started = 0;
  always @(posedge clk) begin
    kept_full <= full;
    started <= 1;
  end
  always @* begin
    if (started) assume (full == kept_full);
    if (full) begin
      assume (period != 0 && on_clocks >= period && minimum <= on_clocks);
    end else begin
      assume (on_clocks == 0);
    end
`ifdef SHORT
    assume (period < 4 && minimum < 4);
`endif
  end

  // Before the first reset the registers hold anything; after one, nothing runs before its first start.
  reg valid = 0, running = 0;
  always @(posedge clk) begin
    valid   <= valid || rst;
    running <= !rst && (running || start);
  end

  always @* if (valid) begin
    if (full) begin
      if (running || start) begin
        full_is_on: assert (on);
      end
    end else begin
      zero_is_off: assert (!on);
    end
    a_full_period: cover (full && running && start && on);
    an_empty_period: cover (!full && running && start);
  end

  // Registers, connected by the proof script where it needs them.
  wire [13:0] left, pulse;
  wire [12:0] lead;
  wire waiting, always_on, first;
`ifdef INVARIANTS
  // A reset empties everything; so does the first clock after it, which only takes words.
  wire empty = left == 0 && !always_on && !waiting && !on && !start;
  always @* if (valid) begin
    if (!full) begin
      no_pulse: assert (!always_on && (pulse == 0 || !waiting));
    end else if (empty) begin
      nothing_yet: assert (!running);
    end else begin
      // Two ways to 100 %: by name, or by a pulse that ends with its period.
      config_taken: assert (left != 0);
      all_of_it: assert (always_on || (pulse == left && (first ? waiting && lead == 0 : on && !waiting)));
      no_gap: assert (on || !(running || start));
      started_by_now: assert (first || running || start);
      still_on: assert (on || first);
    end
  end
`endif
endmodule
