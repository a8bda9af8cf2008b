// six_step_spi with its host, in place of hosted_drive.sv: the same module, so every bench runs on either bus.
//
// Doc: docs/integration.md   Test: tests/rtl/bench.sh

`timescale 1ns / 1ps

module hosted_drive #(
    // With it the drive first looks whether its rotor spins.
    parameter logic WITH_HALL_DECODER = 1'b0
) (
    input  logic       clk,
    input  logic       rst,
    input  logic [2:0] comparator,  // U, V, W
    input  logic       limit,
    input  logic       fault,
    output logic [2:0] high,  // gates U, V, W
    output logic [2:0] low,
    output logic       locked,
    output logic       latched
);
  wire cs_n, sclk, mosi, miso, selected, interrupt;

  six_step_spi #(.WITH_HALL_DECODER(WITH_HALL_DECODER)) dut (
      .clk(clk), .rst(rst), .clock_khz_i(20'd24_000),
      .pins_comparator_u_i(comparator[0]), .pins_comparator_v_i(comparator[1]), .pins_comparator_w_i(comparator[2]),
      .pins_limit_i(limit), .pins_fault_i(fault),
      .pins_hall_u_i(1'b0), .pins_hall_v_i(1'b0), .pins_hall_w_i(1'b0),
      .spi_cs_n_i(cs_n), .spi_sclk_i(sclk), .spi_mosi_i(mosi), .spi_miso_o(miso), .spi_selected_o(selected),
      .gates_uh_o(high[0]), .gates_ul_o(low[0]), .gates_vh_o(high[1]), .gates_vl_o(low[1]), .gates_wh_o(high[2]), .gates_wl_o(low[2]),
      .interrupt_o(interrupt), .locked_o(locked), .fault_o(latched)
  );
  spi_host host (.clk(clk), .cs_n(cs_n), .sclk(sclk), .mosi(mosi), .miso(miso));
endmodule
