// What sinusoidal_axi promises, seen at its ports alone: bind it in your own testbench, or instantiate it beside the drive.
//
//     bind sinusoidal_axi sinusoidal_axi_properties properties (.*);
//
// The promises are those of drive_properties.sv.
//
// Doc: docs/integration.md   Test: tests/rtl/properties.sh

`timescale 1ns / 1ps

module sinusoidal_axi_properties #(
    parameter int FLOOR = 12  // CAPABILITY.dead_time_floor
) (
    input logic        clk, rst,
    input logic        fault_i,
    input logic        axi_awvalid_i, axi_awready_o, axi_wvalid_i, axi_wready_o, axi_bvalid_o, axi_bready_i,
    input logic        axi_arvalid_i, axi_arready_o, axi_rvalid_o, axi_rready_i,
    input logic [11:0] axi_awaddr_i,
    input logic [31:0] axi_wdata_i, axi_rdata_o,
    input logic [3:0]  axi_wstrb_i,
    input logic [1:0]  axi_bresp_o, axi_rresp_o,
    input logic        gates_uh_o, gates_ul_o, gates_vh_o, gates_vl_o, gates_wh_o, gates_wl_o,
    input logic        locked_o, fault_o
);
  // A bit for each word of the register map, address / 4.
  localparam logic [63:0] kKeyed = 64'h3c00_0002_0000_0200;
  localparam logic [63:0] kReadOnly = 64'hc000_0000_0001_f017;
  drive_properties #(.FLOOR(FLOOR), .KEYED(kKeyed), .READ_ONLY(kReadOnly)) promises (
      .clk(clk), .rst(rst), .fault_pin(fault_i),
      .awvalid(axi_awvalid_i), .awready(axi_awready_o), .wvalid(axi_wvalid_i), .wready(axi_wready_o), .bvalid(axi_bvalid_o), .bready(axi_bready_i),
      .arvalid(axi_arvalid_i), .arready(axi_arready_o), .rvalid(axi_rvalid_o), .rready(axi_rready_i),
      .awaddr(axi_awaddr_i), .wdata(axi_wdata_i), .rdata(axi_rdata_o), .wstrb(axi_wstrb_i), .bresp(axi_bresp_o), .rresp(axi_rresp_o),
      .high({gates_wh_o, gates_vh_o, gates_uh_o}), .low({gates_wl_o, gates_vl_o, gates_ul_o}), .locked(locked_o), .latched(fault_o)
  );
endmodule
