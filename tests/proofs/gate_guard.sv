// The gate guard's contract, for every input sequence: rtl/gate_guard.sv with Floor 12.
//
// Each leg has its own checker, which sees the pins of that leg and nothing else: it counts clocks and
// remembers the dead times and minima that were asked for.  With INVARIANTS it also sees the leg's
// registers (the proof script connects them) and says how they go with its counts: that is what makes
// the induction close.  The negative controls run without, so that what fails there is the contract.
//
//! induction sat
//! connect u_timer dut.u.timer
//! connect u_was dut.u.was
//! connect v_timer dut.v.timer
//! connect v_was dut.v.was
//! connect w_timer dut.w.timer
//! connect w_was dut.w.was

module leg_contract #(
    parameter FLOOR = 12
) (
    input logic       clk,
    input logic       rst,
    input logic       high_request,
    input logic       low_request,
    input logic       enable,
    input logic       fault,
    input logic [7:0] dead_time,
    input logic [7:0] minimum,
    input logic       high,
    input logic       low,
    input logic [7:0] timer,
    input logic       was_high,
    input logic       was_low
);
  wire       on   = high || low;
  wire       off  = fault || !enable;
  wire [7:0] dead = dead_time < FLOOR ? FLOOR : dead_time;

  // All of these speak of the clocks before this one.
  reg       last_on = 0, last_high = 0, last_off = 1;
  reg [8:0] off_clocks = 0;      // both gates off in a row, stops at 511
  reg [8:0] on_clocks = 0;       // a gate on in a row, stops at 511
  reg [8:0] high_clocks = 0;     // the same request in a row, with no reset, fault or lost enable
  reg [8:0] low_clocks = 0;
  reg [7:0] least_dead = 255;    // the smallest dead time since the leg was on, that clock included
  reg [7:0] promised = 0;        // the minimum asked for when the gate turned on
  reg [7:0] last_minimum = 0;

  function [8:0] count(input [8:0] clocks, input more);
    count = !more ? 9'd0 : clocks == 9'd511 ? 9'd511 : clocks + 9'd1;
  endfunction

  always @(posedge clk) begin
    last_on      <= on;
    last_high    <= high;
    last_off     <= off || rst;
    off_clocks   <= count(off_clocks, !on);
    on_clocks    <= count(on_clocks, on);
    high_clocks  <= count(high_clocks, high_request && !low_request && !off && !rst);
    low_clocks   <= count(low_clocks, low_request && !high_request && !off && !rst);
    least_dead   <= on || dead < least_dead ? dead : least_dead;
    last_minimum <= minimum;
    if (on && !last_on) promised <= last_minimum;
  end

  // Before the first reset the registers hold anything.
  reg valid = 0;
  always @(posedge clk) if (rst) valid <= 1;

  always @* if (valid) begin
    // No shoot-through.
    never_both: assert (!(high && low));
    never_swapped: assert (!(on && last_on && high != last_high));
    if (on && !last_on) begin
      dead_time_kept: assert (off_clocks >= least_dead);
      floor_kept: assert (off_clocks >= FLOOR);
      // A request of the dead time or less never arrives, nor one that nobody made.
      no_short_request: assert ((high ? high_clocks : low_clocks) > least_dead);
    end
    // One clock after fault, lost enable or reset all gates are off.
    off_in_one_clock: assert (!(last_off && on));
    // The minimum on-time, but for the line above.
    if (last_on && !on && !last_off) begin
      minimum_kept: assert (on_clocks >= promised);
    end
  end

  always @* if (valid) begin
    turns_on_high: cover (high);
    turns_on_low: cover (low);
    // Off again by the request alone, after the minimum.
    turns_off: cover (!on && last_on && !last_off && promised > 2);
  end

`ifdef INVARIANTS
  always @* floor_of_dead: assert (least_dead >= FLOOR);

  wire [7:0] promise = last_on ? promised : last_minimum;
  always @* if (valid) begin
    request_high: assert (was_high == (high_clocks != 0));
    one_request: assert (!(was_high && was_low));
    request_low: assert (was_low == (low_clocks != 0));
    counts_of_on: assert (last_on == (on_clocks != 0));
    counts_of_off: assert (!last_on || off_clocks == 0);
    if (on) begin
      time_to_turn_off: assert (10'd0 + on_clocks + timer >= promise);
    end else if (was_high || was_low) begin
      time_to_turn_on: assert (10'd0 + off_clocks + timer >= least_dead);
      time_of_request: assert (10'd0 + (was_high ? high_clocks : low_clocks) + timer > least_dead);
    end
  end
`endif
endmodule

module gate_guard_proof (
    input logic       clk,
    input logic       rst,
    input logic       request_uh,
    input logic       request_ul,
    input logic       request_vh,
    input logic       request_vl,
    input logic       request_wh,
    input logic       request_wl,
    input logic       enable,
    input logic       fault,
    input logic [7:0] dead_time,
    input logic [7:0] minimum
);
  logic uh, ul, vh, vl, wh, wl;
  gate_guard dut (
      .clk(clk),
      .rst(rst),
      .request_uh_i(request_uh),
      .request_ul_i(request_ul),
      .request_vh_i(request_vh),
      .request_vl_i(request_vl),
      .request_wh_i(request_wh),
      .request_wl_i(request_wl),
      .enable_i(enable),
      .fault_i(fault),
      .dead_time_i(dead_time),
      .minimum_i(minimum),
      .uh_o(uh),
      .ul_o(ul),
      .vh_o(vh),
      .vl_o(vl),
      .wh_o(wh),
      .wl_o(wl)
  );

  // Registers of the legs, connected by the proof script where it needs them.
  wire [7:0] u_timer, v_timer, w_timer;
  wire [1:0] u_was, v_was, w_was;

  leg_contract u_contract (
      .clk(clk), .rst(rst), .high_request(request_uh), .low_request(request_ul),
      .enable(enable), .fault(fault), .dead_time(dead_time), .minimum(minimum),
      .high(uh), .low(ul), .timer(u_timer), .was_high(u_was[0]), .was_low(u_was[1])
  );
`ifdef SHORT
  // Covers and counterexamples take as many clocks as the times that they wait for.
  always @* begin
    assume (dead_time == 0);
    assume (minimum < 4);
    assume (!request_vh && !request_vl && !request_wh && !request_wl);
  end
`else
  leg_contract v_contract (
      .clk(clk), .rst(rst), .high_request(request_vh), .low_request(request_vl),
      .enable(enable), .fault(fault), .dead_time(dead_time), .minimum(minimum),
      .high(vh), .low(vl), .timer(v_timer), .was_high(v_was[0]), .was_low(v_was[1])
  );
  leg_contract w_contract (
      .clk(clk), .rst(rst), .high_request(request_wh), .low_request(request_wl),
      .enable(enable), .fault(fault), .dead_time(dead_time), .minimum(minimum),
      .high(wh), .low(wl), .timer(w_timer), .was_high(w_was[0]), .was_low(w_was[1])
  );
`endif
endmodule
