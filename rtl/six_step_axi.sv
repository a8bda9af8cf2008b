// six_step_axi: steplock::SixStepAxi, printed by hlsgen from hls/bus/six_step_axi.hpp:19.
// Do not edit: change the C++ and print again.

module six_step_axi #(
    parameter logic WITH_HALL_DECODER = 1'b1,  // for Hall sensors, and to catch a rotor that turns
    parameter logic WITH_TELEMETRY = 1'b1  // its counters
) (
    input  logic        clk,
    input  logic        rst,  // synchronous, active high
    input  logic        pins_comparator_u_i,  // terminal U above the reference
    input  logic        pins_comparator_v_i,  // terminal V above the reference
    input  logic        pins_comparator_w_i,  // terminal W above the reference
    input  logic        pins_limit_i,  // shunt current above the limit
    input  logic        pins_fault_i,  // external fault, active high
    input  logic        pins_hall_u_i,  // Hall sensor U
    input  logic        pins_hall_v_i,  // Hall sensor V
    input  logic        pins_hall_w_i,  // Hall sensor W
    input  logic        axi_awvalid_i,
    input  logic [11:0] axi_awaddr_i,  // bytes; the lowest two bits do not count
    input  logic        axi_wvalid_i,
    input  logic [31:0] axi_wdata_i,
    input  logic [3:0]  axi_wstrb_i,
    input  logic        axi_bready_i,
    input  logic        axi_arvalid_i,
    input  logic [11:0] axi_araddr_i,  // bytes
    input  logic        axi_rready_i,
    output logic        gates_uh_o,  // phase U, high side
    output logic        gates_ul_o,  // phase U, low side
    output logic        gates_vh_o,  // phase V, high side
    output logic        gates_vl_o,  // phase V, low side
    output logic        gates_wh_o,  // phase W, high side
    output logic        gates_wl_o,  // phase W, low side
    output logic        interrupt_o,  // level
    output logic        locked_o,  // running under speed control
    output logic        fault_o,  // the drive's fault is latched
    output logic        axi_awready_o,
    output logic        axi_wready_o,
    output logic        axi_bvalid_o,
    output logic [1:0]  axi_bresp_o,  // 0 okay, 2 SLVERR
    output logic        axi_arready_o,
    output logic        axi_rvalid_o,
    output logic [31:0] axi_rdata_o,
    output logic [1:0]  axi_rresp_o
);
  wire axi_awready;
  wire axi_wready;
  wire axi_bvalid;
  wire axi_arready;
  wire axi_rvalid;
  wire axi_request_write;
  wire axi_request_read;
  wire [9:0] axi_request_index;
  wire [31:0] axi_request_data;
  wire [3:0] axi_request_strobes;
  axi_lite axi (
      .clk(clk),
      .rst(rst),
      .awvalid_i(axi_awvalid_i),
      .awaddr_i(axi_awaddr_i),
      .wvalid_i(axi_wvalid_i),
      .wdata_i(axi_wdata_i),
      .wstrb_i(axi_wstrb_i),
      .bready_i(axi_bready_i),
      .arvalid_i(axi_arvalid_i),
      .araddr_i(axi_araddr_i),
      .rready_i(axi_rready_i),
      .awready_o(axi_awready),
      .wready_o(axi_wready),
      .bvalid_o(axi_bvalid),
      .arready_o(axi_arready),
      .rvalid_o(axi_rvalid),
      .request_write_o(axi_request_write),
      .request_read_o(axi_request_read),
      .request_index_o(axi_request_index),
      .request_data_o(axi_request_data),
      .request_strobes_o(axi_request_strobes)
  );

  wire drive_gates_uh;
  wire drive_gates_ul;
  wire drive_gates_vh;
  wire drive_gates_vl;
  wire drive_gates_wh;
  wire drive_gates_wl;
  wire drive_interrupt;
  wire drive_locked;
  wire drive_fault;
  wire [31:0] drive_data;
  wire drive_read_error;
  wire drive_write_error;
  six_step_registered #(.WITH_HALL_DECODER(WITH_HALL_DECODER), .WITH_TELEMETRY(WITH_TELEMETRY)) drive (
      .clk(clk),
      .rst(rst),
      .pins_comparator_u_i(pins_comparator_u_i),
      .pins_comparator_v_i(pins_comparator_v_i),
      .pins_comparator_w_i(pins_comparator_w_i),
      .pins_limit_i(pins_limit_i),
      .pins_fault_i(pins_fault_i),
      .pins_hall_u_i(pins_hall_u_i),
      .pins_hall_v_i(pins_hall_v_i),
      .pins_hall_w_i(pins_hall_w_i),
      .request_write_i(axi_request_write),
      .request_read_i(axi_request_read),
      .request_index_i(axi_request_index),
      .request_data_i(axi_request_data),
      .request_strobes_i(axi_request_strobes),
      .gates_uh_o(drive_gates_uh),
      .gates_ul_o(drive_gates_ul),
      .gates_vh_o(drive_gates_vh),
      .gates_vl_o(drive_gates_vl),
      .gates_wh_o(drive_gates_wh),
      .gates_wl_o(drive_gates_wl),
      .interrupt_o(drive_interrupt),
      .locked_o(drive_locked),
      .fault_o(drive_fault),
      .data_o(drive_data),
      .read_error_o(drive_read_error),
      .write_error_o(drive_write_error)
  );

  assign gates_uh_o = drive_gates_uh;
  assign gates_ul_o = drive_gates_ul;
  assign gates_vh_o = drive_gates_vh;
  assign gates_vl_o = drive_gates_vl;
  assign gates_wh_o = drive_gates_wh;
  assign gates_wl_o = drive_gates_wl;
  assign interrupt_o = drive_interrupt;
  assign locked_o = drive_locked;
  assign fault_o = drive_fault;
  assign axi_awready_o = axi_awready;
  assign axi_wready_o = axi_wready;
  assign axi_bvalid_o = axi_bvalid;
  assign axi_bresp_o = drive_write_error ? 2'd2 : 2'd0;
  assign axi_arready_o = axi_arready;
  assign axi_rvalid_o = axi_rvalid;
  assign axi_rdata_o = drive_data;
  assign axi_rresp_o = drive_read_error ? 2'd2 : 2'd0;
endmodule
