// The rotor follower's handshake, for every input sequence: when gates may be on, and what it says meanwhile.
//
// With INVARIANTS the proof script connects the block's stage: exactly one, and gates may be on in the last two alone.
//
//! connect at dut.at_bits

module rotor_follower_proof (
    input logic        clk,
    input logic        rst,
    input logic        on,
    input logic [2:0]  comparators,
    input logic        crossing, elapsed, quarter, update, good, fast, slow, steady,
    input logic [2:0]  step,
    input logic        reverse,
    input logic [7:0]  sample_every, still,
    input logic [15:0] look, probe
);
  logic drive, load, changed, restart, caught, sure;
  logic [2:0] wanted;

  rotor_follower dut (
      .clk(clk), .rst(rst), .on_i(on), .u_i(comparators[2]), .v_i(comparators[1]), .w_i(comparators[0]),
      .crossing_i(crossing), .elapsed_i(elapsed), .quarter_i(quarter), .update_i(update), .good_i(good), .fast_i(fast),
      .slow_i(slow), .steady_i(steady), .step_i(step), .reverse_i(reverse), .sample_every_i(sample_every),
      .look_i(look), .probe_i(probe), .still_i(still),
      .drive_o(drive), .load_o(load), .step_o(wanted), .changed_o(changed), .restart_o(restart), .caught_o(caught),
      .sure_o(sure)
  );

  reg valid = 0;
  reg was_on = 0, was_drive = 0, was_restart = 0;
  always @(posedge clk) begin
    valid <= valid || rst;
    was_on <= on && !rst;
    was_drive <= drive;
    was_restart <= restart;
  end
  always @* assume (step < 6);

  always @* if (valid) begin
    // Switched off, it says nothing in the next clock.
    if (!was_on) assert (!drive && !load && !changed && !restart && !caught && !sure);
    // A step is loaded while no gate may be on, and is one of six.
    if (load) assert (!drive && !was_drive);
    assert (wanted < 6);
    if (changed) assert (load);
    // A drive begins in the clock after `restart`, and only so.
    if (restart) assert (!drive);
    if (drive && !was_drive) assert (was_restart);
    // What is handed over goes on being driven.
    if (caught) assert (drive && sure);
  end

`ifdef INVARIANTS
  wire [8:0] at;  // kOff, kDecay, kSample, kSee, kJudge, kLoad, kTurn, kHold, kDrive
  always @* if (valid) begin
    assert (at != 0 && (at & (at - 9'd1)) == 0);
    assert (!drive || at[8:7] != 0);
    assert (!at[8] || drive);
    assert (!at[7] || drive || restart);
    assert (!restart || at[7]);
    assert (!load || at[6]);
    assert (!was_drive || at[8] || at[7] || at[1] || at[0]);
  end
`endif
endmodule
