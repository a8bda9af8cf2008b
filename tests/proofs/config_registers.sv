// Word registers: rtl/config_registers.sv answers a read once, and then says the same until the next one,
// whatever is written meanwhile; outside the map, and before the first read, it says 0.  The memory's
// contents are free here; that a hole of the map says 0 rests on them, and is tested
// (tests/hls/six_step_axi_test.cpp).
//! replaces config_mirror

// Any contents; like the memory it keeps what was read.
module config_mirror (
    input  logic        clk,
    input  logic        rst,
    input  logic        read_i,
    input  logic [6:0]  address_i,
    input  logic [3:0]  write_i,
    input  logic [6:0]  write_address_i,
    input  logic [31:0] write_data_i,
    output reg   [31:0] data_o
);
  (* anyseq *) wire [31:0] word;
  always @(posedge clk) if (read_i) data_o <= word;
endmodule

module config_registers_proof (
    input logic        clk,
    input logic        rst,
    input logic        write,
    input logic        read,
    input logic [9:0]  index,
    input logic [31:0] data,
    input logic [3:0]  strobes,
    input logic        stopped,
    input logic        boundary
);
  logic [31:0] answer;
  logic hole, refused;

  config_registers registers (
      .clk(clk), .rst(rst),
      .request_write_i(write), .request_read_i(read), .request_index_i(index),
      .request_data_i(data), .request_strobes_i(strobes),
      .stopped_i(stopped), .boundary_i(boundary),
      .data_o(answer), .hole_o(hole), .refused_o(refused)
  );

  reg valid = 0;
  reg was_read = 0, was_written = 0, was_outside = 0, was_reset = 1;
  reg [31:0] was_answer = 0;
  always @(posedge clk) begin
    valid <= valid || rst;
    was_reset <= rst;
    was_read <= read;
    was_written <= write && !refused;
    was_outside <= index >= 64;
    was_answer <= answer;
  end

  always @* if (valid && !rst) begin
    if (was_reset) assert (answer == 0);
    else if (was_read && was_outside) assert (answer == 0);
    else if (!was_read) assert (answer == was_answer);
    // No register stands outside the map, and a hole takes nothing.
    if (index >= 64) assert (hole);
    if (hole) assert (refused);
  end

  always @* if (valid && !rst) begin
    cover (!was_reset && !was_read && was_written && answer != 0);
    cover (was_read && answer != 0);
  end
endmodule
