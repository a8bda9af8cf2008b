// wishbone: steplock::Wishbone, printed by hlsgen from hls/bus/wishbone.hpp:22.
// Do not edit: change the C++ and print again.

module wishbone (
    input  logic        clk,
    input  logic        rst,  // synchronous, active high
    input  logic        cyc_i,
    input  logic        stb_i,
    input  logic        we_i,
    input  logic [11:0] adr_i,  // bytes; the lowest two bits do not count
    input  logic [31:0] dat_i,
    input  logic [3:0]  sel_i,
    output logic        ack_o,  // the answer is there; the top makes err of it if the registers refused
    output logic        stall_o,
    output logic        request_write_o,
    output logic        request_read_o,
    output logic [9:0]  request_index_o,
    output logic [31:0] request_data_o,
    output logic [3:0]  request_strobes_o  // bytes of `data` that count
);
  logic asked;  // in the clock before: this one has the answer
  logic rests;  // after an answer

  wire both_40 = cyc_i && stb_i;  // line 40
  wire rests_next = both_40 && asked;
  wire asked_next = both_40 && !(asked || rests);

  always_ff @(posedge clk) begin
    asked <= asked_next;
    rests <= rests_next;
    if (rst) begin
      asked <= 1'b0;
      rests <= 1'b0;
    end
  end

  assign ack_o = rests_next;
  assign stall_o = cyc_i && !asked;
  assign request_write_o = asked_next && we_i;
  assign request_read_o = asked_next && !we_i;
  assign request_index_o = adr_i[11:2];
  assign request_data_o = dat_i;
  assign request_strobes_o = sel_i;

  // What nothing reads, for the linters.
  wire unused = &{1'b0, adr_i[1:0]};
endmodule
