// What a drive on AXI4-Lite promises, seen at its ports alone: bind it in your own testbench, or instantiate it beside the drive.
//
//     bind six_step_axi drive_properties properties (.*, .fault_pin(pins_fault_i));
//     bind sinusoidal_axi drive_properties #(.SINUSOIDAL(1'b1)) properties (.*, .fault_pin(fault_i));
//
//     gates      never both of a leg; both off for FLOOR clocks between them; off in the clock after a reset, 3 clocks after the
//                fault pin, 4 after a latched fault, and 4 after a write that takes CONTROL.configured away was answered; none
//                is on before CONTROL.configured was written
//     bus        one answer for each request, and none without; valid and what it says stay until they are taken; 0 or 2
//     registers  a write to a keyed register behind the closed lock, or to a read-only one, is answered with an error
//     signals    in lock is not in fault
//
// A promise that is broken prints `FAILED:` with the time and which, and stops the simulation.  Plain SystemVerilog, no SVA: tried
// in Verilator, which binds, and in Icarus, which does not (instantiate it there).
//
// Doc: docs/integration.md   Test: tests/rtl/properties.sh

`timescale 1ns / 1ps

module drive_properties #(
    parameter int FLOOR = 12,  // CAPABILITY.dead_time_floor
    parameter logic SINUSOIDAL = 1'b0  // whose register map it is
) (
    input logic        clk, rst, fault_pin,
    input logic        axi_awvalid_i, axi_awready_o, axi_wvalid_i, axi_wready_o, axi_bvalid_o, axi_bready_i,
    input logic        axi_arvalid_i, axi_arready_o, axi_rvalid_o, axi_rready_i,
    input logic [11:0] axi_awaddr_i,
    input logic [31:0] axi_wdata_i, axi_rdata_o,
    input logic [3:0]  axi_wstrb_i,
    input logic [1:0]  axi_bresp_o, axi_rresp_o,
    input logic        gates_uh_o, gates_ul_o, gates_vh_o, gates_vl_o, gates_wh_o, gates_wl_o,
    input logic        locked_o, fault_o
);
  localparam int kFaultPin = 3, kLatched = 4, kConfigured = 4;  // clocks
  // A bit for each word of the register map, address / 4.
  localparam logic [63:0] kKeyed = SINUSOIDAL ? 64'h3c00_0002_0000_0200 : 64'h0e00_0006_0000_0200;
  localparam logic [63:0] kReadOnly = SINUSOIDAL ? 64'h8000_0000_0009_f017 : 64'hc000_0000_0009_f017;

  task automatic fail(input string what);
    $display("FAILED: %0t: %s", $time, what);
    $fatal(1);
  endtask

  wire [2:0] high = {gates_wh_o, gates_vh_o, gates_uh_o}, low = {gates_wl_o, gates_vl_o, gates_ul_o};
  wire any = {high, low} != 6'd0;

  // Clocks since each gate was on, and since the causes that turn all of them off have lasted.
  int high_off[3], low_off[3];
  int pin = 0, in_fault = 0, taken_away = 0;
  logic valid = 1'b0, was_rst = 1'b0, configured = 1'b0;
  initial begin
    for (int k = 0; k < 3; k++) begin
      high_off[k] = FLOOR;
      low_off[k] = FLOOR;
    end
  end
  always @(posedge clk) begin
    valid <= valid || rst;
    was_rst <= rst;
    pin <= fault_pin ? pin + 1 : 0;
    in_fault <= fault_o ? in_fault + 1 : 0;
    for (int k = 0; k < 3; k++) begin
      high_off[k] <= high[k] ? 0 : high_off[k] + 1;
      low_off[k] <= low[k] ? 0 : low_off[k] + 1;
    end
    if (valid) begin
      if ((high & low) != 3'd0) fail("both gates of a leg are on");
      for (int k = 0; k < 3; k++) begin
        if (high[k] && low_off[k] < FLOOR) fail("a high side is on within the dead time");
        if (low[k] && high_off[k] < FLOOR) fail("a low side is on within the dead time");
      end
      if (any && was_rst) fail("a gate is on in the clock after a reset");
      if (any && pin >= kFaultPin) fail("a gate is on 3 clocks after the fault pin");
      if (any && in_fault >= kLatched) fail("a gate is on 4 clocks after the fault was latched");
      if (any && !configured) fail("a gate is on, and CONTROL.configured was not written");
      if (any && taken_away >= kConfigured) fail("a gate is on 4 clocks after CONTROL.configured was taken away");
      if (locked_o && fault_o) fail("in lock and in fault");
    end
  end

  // What is being written, and what the lock was then.
  logic [9:0] index;
  logic [31:0] data;
  logic [3:0] strobes;
  logic writing = 1'b0, reading = 1'b0, unlocked = 1'b0;
  wire takes = axi_awvalid_i && axi_awready_o && axi_wvalid_i && axi_wready_o;
  wire asks = axi_arvalid_i && axi_arready_o;
  wire answers = axi_bvalid_o && axi_bready_i, tells = axi_rvalid_o && axi_rready_i;
  localparam logic [9:0] kControl = 10'h03, kSet = 10'h11, kClear = 10'h12, kLock = 10'h08;
  wire sets = (axi_awaddr_i[11:2] == kControl || axi_awaddr_i[11:2] == kSet) && axi_wdata_i[0] && axi_wstrb_i[0];
  wire clears = strobes[0] && ((index == kControl && !data[0]) || (index == kClear && data[0]));
  // What has no register may be either, and is not asked; behind the 64th word there is none.
  wire keyed = index < 10'd64 && kKeyed[index[5:0]], read_only = index >= 10'd64 || kReadOnly[index[5:0]];

  logic b_waited = 1'b0, r_waited = 1'b0;
  logic [1:0] b_was, r_was;
  logic [31:0] data_was;
  always @(posedge clk) begin
    if (taken_away != 0) taken_away <= taken_away + 1;
    if (takes) begin
      index <= axi_awaddr_i[11:2];
      data <= axi_wdata_i;
      strobes <= axi_wstrb_i;
      if (sets) begin
        configured <= 1'b1;
        taken_away <= 0;
      end
    end
    if (answers && clears && axi_bresp_o == 2'd0 && configured) taken_away <= 1;
    if (answers && index == kLock) unlocked <= ({{8{strobes[1]}}, {8{strobes[0]}}} & data[15:0]) == 16'hc0de;
    writing <= (writing && !answers) || takes;
    reading <= (reading && !tells) || asks;
    b_waited <= axi_bvalid_o && !axi_bready_i;
    r_waited <= axi_rvalid_o && !axi_rready_i;
    b_was <= axi_bresp_o;
    r_was <= axi_rresp_o;
    data_was <= axi_rdata_o;
    if (valid && !rst) begin
      if (takes && writing && !answers) fail("a write is taken before the last one is answered");
      if (asks && reading && !tells) fail("a read is taken before the last one is answered");
      if (axi_bvalid_o && !writing) fail("an answer without a write");
      if (axi_rvalid_o && !reading) fail("an answer without a read");
      if (b_waited && (!axi_bvalid_o || axi_bresp_o != b_was)) fail("a write's answer has changed before it was taken");
      if (r_waited && (!axi_rvalid_o || axi_rresp_o != r_was || axi_rdata_o != data_was)) fail("a read's answer has changed before it was taken");
      if (axi_bvalid_o && axi_bresp_o[0]) fail("a write's answer is neither 0 nor 2");
      if (axi_rvalid_o && axi_rresp_o[0]) fail("a read's answer is neither 0 nor 2");
      if (axi_bvalid_o && keyed && !unlocked && axi_bresp_o == 2'd0) fail("a keyed register was written behind the closed lock");
      if (axi_bvalid_o && read_only && axi_bresp_o == 2'd0) fail("a read-only register was written");
    end
    if (rst) begin
      {writing, reading, unlocked, configured, b_waited, r_waited} <= 6'd0;
      taken_away <= 0;
    end
  end
endmodule
