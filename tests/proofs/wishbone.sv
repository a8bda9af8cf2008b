// The Wishbone slave, rtl/wishbone.sv, for every host that holds a cycle until its answer: one answer in the
// clock after the request, none unasked, and while the answer is shown no request that could change
// its payload (the registers change it at a request alone: hls/bus/bus.hpp).

module wishbone_proof (
    input logic        clk,
    input logic        rst,
    input logic        cyc,
    input logic        stb,
    input logic        we,
    input logic [11:0] adr,
    input logic [31:0] dat,
    input logic [3:0]  sel
);
  logic ack, stall, write, read;
  logic [9:0] index;
  logic [31:0] data;
  logic [3:0] strobes;

  wishbone bus (
      .clk(clk), .rst(rst),
      .cyc_i(cyc), .stb_i(stb), .we_i(we), .adr_i(adr), .dat_i(dat), .sel_i(sel),
      .ack_o(ack), .stall_o(stall),
      .request_write_o(write), .request_read_o(read), .request_index_o(index),
      .request_data_o(data), .request_strobes_o(strobes)
  );

  // What the host sees: a cycle whose request was made and whose answer it waits for.
  reg valid = 0, owes = 0;
  reg was_active = 0, was_ack = 0, was_we = 0;
  reg [11:0] was_adr = 0;
  reg [31:0] was_dat = 0;
  reg [3:0] was_sel = 0;
  wire active = cyc && stb;
  always @(posedge clk) begin
    valid <= valid || rst;
    owes <= !rst && (write || read || (owes && !ack));
    was_active <= !rst && active;
    was_ack <= !rst && ack;
    was_we <= we;
    was_adr <= adr;
    was_dat <= dat;
    was_sel <= sel;
  end

  // A host holds its cycle until the answer; during reset it shows none.
  always @* begin
    if (rst) assume (!cyc && !stb);
    if (valid && was_active && !was_ack) begin
      assume (active && we == was_we && adr == was_adr && dat == was_dat && sel == was_sel);
    end
  end

  always @* if (valid && !rst) begin
    // An answer for each request, in the clock after it, and for nothing else.
    assert (ack == owes);
    if (ack) assert (active && was_active && !was_ack);
    // Every active clock is one of a request, of its answer, or of the rest after it.
    assert ((write || read) == (active && !owes && !was_ack));
    assert (!(write && read));
    if (ack) assert (!write && !read);
    // A pipelined host goes on with the answer.
    if (active) assert (stall == !ack);
    // What is asked for is what the host shows.
    if (write) assert (we && index == adr[11:2] && data == dat && strobes == sel);
    if (read) assert (!we && index == adr[11:2]);
  end

  always @* if (valid && !rst) begin
    cover (ack && we);
    cover (write && was_active);
    cover (ack && !we);
  end
endmodule
