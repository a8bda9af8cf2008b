// A host on AXI4-Lite for a testbench: `read`, `write`, and `configure`.
// Hierarchical calls: host.write(12'h00c, 32'd1).  Tried in Icarus (-g2012); no C++.
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
  localparam logic [11:0] kControl = 12'h00c, kStatus = 12'h010, kLock = 12'h020;
  localparam logic [31:0] kLockKey = 32'h0000_c0de, kStopped = 32'h0000_0800;

  logic refused = 1'b0;  // the last access was answered with an error

  initial begin
    {awvalid, wvalid, bready, arvalid, rready} = 5'b0;
    awaddr = 12'd0;
    wdata = 32'd0;
    wstrb = 4'hf;
    araddr = 12'd0;
  end

  task automatic write(input logic [11:0] address, input logic [31:0] value);
    awaddr <= address;
    wdata <= value;
    {awvalid, wvalid, bready} <= 3'b111;
    do begin
      @(posedge clk);
      if (awready) awvalid <= 1'b0;
      if (wready) wvalid <= 1'b0;
    end while (!bvalid);
    refused = bresp != 2'd0;
    {awvalid, wvalid, bready} <= 3'b000;
    @(posedge clk);
  endtask

  task automatic read(input logic [11:0] address, output logic [31:0] value);
    araddr <= address;
    {arvalid, rready} <= 2'b11;
    do begin
      @(posedge clk);
      if (arready) arvalid <= 1'b0;
    end while (!rvalid);
    value = rdata;
    refused = rresp != 2'd0;
    {arvalid, rready} <= 2'b00;
    @(posedge clk);
  endtask

  // The words of rtl/words/NAME.mem behind the lock, each read back, then CONTROL.configured.  `errors`: words that are not kept.
  localparam int kWords = 256;
  logic [63:0] words[0:kWords-1];
  task automatic configure(output int errors, output int count);
    logic [31:0] value;
    errors = 0;
    count = 0;
    read(kStatus, value);
    if ((value & kStopped) == 0) errors = 1;  // what is refused below counts, too
    write(kControl, 32'd0);
    write(kLock, kLockKey);
    for (int i = 0; i < kWords; ++i) begin
      if (words[i] !== 64'hx) begin
        count = count + 1;
        write(words[i][43:32], words[i][31:0]);
        if (refused) errors = errors + 1;
        read(words[i][43:32], value);
        if (value !== words[i][31:0]) errors = errors + 1;
      end
    end
    write(kLock, 32'd0);
    write(kControl, 32'd1);
    if (refused) errors = errors + 1;
  endtask
endmodule
