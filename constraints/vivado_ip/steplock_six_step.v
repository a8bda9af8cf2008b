// six_step_axi under the port names by which Vivado knows an AXI4-Lite slave, an interrupt and a reset; plain
// Verilog, as its IP packager asks of a top.  AxPROT is taken and not looked at.
//
// Doc: docs/boards.md   Registers: docs/six_step_registers.md   Test: tests/boards/CMakeLists.txt

module steplock_six_step #(
    parameter integer CLOCK_KHZ = 0  // of s_axi_aclk, for the register CLOCK; 0: not told
) (
    input         s_axi_aclk,
    input         s_axi_aresetn,
    input  [11:0] s_axi_awaddr,
    input  [2:0]  s_axi_awprot,
    input         s_axi_awvalid,
    output        s_axi_awready,
    input  [31:0] s_axi_wdata,
    input  [3:0]  s_axi_wstrb,
    input         s_axi_wvalid,
    output        s_axi_wready,
    output [1:0]  s_axi_bresp,
    output        s_axi_bvalid,
    input         s_axi_bready,
    input  [11:0] s_axi_araddr,
    input  [2:0]  s_axi_arprot,
    input         s_axi_arvalid,
    output        s_axi_arready,
    output [31:0] s_axi_rdata,
    output [1:0]  s_axi_rresp,
    output        s_axi_rvalid,
    input         s_axi_rready,
    output        irq,            // high while an enabled event is pending
    input         comparator_u,
    input         comparator_v,
    input         comparator_w,
    input         limit,
    input         fault_n,        // of the gate driver: open drain, low on fault
    input         hall_u,
    input         hall_v,
    input         hall_w,
    output        gate_uh,
    output        gate_ul,
    output        gate_vh,
    output        gate_vl,
    output        gate_wh,
    output        gate_wl,
    output        locked,
    output        fault
);
  six_step_axi drive (
      .clk(s_axi_aclk), .rst(!s_axi_aresetn), .clock_khz_i(CLOCK_KHZ[19:0]),
      .pins_comparator_u_i(comparator_u), .pins_comparator_v_i(comparator_v),
      .pins_comparator_w_i(comparator_w), .pins_limit_i(limit), .pins_fault_i(!fault_n),
      .pins_hall_u_i(hall_u), .pins_hall_v_i(hall_v), .pins_hall_w_i(hall_w),
      .axi_awvalid_i(s_axi_awvalid), .axi_awaddr_i(s_axi_awaddr), .axi_awready_o(s_axi_awready),
      .axi_wvalid_i(s_axi_wvalid), .axi_wdata_i(s_axi_wdata), .axi_wstrb_i(s_axi_wstrb),
      .axi_wready_o(s_axi_wready),
      .axi_bvalid_o(s_axi_bvalid), .axi_bresp_o(s_axi_bresp), .axi_bready_i(s_axi_bready),
      .axi_arvalid_i(s_axi_arvalid), .axi_araddr_i(s_axi_araddr), .axi_arready_o(s_axi_arready),
      .axi_rvalid_o(s_axi_rvalid), .axi_rdata_o(s_axi_rdata), .axi_rresp_o(s_axi_rresp),
      .axi_rready_i(s_axi_rready),
      .gates_uh_o(gate_uh), .gates_ul_o(gate_ul), .gates_vh_o(gate_vh),
      .gates_vl_o(gate_vl), .gates_wh_o(gate_wh), .gates_wl_o(gate_wl),
      .interrupt_o(irq), .locked_o(locked), .fault_o(fault)
  );

  wire unused = &{1'b0, s_axi_awprot, s_axi_arprot};
endmodule
