// apb: steplock::Apb, printed by hlsgen from hls/bus/apb.hpp:20.
// Do not edit: change the C++ and print again.

module apb (
    input  logic        clk,
    input  logic        rst,  // synchronous, active high
    input  logic        psel_i,
    input  logic        penable_i,
    input  logic        pwrite_i,
    input  logic [11:0] paddr_i,  // bytes; the lowest two bits do not count
    input  logic [31:0] pwdata_i,
    input  logic [3:0]  pstrb_i,
    output logic        pready_o,  // low outside of a transfer
    output logic        request_write_o,
    output logic        request_read_o,
    output logic [9:0]  request_index_o,
    output logic [31:0] request_data_o,
    output logic [3:0]  request_strobes_o  // bytes of `data` that count
);
  logic asked;  // in the clock before: this one has the answer

  wire both_37 = psel_i && penable_i;  // line 37
  wire asked_next = both_37 && !asked;  // line 38

  always_ff @(posedge clk) begin
    asked <= asked_next;  // line 38
    if (rst) begin
      asked <= 1'b0;
    end
  end

  assign pready_o = both_37 && asked;
  assign request_write_o = asked_next && pwrite_i;
  assign request_read_o = asked_next && !pwrite_i;
  assign request_index_o = paddr_i[11:2];
  assign request_data_o = pwdata_i;
  assign request_strobes_o = pstrb_i;

  // What nothing reads, for the linters.
  wire unused = &{1'b0, paddr_i[1:0]};
endmodule
