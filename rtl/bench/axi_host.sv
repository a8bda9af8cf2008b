// A host on AXI4-Lite for a testbench: `read`, `write`, and what host_tasks.svh makes of them, `configure` first of all.
// Hierarchical calls: host.write(12'h00c, 32'd1).  Tried in Icarus (-g2012) and Verilator (--binary --timing); no C++.
//
// Doc: docs/integration.md   Test: tests/rtl/bench.sh

`timescale 1ns / 1ps

module axi_host (
    input  logic        clk,
    output logic        awvalid,
    output logic [11:0] awaddr,
    input  logic        awready,
    output logic        wvalid,
    output logic [31:0] wdata,
    output logic [3:0]  wstrb,
    input  logic        wready,
    input  logic        bvalid,
    input  logic [1:0]  bresp,
    output logic        bready,
    output logic        arvalid,
    output logic [11:0] araddr,
    input  logic        arready,
    input  logic        rvalid,
    input  logic [31:0] rdata,
    input  logic [1:0]  rresp,
    output logic        rready
);
  logic refused = 1'b0;  // the last access was answered with an error

  // What the last rising edge took.  Outputs change at falling edges: so no simulator can take one for the other.
  logic aw_taken, w_taken, b_taken, ar_taken, r_taken;
  logic [1:0] answer;
  logic [31:0] data;
  always @(posedge clk) begin
    aw_taken <= awvalid && awready;
    w_taken <= wvalid && wready;
    b_taken <= bvalid && bready;
    ar_taken <= arvalid && arready;
    r_taken <= rvalid && rready;
    answer <= bvalid ? bresp : rresp;
    data <= rdata;
  end

  initial begin
    {awvalid, wvalid, bready, arvalid, rready} = 5'b0;
    awaddr = 12'd0;
    wdata = 32'd0;
    wstrb = 4'hf;
    araddr = 12'd0;
  end

  task automatic write(input logic [11:0] address, input logic [31:0] value);
    @(negedge clk);
    awaddr = address;
    wdata = value;
    {awvalid, wvalid, bready} = 3'b111;
    do begin
      @(negedge clk);
      if (aw_taken) awvalid = 1'b0;
      if (w_taken) wvalid = 1'b0;
    end while (!b_taken);
    refused = answer != 2'd0;
    bready = 1'b0;
  endtask

  task automatic read(input logic [11:0] address, output logic [31:0] value);
    @(negedge clk);
    araddr = address;
    {arvalid, rready} = 2'b11;
    do begin
      @(negedge clk);
      if (ar_taken) arvalid = 1'b0;
    end while (!r_taken);
    value = data;
    refused = answer != 2'd0;
    rready = 1'b0;
  endtask

  `include "host_tasks.svh"
endmodule
