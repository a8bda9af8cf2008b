// word_mirror: of steplock::Memory<steplock::WordMirror<steplock::SixStep> >, printed by hlsgen from hls/numeric/memory.hpp:34.

module word_mirror (
    input  logic clk,
    input  logic rst,  // the words stay
    input  logic read_i,  // `data` becomes the word at `address`; else it stays
    input  logic [6:0] address_i,
    input  logic [3:0] write_i,  // parts of the word at `write_address` that change
    input  logic [6:0] write_address_i,
    input  logic [31:0] write_data_i,
    output logic [31:0] data_o  // the word that was read last
);
  (* no_rw_check *)
  logic [31:0] words [0:127];

  initial begin
    words[0] = 32'h0;
    words[1] = 32'h0;
    words[2] = 32'h0;
    words[3] = 32'h0;
    words[4] = 32'h0;
    words[5] = 32'h0;
    words[6] = 32'h0;
    words[7] = 32'h0;
    words[8] = 32'h0;
    words[9] = 32'h0;
    words[10] = 32'h0;
    words[11] = 32'h0;
    words[12] = 32'h0;
    words[13] = 32'h0;
    words[14] = 32'h0;
    words[15] = 32'h0;
    words[16] = 32'h0;
    words[17] = 32'h0;
    words[18] = 32'h0;
    words[19] = 32'h0;
    words[20] = 32'h0;
    words[21] = 32'h0;
    words[22] = 32'h0;
    words[23] = 32'h0;
    words[24] = 32'h0;
    words[25] = 32'h0;
    words[26] = 32'h0;
    words[27] = 32'h0;
    words[28] = 32'h0;
    words[29] = 32'h0;
    words[30] = 32'h0;
    words[31] = 32'h0;
    words[32] = 32'h0;
    words[33] = 32'h0;
    words[34] = 32'h0;
    words[35] = 32'h0;
    words[36] = 32'h0;
    words[37] = 32'h0;
    words[38] = 32'h0;
    words[39] = 32'h0;
    words[40] = 32'h0;
    words[41] = 32'h0;
    words[42] = 32'h0;
    words[43] = 32'h0;
    words[44] = 32'h0;
    words[45] = 32'h0;
    words[46] = 32'h0;
    words[47] = 32'h0;
    words[48] = 32'h0;
    words[49] = 32'h0;
    words[50] = 32'h0;
    words[51] = 32'h0;
    words[52] = 32'h0;
    words[53] = 32'h0;
    words[54] = 32'h0;
    words[55] = 32'h0;
    words[56] = 32'h0;
    words[57] = 32'h0;
    words[58] = 32'h0;
    words[59] = 32'h0;
    words[60] = 32'h0;
    words[61] = 32'h0;
    words[62] = 32'h0;
    words[63] = 32'h0;
    words[64] = 32'h53544C4B;
    words[65] = 32'h300;
    words[66] = 32'h10C71;
    words[67] = 32'h0;
    words[68] = 32'h0;
    words[69] = 32'h0;
    words[70] = 32'h0;
    words[71] = 32'h0;
    words[72] = 32'h0;
    words[73] = 32'h0;
    words[74] = 32'h0;
    words[75] = 32'h0;
    words[76] = 32'h0;
    words[77] = 32'h0;
    words[78] = 32'h0;
    words[79] = 32'h0;
    words[80] = 32'h0;
    words[81] = 32'h0;
    words[82] = 32'h0;
    words[83] = 32'h0;
    words[84] = 32'h0;
    words[85] = 32'h0;
    words[86] = 32'h0;
    words[87] = 32'h0;
    words[88] = 32'h0;
    words[89] = 32'h0;
    words[90] = 32'h0;
    words[91] = 32'h0;
    words[92] = 32'h0;
    words[93] = 32'h0;
    words[94] = 32'h0;
    words[95] = 32'h0;
    words[96] = 32'h1000000;
    words[97] = 32'h0;
    words[98] = 32'h0;
    words[99] = 32'h1010002;
    words[100] = 32'h3;
    words[101] = 32'h40008000;
    words[102] = 32'h0;
    words[103] = 32'h8000;
    words[104] = 32'h0;
    words[105] = 32'h0;
    words[106] = 32'h0;
    words[107] = 32'h0;
    words[108] = 32'h0;
    words[109] = 32'h0;
    words[110] = 32'h0;
    words[111] = 32'h0;
    words[112] = 32'h0;
    words[113] = 32'h0;
    words[114] = 32'h0;
    words[115] = 32'h0;
    words[116] = 32'h0;
    words[117] = 32'h0;
    words[118] = 32'h0;
    words[119] = 32'h0;
    words[120] = 32'h0;
    words[121] = 32'h0;
    words[122] = 32'h0;
    words[123] = 32'h0;
    words[124] = 32'h0;
    words[125] = 32'h0;
    words[126] = 32'h0;
    words[127] = 32'h0;
  end

  always_ff @(posedge clk) begin
    if (write_i[0]) words[write_address_i][7:0] <= write_data_i[7:0];
    if (write_i[1]) words[write_address_i][15:8] <= write_data_i[15:8];
    if (write_i[2]) words[write_address_i][23:16] <= write_data_i[23:16];
    if (write_i[3]) words[write_address_i][31:24] <= write_data_i[31:24];
    if (read_i) data_o <= words[address_i];
  end

  wire unused = &{1'b0, rst};
endmodule
