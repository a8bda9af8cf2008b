// six_step_axes: steplock::SixStepAxes<2>, printed by hlsgen from hls/bus/six_step_axes.hpp:26.
// Do not edit: change the C++ and print again.

module six_step_axes #(
    parameter logic WITH_HALL_DECODER = 1'b1,  // for Hall sensors, and to catch a rotor that turns
    parameter logic WITH_TELEMETRY = 1'b1  // its counters
) (
    input  logic        clk,
    input  logic        rst,  // synchronous, active high
    input  logic        pins_0_comparator_u_i,  // terminal U above the reference
    input  logic        pins_0_comparator_v_i,  // terminal V above the reference
    input  logic        pins_0_comparator_w_i,  // terminal W above the reference
    input  logic        pins_0_limit_i,  // shunt current above the limit
    input  logic        pins_0_fault_i,  // external fault, active high
    input  logic        pins_0_hall_u_i,  // Hall sensor U
    input  logic        pins_0_hall_v_i,  // Hall sensor V
    input  logic        pins_0_hall_w_i,  // Hall sensor W
    input  logic        pins_1_comparator_u_i,  // terminal U above the reference
    input  logic        pins_1_comparator_v_i,  // terminal V above the reference
    input  logic        pins_1_comparator_w_i,  // terminal W above the reference
    input  logic        pins_1_limit_i,  // shunt current above the limit
    input  logic        pins_1_fault_i,  // external fault, active high
    input  logic        pins_1_hall_u_i,  // Hall sensor U
    input  logic        pins_1_hall_v_i,  // Hall sensor V
    input  logic        pins_1_hall_w_i,  // Hall sensor W
    input  logic        axi_awvalid_i,
    input  logic [11:0] axi_awaddr_i,  // bytes; the lowest two bits do not count
    input  logic        axi_wvalid_i,
    input  logic [31:0] axi_wdata_i,
    input  logic [3:0]  axi_wstrb_i,
    input  logic        axi_bready_i,
    input  logic        axi_arvalid_i,
    input  logic [11:0] axi_araddr_i,  // bytes
    input  logic        axi_rready_i,
    output logic        axis_0_gates_uh_o,  // phase U, high side
    output logic        axis_0_gates_ul_o,  // phase U, low side
    output logic        axis_0_gates_vh_o,  // phase V, high side
    output logic        axis_0_gates_vl_o,  // phase V, low side
    output logic        axis_0_gates_wh_o,  // phase W, high side
    output logic        axis_0_gates_wl_o,  // phase W, low side
    output logic        axis_0_interrupt_o,  // level
    output logic        axis_0_locked_o,  // running under speed control
    output logic        axis_0_fault_o,  // the drive's fault is latched
    output logic        axis_1_gates_uh_o,  // phase U, high side
    output logic        axis_1_gates_ul_o,  // phase U, low side
    output logic        axis_1_gates_vh_o,  // phase V, high side
    output logic        axis_1_gates_vl_o,  // phase V, low side
    output logic        axis_1_gates_wh_o,  // phase W, high side
    output logic        axis_1_gates_wl_o,  // phase W, low side
    output logic        axis_1_interrupt_o,  // level
    output logic        axis_1_locked_o,  // running under speed control
    output logic        axis_1_fault_o,  // the drive's fault is latched
    output logic        axi_awready_o,
    output logic        axi_wready_o,
    output logic        axi_bvalid_o,
    output logic [1:0]  axi_bresp_o,  // 0 okay, 2 SLVERR
    output logic        axi_arready_o,
    output logic        axi_rvalid_o,
    output logic [31:0] axi_rdata_o,
    output logic [1:0]  axi_rresp_o
);
  logic [1:0] write_axis;  // whose answer is shown
  logic [1:0] read_axis;
  logic write_hole;  // there is none
  logic read_hole;
  logic read_capability;

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

  wire drives_0_gates_uh;
  wire drives_0_gates_ul;
  wire drives_0_gates_vh;
  wire drives_0_gates_vl;
  wire drives_0_gates_wh;
  wire drives_0_gates_wl;
  wire drives_0_interrupt;
  wire drives_0_locked;
  wire drives_0_fault;
  wire [31:0] drives_0_data;
  wire drives_0_read_error;
  wire drives_0_write_error;
  six_step_registered #(.WITH_HALL_DECODER(WITH_HALL_DECODER), .WITH_TELEMETRY(WITH_TELEMETRY)) drives_0 (
      .clk(clk),
      .rst(rst),
      .pins_comparator_u_i(pins_0_comparator_u_i),
      .pins_comparator_v_i(pins_0_comparator_v_i),
      .pins_comparator_w_i(pins_0_comparator_w_i),
      .pins_limit_i(pins_0_limit_i),
      .pins_fault_i(pins_0_fault_i),
      .pins_hall_u_i(pins_0_hall_u_i),
      .pins_hall_v_i(pins_0_hall_v_i),
      .pins_hall_w_i(pins_0_hall_w_i),
      .request_write_i(axi_request_write && axi_request_index[9:6] == 4'd0),
      .request_read_i(axi_request_read && axi_request_index[9:6] == 4'd0),
      .request_index_i({4'd0, axi_request_index[5:0]}),
      .request_data_i(axi_request_data),
      .request_strobes_i(axi_request_strobes),
      .gates_uh_o(drives_0_gates_uh),
      .gates_ul_o(drives_0_gates_ul),
      .gates_vh_o(drives_0_gates_vh),
      .gates_vl_o(drives_0_gates_vl),
      .gates_wh_o(drives_0_gates_wh),
      .gates_wl_o(drives_0_gates_wl),
      .interrupt_o(drives_0_interrupt),
      .locked_o(drives_0_locked),
      .fault_o(drives_0_fault),
      .data_o(drives_0_data),
      .read_error_o(drives_0_read_error),
      .write_error_o(drives_0_write_error)
  );

  wire drives_1_gates_uh;
  wire drives_1_gates_ul;
  wire drives_1_gates_vh;
  wire drives_1_gates_vl;
  wire drives_1_gates_wh;
  wire drives_1_gates_wl;
  wire drives_1_interrupt;
  wire drives_1_locked;
  wire drives_1_fault;
  wire [31:0] drives_1_data;
  wire drives_1_read_error;
  wire drives_1_write_error;
  six_step_registered #(.WITH_HALL_DECODER(WITH_HALL_DECODER), .WITH_TELEMETRY(WITH_TELEMETRY)) drives_1 (
      .clk(clk),
      .rst(rst),
      .pins_comparator_u_i(pins_1_comparator_u_i),
      .pins_comparator_v_i(pins_1_comparator_v_i),
      .pins_comparator_w_i(pins_1_comparator_w_i),
      .pins_limit_i(pins_1_limit_i),
      .pins_fault_i(pins_1_fault_i),
      .pins_hall_u_i(pins_1_hall_u_i),
      .pins_hall_v_i(pins_1_hall_v_i),
      .pins_hall_w_i(pins_1_hall_w_i),
      .request_write_i(axi_request_write && axi_request_index[9:6] == 4'd1),
      .request_read_i(axi_request_read && axi_request_index[9:6] == 4'd1),
      .request_index_i({4'd0, axi_request_index[5:0]}),
      .request_data_i(axi_request_data),
      .request_strobes_i(axi_request_strobes),
      .gates_uh_o(drives_1_gates_uh),
      .gates_ul_o(drives_1_gates_ul),
      .gates_vh_o(drives_1_gates_vh),
      .gates_vl_o(drives_1_gates_vl),
      .gates_wh_o(drives_1_gates_wh),
      .gates_wl_o(drives_1_gates_wl),
      .interrupt_o(drives_1_interrupt),
      .locked_o(drives_1_locked),
      .fault_o(drives_1_fault),
      .data_o(drives_1_data),
      .read_error_o(drives_1_read_error),
      .write_error_o(drives_1_write_error)
  );

  wire either_72 =  // line 72
      (write_axis == 2'd1 && drives_1_write_error) ||
      (write_axis == 2'd0 && drives_0_write_error) || write_hole;
  wire [31:0] out_axi_rdata =  // line 73
      (read_axis != 2'd0 || read_hole) ? 32'd0 :
      read_capability ? (drives_0_data & 32'hfff8ffff) | 32'h20000 :
      drives_0_data;
  wire both_73 = read_axis == 2'd0 && drives_0_read_error;  // line 73

  always_ff @(posedge clk) begin
    if (axi_request_write) begin
      write_axis <= axi_request_index[7:6];
      write_hole <= axi_request_index[9:7] != 3'd0;
    end
    if (axi_request_read) begin
      read_axis <= axi_request_index[7:6];
      read_hole <= axi_request_index[9:7] != 3'd0;
      read_capability <= axi_request_index[5:0] == 6'd2;
    end
    if (rst) begin
      write_axis <= 2'd0;
      read_axis <= 2'd0;
      write_hole <= 1'b0;
      read_hole <= 1'b0;
      read_capability <= 1'b0;
    end
  end

  assign axis_0_gates_uh_o = drives_0_gates_uh;
  assign axis_0_gates_ul_o = drives_0_gates_ul;
  assign axis_0_gates_vh_o = drives_0_gates_vh;
  assign axis_0_gates_vl_o = drives_0_gates_vl;
  assign axis_0_gates_wh_o = drives_0_gates_wh;
  assign axis_0_gates_wl_o = drives_0_gates_wl;
  assign axis_0_interrupt_o = drives_0_interrupt;
  assign axis_0_locked_o = drives_0_locked;
  assign axis_0_fault_o = drives_0_fault;
  assign axis_1_gates_uh_o = drives_1_gates_uh;
  assign axis_1_gates_ul_o = drives_1_gates_ul;
  assign axis_1_gates_vh_o = drives_1_gates_vh;
  assign axis_1_gates_vl_o = drives_1_gates_vl;
  assign axis_1_gates_wh_o = drives_1_gates_wh;
  assign axis_1_gates_wl_o = drives_1_gates_wl;
  assign axis_1_interrupt_o = drives_1_interrupt;
  assign axis_1_locked_o = drives_1_locked;
  assign axis_1_fault_o = drives_1_fault;
  assign axi_awready_o = axi_awready;
  assign axi_wready_o = axi_wready;
  assign axi_bvalid_o = axi_bvalid;
  assign axi_bresp_o = either_72 ? 2'd2 : 2'd0;
  assign axi_arready_o = axi_arready;
  assign axi_rvalid_o = axi_rvalid;
  assign axi_rdata_o =
      (read_axis != 2'd1 || read_hole) ? out_axi_rdata :
      read_capability ? (drives_1_data & 32'hfff8ffff) | 32'h20000 :
      drives_1_data;
  assign axi_rresp_o =
      read_hole ? 2'd2 :
      (read_axis == 2'd1) ? ((drives_1_read_error || both_73) ? 2'd2 : 2'd0) :
      both_73 ? 2'd2 :
      2'd0;
endmodule
