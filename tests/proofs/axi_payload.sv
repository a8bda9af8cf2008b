// AXI4-Lite, answers under back-pressure: rtl/axi_lite.sv with the registers that make its payload,
// rtl/drive_registers.sv.  While an answer waits for its host, bresp, rdata and rresp stand still, and they are
// those of its own transfer, whatever the other channel, the drive and the map do meanwhile: all of these are
// free here.  So is the host, who need not even keep valid until ready.  What ConfigRegisters answers is free
// too, within its contract: it stays until the next read, and is 0 if that is of a hole (proof config_registers
// and tests/hls/six_step_axi_test.cpp).
//! solver cvc5
//! connect never_written_0 registers.copies_0.words[0]
//! connect never_written_1 registers.copies_1.words[0]
//! connect never_written_2 registers.copies_2.words[0]
//! connect never_written_3 registers.copies_3.words[0]
//! connect never_written_4 registers.copies_4.words[0]

module axi_payload_proof (
    input logic        clk,
    input logic        rst,
    input logic        awvalid,
    input logic [11:0] awaddr,
    input logic        wvalid,
    input logic [31:0] wdata,
    input logic [3:0]  wstrb,
    input logic        bready,
    input logic        arvalid,
    input logic [11:0] araddr,
    input logic        rready,
    input logic [31:0] word_read,
    input logic        hole,
    input logic        refused,
    input logic        unlocked,
    input logic        no_period,
    input logic        tick,
    input logic [19:0] clock_khz,
    input logic [3:0]  state,
    input logic [3:0]  reason,
    input logic        locked,
    input logic        reverse,
    input logic [25:0] frequency,
    input logic [15:0] duty,
    input logic [15:0] phase_error,
    input logic [79:0] counts
);
  logic awready, wready, bvalid, arready, rvalid;
  logic write, read, write_error, read_error;
  logic [9:0] index;
  logic [31:0] asked_data, data;
  logic [3:0] strobes;

  axi_lite bus (
      .clk(clk), .rst(rst),
      .awvalid_i(awvalid), .awaddr_i(awaddr), .wvalid_i(wvalid), .wdata_i(wdata),
      .wstrb_i(wstrb), .bready_i(bready), .arvalid_i(arvalid), .araddr_i(araddr),
      .rready_i(rready),
      .awready_o(awready), .wready_o(wready), .bvalid_o(bvalid), .arready_o(arready),
      .rvalid_o(rvalid),
      .request_write_o(write), .request_read_o(read), .request_index_o(index),
      .request_data_o(asked_data), .request_strobes_o(strobes)
  );
  // The words' answer, as their contract has it.
  reg [31:0] word = 0;
  always @(posedge clk) if (rst) word <= 0; else if (read) word <= hole ? 0 : word_read;

  drive_registers registers (
      .clk(clk), .rst(rst),
      .request_write_i(write), .request_read_i(read), .request_index_i(index),
      .request_data_i(asked_data), .request_strobes_i(strobes),
      .word_i(word), .hole_i(hole), .refused_i(refused), .unlocked_i(unlocked),
      .no_period_i(no_period), .tick_i(tick), .clock_khz_i(clock_khz),
      .drive_state_i(state), .drive_reason_i(reason), .drive_locked_i(locked),
      .drive_reverse_i(reverse), .drive_frequency_i(frequency), .drive_duty_i(duty),
      .drive_phase_error_i(phase_error), .drive_counts_crossings_i(counts[15:0]),
      .drive_counts_missed_i(counts[31:16]), .drive_counts_freewheel_long_i(counts[47:32]),
      .drive_counts_limit_hits_i(counts[63:48]), .drive_counts_retries_i(counts[79:64]),
      .command_configured_o(), .command_run_o(), .command_reverse_o(), .command_brake_to_stop_o(),
      .command_clear_fault_o(), .stopped_o(),
      .data_o(data), .read_error_o(read_error), .write_error_o(write_error), .interrupt_o()
  );

  // The clock before, and what the registers said when the transfer was taken.
  reg valid = 0;
  reg waited_b = 0, waited_r = 0, was_write_error = 0, was_read_error = 0;
  reg [31:0] was_data = 0;
  reg was_refused = 0, was_hole = 0;
  always @(posedge clk) begin
    valid <= valid || rst;
    waited_b <= !rst && bvalid && !bready;
    waited_r <= !rst && rvalid && !rready;
    was_write_error <= write_error;
    was_read_error <= read_error;
    was_data <= data;
    if (write) was_refused <= refused;
    if (read) was_hole <= hole;
  end

  always @* if (valid && !rst) begin
    // It waits, and its payload with it.
    if (waited_b) assert (bvalid && write_error == was_write_error);
    if (waited_r) assert (rvalid && read_error == was_read_error && data == was_data);
    // It is that of its own transfer.
    if (bvalid) assert (write_error == was_refused);
    if (rvalid) assert (read_error == was_hole);
    if (rvalid && was_hole) assert (data == 0);
    // No transfer is taken while the answer to the last of its kind waits.
    if (bvalid) assert (!awready);
    if (rvalid) assert (!arready);
  end

`ifdef INVARIANTS
  // A telemetry register that is not read shows word 0 of its memory, which nothing writes.
  wire [31:0] never_written_0, never_written_1, never_written_2, never_written_3, never_written_4;
  always @* assert (~|{never_written_0, never_written_1, never_written_2, never_written_3, never_written_4});
`endif

  always @* if (valid && !rst) begin
    cover (waited_b && write_error && read);
    cover (waited_r && data != 0 && write && refused);
    cover (waited_b && waited_r);
  end
endmodule
