// A host on SPI, mode 0, for a testbench: `read`, `write`, and what host_tasks.svh makes of them, `configure` first of all.
// Hierarchical calls: host.write(12'h00c, 32'd1).  Tried in Icarus (-g2012) and Verilator (--binary --timing); no C++.
//
//     write    1 000 aaaaaaaaaaaa   32 bits of data   -> 8 bits of status
//     read     0 000 aaaaaaaaaaaa   -> 8 bits of status, 32 bits of data
//
// Doc: docs/blocks/spi.md   Test: tests/rtl/bench.sh

`timescale 1ns / 1ps

module spi_host #(
    parameter int HALF = 4  // clocks of SCLK high, and low; the drive takes no fewer
) (
    input  logic clk,
    output logic cs_n,
    output logic sclk,
    output logic mosi,
    input  logic miso
);
  localparam logic [7:0] kDone = 8'h5a;  // 8'h5e: refused, or no register; else no drive that answers
  logic refused = 1'b0;                  // the last access was answered with an error, or not at all
  initial {cs_n, sclk, mosi} = 3'b100;

  // Highest bit first.  MISO is taken as SCLK rises, half a bit after it changed.
  task automatic frame(input logic [55:0] out, output logic [55:0] back);
    @(negedge clk) cs_n = 1'b0;
    repeat (HALF) @(negedge clk);
    for (int k = 55; k >= 0; k--) begin
      mosi = out[k];
      repeat (HALF) @(negedge clk);
      back[k] = miso;
      sclk = 1'b1;
      repeat (HALF) @(negedge clk);
      sclk = 1'b0;
    end
    repeat (HALF) @(negedge clk);
    cs_n = 1'b1;
    repeat (HALF) @(negedge clk);
  endtask

  task automatic write(input logic [11:0] address, input logic [31:0] value);
    logic [55:0] back;
    frame({4'b1000, address, value, 8'd0}, back);
    refused = back[7:0] !== kDone;
  endtask

  task automatic read(input logic [11:0] address, output logic [31:0] value);
    logic [55:0] back;
    frame({4'b0000, address, 40'd0}, back);
    refused = back[39:32] !== kDone;
    value = back[31:0];
  endtask

  `include "host_tasks.svh"
endmodule
