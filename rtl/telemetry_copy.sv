// telemetry_copy: of steplock::Memory<steplock::TelemetryCopy>, printed by hlsgen from hls/numeric/memory.hpp:34.

module telemetry_copy (
    input  logic clk,
    input  logic rst,  // the words stay
    input  logic read_i,  // `data` becomes the word at `address`; else it stays
    input  logic [2:0] address_i,
    input  logic write_i,  // parts of the word at `write_address` that change
    input  logic [2:0] write_address_i,
    input  logic [31:0] write_data_i,
    output logic [31:0] data_o  // the word that was read last
);
  (* no_rw_check *)
  logic [31:0] words [0:7];

  initial begin
    words[0] = 32'h0;
    words[1] = 32'h0;
    words[2] = 32'h0;
    words[3] = 32'h0;
    words[4] = 32'h0;
    words[5] = 32'h0;
    words[6] = 32'h0;
    words[7] = 32'h0;
  end

  always_ff @(posedge clk) begin
    if (write_i) words[write_address_i] <= write_data_i;
    if (read_i) data_o <= words[address_i];
  end

  wire unused = &{1'b0, rst};
endmodule
