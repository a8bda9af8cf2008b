// A host on AXI4-Lite for a testbench: `read`, `write`, and `configure`.
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
  localparam logic [11:0] kControl = 12'h00c, kStatus = 12'h010, kLock = 12'h020;
  localparam logic [31:0] kLockKey = 32'h0000_c0de, kStopped = 32'h0000_0800;

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

  // Looks at STATUS every so many clocks until the drive has stopped, or so often.
  task automatic until_stopped(input int every, input int most, output int looks);
    logic [31:0] value;
    looks = 0;
    do begin
      repeat (every) @(negedge clk);
      looks = looks + 1;
      read(kStatus, value);
    end while ((value & kStopped) == 0 && looks < most);
  endtask

  // The words of rtl/words/NAME.mem behind the lock, each read back, then CONTROL.configured.  `errors`: words that are not kept.
  // A file that is not there leaves `count` 0.
  localparam int kWords = 256;
  localparam logic [63:0] kNone = 64'hffff_ffff_ffff_ffff;
  logic [63:0] words[0:kWords-1];
  task automatic load(input string file);
    for (int i = 0; i < kWords; ++i) words[i] = kNone;
    $readmemh(file, words);
  endtask
  task automatic configure(input string file, output int errors, output int count);
    load(file);
    write_words(errors, count);
  endtask
  // What `load` has read; or what is left of it.
  task automatic write_words(output int errors, output int count);
    logic [31:0] value;
    errors = 0;
    count = 0;
    read(kStatus, value);
    if ((value & kStopped) == 0) errors = 1;  // what is refused below counts, too
    write(kControl, 32'd0);
    write(kLock, kLockKey);
    for (int i = 0; i < kWords; ++i) begin
      if (words[i] != kNone) begin
        count = count + 1;
        write(words[i][43:32], words[i][31:0]);
        if (refused) errors = errors + 1;
        read(words[i][43:32], value);
        if (value != words[i][31:0]) errors = errors + 1;
      end
    end
    write(kLock, 32'd0);
    write(kControl, 32'd1);
    if (refused) errors = errors + 1;
  endtask
endmodule
