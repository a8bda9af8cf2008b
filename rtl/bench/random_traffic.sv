// Random traffic for six_step_axi: a host that does what it likes, and comparators, current limit, Hall sensors and fault pin that do so,
// while drive_properties looks on.
//
//     tools/bench verilator random_traffic [+clocks=200000] [+seed=1]
//
// Doc: docs/integration.md   Test: tests/rtl/properties.sh

`timescale 1ns / 1ps

module random_traffic #(
    // With it the drive first looks whether its rotor spins, and its gates are on for less of the time.
    parameter logic WITH_HALL_DECODER = 1'b0
);
  logic clk = 1'b0;
  always #20 clk = ~clk;

  logic [2:0] comparator = 3'd0, hall = 3'd0;
  logic limit = 1'b0, fault = 1'b0;
  // All by the names of the drive's ports.
  wire rst, random, axi_awvalid_i, axi_awready_o, axi_wvalid_i, axi_wready_o, axi_bvalid_o, axi_bready_i;
  wire axi_arvalid_i, axi_arready_o, axi_rvalid_o, axi_rready_i, interrupt_o, locked_o, fault_o;
  wire [11:0] axi_awaddr_i, axi_araddr_i;
  wire [31:0] axi_wdata_i, axi_rdata_o;
  wire [3:0] axi_wstrb_i;
  wire [1:0] axi_bresp_o, axi_rresp_o;
  wire gates_uh_o, gates_ul_o, gates_vh_o, gates_vl_o, gates_wh_o, gates_wl_o;
  traffic traffic (.*);
  six_step_axi #(.WITH_HALL_DECODER(WITH_HALL_DECODER)) dut (
      .*, .clock_khz_i(20'd24_000),
      .pins_comparator_u_i(comparator[0]), .pins_comparator_v_i(comparator[1]), .pins_comparator_w_i(comparator[2]),
      .pins_limit_i(limit), .pins_fault_i(fault),
      .pins_hall_u_i(hall[0]), .pins_hall_v_i(hall[1]), .pins_hall_w_i(hall[2])
  );
  drive_properties properties (.*, .fault_pin(fault));

  // Between the edges, at which the host moves, so that every simulator sees the same.
  dice #(.SALT(1)) dice ();
  always @(posedge clk) begin
    #5;
    if (dice.draw(200) == 0) comparator = 3'(dice.draw(8));
    if (dice.draw(2000) == 0) hall = 3'(dice.draw(8));
    limit = dice.now_and_then(limit, 400, 20);
    fault = dice.now_and_then(fault, 8000, 10);
    if (!random || rst) {limit, fault} = 2'd0;
  end
  initial traffic.play;
endmodule
