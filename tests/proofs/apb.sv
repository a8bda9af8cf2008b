// The APB4 slave, rtl/apb.sv, for every host that shows one clock of setup and then access until ready: one
// answer in the second clock of access, none unasked, nothing during setup, and while the answer is shown
// no request that could change its payload (the registers change it at a request alone: hls/bus/bus.hpp).

module apb_proof (
    input logic        clk,
    input logic        rst,
    input logic        psel,
    input logic        penable,
    input logic        pwrite,
    input logic [11:0] paddr,
    input logic [31:0] pwdata,
    input logic [3:0]  pstrb
);
  logic ready, write, read;
  logic [9:0] index;
  logic [31:0] data;
  logic [3:0] strobes;

  apb bus (
      .clk(clk), .rst(rst),
      .psel_i(psel), .penable_i(penable), .pwrite_i(pwrite), .paddr_i(paddr), .pwdata_i(pwdata),
      .pstrb_i(pstrb),
      .pready_o(ready),
      .request_write_o(write), .request_read_o(read), .request_index_o(index),
      .request_data_o(data), .request_strobes_o(strobes)
  );

  // What the host sees: the phase before, and whether a request waits for its answer.
  reg valid = 0, owes = 0;
  reg was_psel = 0, was_penable = 0, was_ready = 0, was_pwrite = 0;
  reg [11:0] was_paddr = 0;
  reg [31:0] was_pwdata = 0;
  reg [3:0] was_pstrb = 0;
  wire access = psel && penable;
  always @(posedge clk) begin
    valid <= valid || rst;
    owes <= !rst && (write || read || (owes && !ready));
    was_psel <= !rst && psel;
    was_penable <= !rst && penable;
    was_ready <= ready;
    was_pwrite <= pwrite;
    was_paddr <= paddr;
    was_pwdata <= pwdata;
    was_pstrb <= pstrb;
  end

  // Setup lasts one clock and is followed by access; access lasts until ready, and everything stands still.
  wire was_setup = was_psel && !was_penable;
  wire waits = was_setup || (was_psel && was_penable && !was_ready);
  always @* begin
    if (rst) assume (!psel && !penable);
    if (valid && waits) begin
      assume (access && pwrite == was_pwrite && paddr == was_paddr && pwdata == was_pwdata && pstrb == was_pstrb);
    end
    if (valid && !waits) assume (!penable);
  end

  always @* if (valid && !rst) begin
    // An answer for each request, in the clock after it, and for nothing else.
    assert (ready == owes);
    if (ready) assert (access);
    // Requests are those of the first clock of access.
    assert ((write || read) == (access && was_setup));
    assert (!(write && read));
    if (ready) assert (!write && !read);
    // What is asked for is what the host shows.
    if (write) assert (pwrite && index == paddr[11:2] && data == pwdata && strobes == pstrb);
    if (read) assert (!pwrite && index == paddr[11:2]);
  end

  always @* if (valid && !rst) begin
    cover (ready && pwrite);
    cover (ready && !pwrite);
    cover (psel && !penable && was_ready);
  end
endmodule
