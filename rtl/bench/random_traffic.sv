// Random traffic for six_step_axi: a host that writes and reads whatever it likes, comparators, current limit and fault pin that do
// what they like, and a reset now and then, while six_step_axi_properties looks on.
//
//     tools/bench verilator random_traffic [+clocks=200000] [+seed=1]
//
// It prints how often what it is about has happened, and PASSED; or FAILED and why.  A run in which something never happened fails.
//
// Doc: docs/integration.md   Test: tests/rtl/properties.sh

`timescale 1ns / 1ps

module random_traffic #(
    // With it the drive first observes whether its rotor turns, and its gates are on for less of the time.
    parameter logic WITH_HALL_DECODER = 1'b0
);
  logic clk = 1'b0, rst = 1'b1;
  always #20 clk = ~clk;

  // The host's own accesses, which configure the drive; or random ones.
  logic random = 1'b0;
  wire h_awvalid, h_wvalid, h_bready, h_arvalid, h_rready;
  wire [11:0] h_awaddr, h_araddr;
  wire [31:0] h_wdata;
  wire [3:0] h_wstrb;
  logic r_awvalid = 1'b0, r_wvalid = 1'b0, r_bready = 1'b0, r_arvalid = 1'b0, r_rready = 1'b0;
  logic [11:0] r_awaddr = 12'd0, r_araddr = 12'd0;
  logic [31:0] r_wdata = 32'd0;
  logic [3:0] r_wstrb = 4'd0;
  wire awvalid = random ? r_awvalid : h_awvalid, wvalid = random ? r_wvalid : h_wvalid, bready = random ? r_bready : h_bready;
  wire arvalid = random ? r_arvalid : h_arvalid, rready = random ? r_rready : h_rready;
  wire [11:0] awaddr = random ? r_awaddr : h_awaddr, araddr = random ? r_araddr : h_araddr;
  wire [31:0] wdata = random ? r_wdata : h_wdata;
  wire [3:0] wstrb = random ? r_wstrb : h_wstrb;
  wire awready, wready, bvalid, arready, rvalid;
  wire [31:0] rdata;
  wire [1:0] bresp, rresp;

  logic [2:0] comparator = 3'd0, hall = 3'd0;
  logic limit = 1'b0, fault = 1'b0;
  wire uh, ul, vh, vl, wh, wl, interrupt, locked, latched;
  six_step_axi #(.WITH_HALL_DECODER(WITH_HALL_DECODER)) dut (
      .clk(clk), .rst(rst),
      .pins_comparator_u_i(comparator[0]), .pins_comparator_v_i(comparator[1]), .pins_comparator_w_i(comparator[2]),
      .pins_limit_i(limit), .pins_fault_i(fault),
      .pins_hall_u_i(hall[0]), .pins_hall_v_i(hall[1]), .pins_hall_w_i(hall[2]),
      .axi_awvalid_i(awvalid), .axi_awaddr_i(awaddr), .axi_wvalid_i(wvalid), .axi_wdata_i(wdata), .axi_wstrb_i(wstrb),
      .axi_bready_i(bready), .axi_arvalid_i(arvalid), .axi_araddr_i(araddr), .axi_rready_i(rready),
      .gates_uh_o(uh), .gates_ul_o(ul), .gates_vh_o(vh), .gates_vl_o(vl), .gates_wh_o(wh), .gates_wl_o(wl),
      .interrupt_o(interrupt), .locked_o(locked), .fault_o(latched),
      .axi_awready_o(awready), .axi_wready_o(wready), .axi_bvalid_o(bvalid), .axi_bresp_o(bresp),
      .axi_arready_o(arready), .axi_rvalid_o(rvalid), .axi_rdata_o(rdata), .axi_rresp_o(rresp)
  );
  axi_host host (
      .clk(clk), .awvalid(h_awvalid), .awaddr(h_awaddr), .awready(awready), .wvalid(h_wvalid), .wdata(h_wdata), .wstrb(h_wstrb),
      .wready(wready), .bvalid(bvalid), .bresp(bresp), .bready(h_bready), .arvalid(h_arvalid), .araddr(h_araddr),
      .arready(arready), .rvalid(rvalid), .rdata(rdata), .rresp(rresp), .rready(h_rready)
  );
  six_step_axi_properties properties (
      .clk(clk), .rst(rst), .pins_fault_i(fault),
      .axi_awvalid_i(awvalid), .axi_awready_o(awready), .axi_wvalid_i(wvalid), .axi_wready_o(wready), .axi_bvalid_o(bvalid), .axi_bready_i(bready),
      .axi_arvalid_i(arvalid), .axi_arready_o(arready), .axi_rvalid_o(rvalid), .axi_rready_i(rready),
      .axi_awaddr_i(awaddr), .axi_wdata_i(wdata), .axi_rdata_o(rdata), .axi_wstrb_i(wstrb), .axi_bresp_o(bresp), .axi_rresp_o(rresp),
      .gates_uh_o(uh), .gates_ul_o(ul), .gates_vh_o(vh), .gates_vl_o(vl), .gates_wh_o(wh), .gates_wl_o(wl),
      .locked_o(locked), .fault_o(latched)
  );

  // Xorshift: the same numbers in every simulator.
  logic [31:0] seed = 32'd1;
  function automatic logic [31:0] bits;
    seed = seed ^ (seed << 13);
    seed = seed ^ (seed >> 17);
    seed = seed ^ (seed << 5);
    return seed;
  endfunction
  function automatic int draw(input int below);
    return int'((bits() >> 4) % below);
  endfunction

  string file;
  int errors, count;
  wire [5:0] gates = {uh, ul, vh, vl, wh, wl};

  // Mostly what starts a drive, stops it, opens its lock or clears its fault; else any register.
  function automatic logic [11:0] address;
    int which, register;
    which = draw(16);
    register = draw(which == 9 ? 1024 : 64);
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
    any = bits();
    few = 32'(draw(12));
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
    aw_taken <= awvalid && awready;
    ar_taken <= arvalid && arready;
  end
  task automatic rotor;
    if (draw(200) == 0) comparator = 3'(draw(8));
  endtask
  task automatic for_a_while(inout logic pin, input int between, input int lasts);
    if (pin) begin
      if (draw(lasts) == 0) pin = 1'b0;
    end else if (draw(between) == 0) pin = 1'b1;
  endtask
  // Reset, whatever was going on; then configured, and told to run.
  task automatic begin_again;
    random = 1'b0;
    rst = 1'b1;
    {r_awvalid, r_wvalid, r_arvalid, r_bready, r_rready} = 5'd0;
    repeat (4) @(negedge clk);
    {rst, fault, limit} = 3'd0;
    repeat (4) @(negedge clk);
    host.configure(file, errors, count);
    if (count == 0 || errors != 0) properties.fail("the words are not kept");
    host.write(12'h00c, 32'd3);  // CONTROL: configured, run
  endtask
  task automatic traffic;
    if (aw_taken) {r_awvalid, r_wvalid} = 2'd0;
    if (ar_taken) r_arvalid = 1'b0;
    if (!r_awvalid && !r_wvalid && draw(40) == 0) begin
      r_awaddr = address();
      r_wdata = value(r_awaddr);
      r_wstrb = 4'hf;
      if (draw(4) == 0) r_wstrb = 4'(draw(16));
      r_awvalid = 1'b1;
    end
    if (r_awvalid && !r_wvalid && draw(3) == 0) r_wvalid = 1'b1;
    if (!r_arvalid && draw(20) == 0) begin
      r_araddr = address();
      r_arvalid = 1'b1;
    end
    r_bready = draw(3) == 0;
    r_rready = draw(3) == 0;
    rotor;
    if (draw(2000) == 0) hall = 3'(draw(8));
    for_a_while(limit, 400, 20);
    for_a_while(fault, 20000, 10);
  endtask

  int drives = 0, faults = 0, refused = 0, answered = 0, resets = 0;
  logic was_latched = 1'b0;
  always @(posedge clk) begin
    if (gates != 6'd0) drives <= drives + 1;
    was_latched <= latched;
    if (latched && !was_latched) faults <= faults + 1;
    if (random && bvalid && bready) begin
      answered <= answered + 1;
      if (bresp != 2'd0) refused <= refused + 1;
    end
  end

  int clocks = 200_000, wait_for;
  initial begin
    if (!$value$plusargs("words=%s", file)) properties.fail("no +words=FILE.mem");
    count = $value$plusargs("clocks=%d", clocks);
    count = $value$plusargs("seed=%d", seed);
    if (seed == 0) seed = 32'd1;
    for (int done = 0; done < clocks; done += 40_000) begin
      begin_again;
      wait_for = 60_000;
      while (wait_for > 0 && !(wait_for < 30_000 && gates != 6'd0)) begin
        @(negedge clk) rotor;
        wait_for = wait_for - 1;
      end
      if (gates != 6'd0) resets = resets + 1;
      begin_again;
      repeat (30_000) @(negedge clk) rotor;
      random = 1'b1;
      repeat (40_000) @(negedge clk) traffic;
    end
    $display("%0d clocks of traffic: a gate was on in %0d, %0d faults, %0d resets while one was, %0d writes, %0d of them refused", clocks, drives, faults, resets,
             answered, refused);
    if (drives == 0 || faults == 0 || resets == 0 || answered == 0 || refused == 0) properties.fail("something never happened");
    $display("PASSED");
    $finish;
  end
endmodule
