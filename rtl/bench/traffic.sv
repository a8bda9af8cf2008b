// A host that first configures a drive and lets it run, and then writes and reads whatever it likes; a reset now and then, some of them
// while a gate is on.  The benches of random traffic are this with a drive, its pins and its promises.
//
//     traffic.play     the whole; it prints how often what it is about has happened, and PASSED, or FAILED and why
//
// A run in which something never happened fails.  Its ports have the names of the drive's, so that a bench joins both by `.*`.
//
// Doc: docs/integration.md   Test: tests/rtl/properties.sh

`timescale 1ns / 1ps

module traffic #(
    parameter int WRITES = 40  // clocks between two of the host's, on the average
) (
    input  logic        clk,
    output logic        rst,
    output logic        random,  // the host, and the pins likewise, do what they like
    input  logic        gates_uh_o, gates_ul_o, gates_vh_o, gates_vl_o, gates_wh_o, gates_wl_o,
    input  logic        fault_o,
    output logic        axi_awvalid_i, axi_wvalid_i, axi_bready_i, axi_arvalid_i, axi_rready_i,
    output logic [11:0] axi_awaddr_i, axi_araddr_i,
    output logic [31:0] axi_wdata_i,
    output logic [3:0]  axi_wstrb_i,
    input  logic        axi_awready_o, axi_wready_o, axi_bvalid_o, axi_arready_o, axi_rvalid_o,
    input  logic [31:0] axi_rdata_o,
    input  logic [1:0]  axi_bresp_o, axi_rresp_o
);
  initial {rst, random} = 2'b10;
  wire [5:0] gates = {gates_uh_o, gates_ul_o, gates_vh_o, gates_vl_o, gates_wh_o, gates_wl_o};

  // The host's own accesses, which configure the drive; or random ones.
  wire h_awvalid, h_wvalid, h_bready, h_arvalid, h_rready;
  wire [11:0] h_awaddr, h_araddr;
  wire [31:0] h_wdata;
  wire [3:0] h_wstrb;
  logic r_awvalid = 1'b0, r_wvalid = 1'b0, r_bready = 1'b0, r_arvalid = 1'b0, r_rready = 1'b0;
  logic [11:0] r_awaddr = 12'd0, r_araddr = 12'd0;
  logic [31:0] r_wdata = 32'd0;
  logic [3:0] r_wstrb = 4'd0;
  assign axi_awvalid_i = random ? r_awvalid : h_awvalid, axi_wvalid_i = random ? r_wvalid : h_wvalid, axi_bready_i = random ? r_bready : h_bready;
  assign axi_arvalid_i = random ? r_arvalid : h_arvalid, axi_rready_i = random ? r_rready : h_rready;
  assign axi_awaddr_i = random ? r_awaddr : h_awaddr, axi_araddr_i = random ? r_araddr : h_araddr;
  assign axi_wdata_i = random ? r_wdata : h_wdata;
  assign axi_wstrb_i = random ? r_wstrb : h_wstrb;
  axi_host host (
      .clk(clk), .awvalid(h_awvalid), .awaddr(h_awaddr), .awready(axi_awready_o), .wvalid(h_wvalid), .wdata(h_wdata), .wstrb(h_wstrb),
      .wready(axi_wready_o), .bvalid(axi_bvalid_o), .bresp(axi_bresp_o), .bready(h_bready), .arvalid(h_arvalid), .araddr(h_araddr),
      .arready(axi_arready_o), .rvalid(axi_rvalid_o), .rdata(axi_rdata_o), .rresp(axi_rresp_o), .rready(h_rready)
  );
  dice dice ();

  task automatic fail(input string what);
    $display("FAILED: %0t: %s", $time, what);
    $fatal(1);
  endtask

  // Mostly what starts a drive, stops it, opens its lock or clears its fault; else any register.
  function automatic logic [11:0] address;
    int which, register;
    which = dice.draw(16);
    register = dice.draw(which == 9 ? 1024 : 64);
    case (which)
      0, 1, 2: return 12'h00c;
      3, 4: return 12'h014;
      5: return 12'h020;
      6: return 12'h044;
      7: return 12'h048;
      8: return 12'h0cc;
      default: return 12'(4 * register);
    endcase
  endfunction
  function automatic logic [31:0] value(input logic [11:0] of);
    logic [31:0] any, few;
    any = dice.bits();
    few = 32'(dice.draw(12));
    case (of)
      12'h00c: return few == 32'd0 ? any : few < 32'd10 ? {29'd0, any[7], 2'b11} : 32'd1;
      12'h014: return 32'd3;
      12'h020: return few < 32'd6 ? 32'h0000_c0de : any;
      12'h044: return 32'd3;
      12'h048: return few < 32'd4 ? 32'd1 : 32'd2;
      12'h024: return few;
      default: return any & {any[15:0], any[31:16]};
    endcase
  endfunction

  // Outputs change at falling edges, as the host's do; a valid stays until it was taken.
  logic aw_taken, ar_taken;
  always @(posedge clk) begin
    aw_taken <= axi_awvalid_i && axi_awready_o;
    ar_taken <= axi_arvalid_i && axi_arready_o;
  end
  string file;
  int errors, count;
  // Reset, whatever was going on; then configured, and told to run.
  task automatic begin_again;
    random = 1'b0;
    rst = 1'b1;
    {r_awvalid, r_wvalid, r_arvalid, r_bready, r_rready} = 5'd0;
    repeat (4) @(negedge clk);
    rst = 1'b0;
    repeat (4) @(negedge clk);
    host.configure(file, errors, count);
    if (count == 0 || errors != 0) fail("the words are not kept");
    host.write(12'h00c, 32'd3);  // CONTROL: configured, run
  endtask
  task automatic access;
    int writes, follows, reads;
    writes = dice.draw(WRITES);
    follows = dice.draw(3);
    reads = dice.draw(20);
    if (aw_taken) {r_awvalid, r_wvalid} = 2'd0;
    if (ar_taken) r_arvalid = 1'b0;
    if (!r_awvalid && !r_wvalid && writes == 0) begin
      r_awaddr = address();
      r_wdata = value(r_awaddr);
      r_wstrb = 4'hf;
      if (dice.draw(4) == 0) r_wstrb = 4'(dice.draw(16));
      r_awvalid = 1'b1;
    end
    if (r_awvalid && !r_wvalid && follows == 0) r_wvalid = 1'b1;
    if (!r_arvalid && reads == 0) begin
      r_araddr = address();
      r_arvalid = 1'b1;
    end
    r_bready = dice.draw(3) == 0;
    r_rready = dice.draw(3) == 0;
  endtask

  int drives = 0, faults = 0, refused = 0, answered = 0, resets = 0;
  logic was_latched = 1'b0;
  always @(posedge clk) begin
    if (gates != 6'd0) drives <= drives + 1;
    was_latched <= fault_o;
    if (fault_o && !was_latched) faults <= faults + 1;
    if (random && axi_bvalid_o && axi_bready_i) begin
      answered <= answered + 1;
      if (axi_bresp_o != 2'd0) refused <= refused + 1;
    end
  end

  int clocks = 200_000, wait_for;
  task automatic play;
    if (!$value$plusargs("config=%s", file)) fail("no +config=FILE.mem");
    count = $value$plusargs("clocks=%d", clocks);
    for (int done = 0; done < clocks; done += 40_000) begin
      begin_again;
      wait_for = 60_000;
      while (wait_for > 0 && !(wait_for < 30_000 && gates != 6'd0)) begin
        @(negedge clk);
        wait_for = wait_for - 1;
      end
      if (gates != 6'd0) resets = resets + 1;
      begin_again;
      repeat (30_000) @(negedge clk);
      random = 1'b1;
      repeat (40_000) @(negedge clk) access;
    end
    $display("%0d clocks of traffic: a gate was on in %0d, %0d faults, %0d resets while one was, %0d writes, %0d of them refused", clocks, drives, faults, resets,
             answered, refused);
    if (drives == 0 || faults == 0 || resets == 0 || answered == 0 || refused == 0) fail("something never happened");
    $display("PASSED");
    $finish;
  endtask
endmodule
