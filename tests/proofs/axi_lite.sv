// The AXI4-Lite slave, rtl/axi_lite.sv, for every host that keeps valid until ready: no answer is
// dropped or invented, reads and writes never meet, and while an answer waits no request is made
// that could change its payload (the registers change it at a request alone: hls/bus/bus.hpp).
// That awready is wready, Yosys sees itself.

module axi_lite_proof (
    input logic        clk,
    input logic        rst,
    input logic        awvalid,
    input logic [11:0] awaddr,
    input logic        wvalid,
    input logic [31:0] wdata,
    input logic [3:0]  wstrb,
    input logic        bready,
    input logic        arvalid,
    input logic [11:0] araddr,
    input logic        rready
);
  logic awready, wready, bvalid, arready, rvalid;
  logic write, read;
  logic [9:0] index;
  logic [31:0] data;
  logic [3:0] strobes;

  axi_lite bus (
      .clk(clk), .rst(rst),
      .awvalid_i(awvalid), .awaddr_i(awaddr), .wvalid_i(wvalid), .wdata_i(wdata),
      .wstrb_i(wstrb), .bready_i(bready), .arvalid_i(arvalid), .araddr_i(araddr),
      .rready_i(rready),
      .awready_o(awready), .wready_o(wready), .bvalid_o(bvalid), .arready_o(arready),
      .rvalid_o(rvalid),
      .request_write_o(write), .request_read_o(read), .request_index_o(index),
      .request_data_o(data), .request_strobes_o(strobes)
  );

  // What the host sees: how many transfers wait for their answer.
  reg valid = 0;
  reg owes_write = 0, owes_read = 0;
  wire takes_write = awvalid && awready, takes_read = arvalid && arready;
  always @(posedge clk) begin
    valid <= valid || rst;
    owes_write <= !rst && (takes_write || (owes_write && !(bvalid && bready)));
    owes_read  <= !rst && (takes_read || (owes_read && !(rvalid && rready)));
  end

  // The clock before; nothing of it counts after a reset.
  reg        was_awvalid = 0, was_wvalid = 0, was_arvalid = 0;
  reg        was_bvalid = 0, was_bready = 0, was_rvalid = 0, was_rready = 0;
  reg        was_awready = 0, was_arready = 0;
  always @(posedge clk) begin
    was_awvalid <= !rst && awvalid;
    was_wvalid <= !rst && wvalid;
    was_arvalid <= !rst && arvalid;
    was_awready <= awready;
    was_arready <= arready;
    was_bvalid <= !rst && bvalid;
    was_bready <= bready;
    was_rvalid <= !rst && rvalid;
    was_rready <= rready;
  end

  // A host keeps valid until ready; during reset it shows none.
  always @* begin
    if (rst) assume (!awvalid && !wvalid && !arvalid);
    if (valid) begin
      if (was_awvalid && !was_awready) assume (awvalid);
      if (was_wvalid && !was_awready) assume (wvalid);
      if (was_arvalid && !was_arready) assume (arvalid);
    end
  end

  always @* if (valid && !rst) begin
    // Address and data are taken only when both are there.
    if (awready) assert (awvalid && wvalid);
    if (arready) assert (arvalid);
    // One request per transfer, never two at once.
    assert (write == takes_write);
    assert (read == takes_read);
    assert (!(write && read));
    // An answer for each transfer and for nothing else; no second transfer before it.
    assert (bvalid == owes_write);
    assert (rvalid == owes_read);
    if (owes_write) assert (!awready);
    if (owes_read) assert (!arready);
    // It waits, and its payload with it.
    if (was_bvalid && !was_bready) assert (bvalid);
    if (was_rvalid && !was_rready) assert (rvalid);
    if (bvalid) assert (!write);
    if (rvalid) assert (!read);
    // What is asked for is what the host shows.
    if (write) assert (index == awaddr[11:2] && data == wdata && strobes == wstrb);
    if (read) assert (index == araddr[11:2]);
  end

  always @* if (valid && !rst) begin
    cover (was_bvalid && !was_bready && bvalid && bready);
    cover (rvalid && bvalid && rready && bready);
    cover (write && arvalid);
  end
endmodule
