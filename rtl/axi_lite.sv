// axi_lite: steplock::AxiLite, printed by hlsgen from hls/bus/axi_lite.hpp:23.
// Do not edit: change the C++ and print again.

module axi_lite (
    input  logic        clk,
    input  logic        rst,  // synchronous, active high
    input  logic        awvalid_i,
    input  logic [11:0] awaddr_i,  // bytes; the lowest two bits do not count
    input  logic        wvalid_i,
    input  logic [31:0] wdata_i,
    input  logic [3:0]  wstrb_i,
    input  logic        bready_i,
    input  logic        arvalid_i,
    input  logic [11:0] araddr_i,  // bytes
    input  logic        rready_i,
    output logic        awready_o,
    output logic        wready_o,
    output logic        bvalid_o,
    output logic        arready_o,
    output logic        rvalid_o,
    output logic        request_write_o,
    output logic        request_read_o,
    output logic [9:0]  request_index_o,
    output logic [31:0] request_data_o,
    output logic [3:0]  request_strobes_o  // bytes of `data` that count
);
  logic write_ready;  // takes a write in this clock
  logic read_ready;  // never both
  logic write_done;  // its response waits
  logic read_done;
  logic wrote;  // the last one taken was a write

  wire request_write = write_ready && awvalid_i && wvalid_i;  // line 47
  wire request_read = read_ready && arvalid_i;  // line 48
  wire both_61 = arvalid_i && !(read_ready || read_done);  // line 61

  always_ff @(posedge clk) begin
    if (both_61 && wrote) begin
      write_ready <= 1'b0;
      read_ready <= 1'b1;
      wrote <= 1'b0;
    end else begin
      logic both_60;
      logic read_ready_next;
      both_60 = awvalid_i && wvalid_i && !(write_ready || write_done);  // line 60
      read_ready_next = both_61 && (!both_60 || wrote);  // line 65
      write_ready <= both_60;
      read_ready <= read_ready_next;
      if (both_60 || read_ready_next) begin
        wrote <= both_60;
      end
    end
    write_done <= request_write || (write_done && !bready_i);
    read_done <= request_read || (read_done && !rready_i);
    if (rst) begin
      write_ready <= 1'b0;
      read_ready <= 1'b0;
      write_done <= 1'b0;
      read_done <= 1'b0;
      wrote <= 1'b0;
    end
  end

  assign awready_o = write_ready;
  assign wready_o = write_ready;
  assign bvalid_o = write_done;
  assign arready_o = read_ready;
  assign rvalid_o = read_done;
  assign request_write_o = request_write;
  assign request_read_o = request_read;
  assign request_index_o = write_ready ? awaddr_i[11:2] : araddr_i[11:2];
  assign request_data_o = wdata_i;
  assign request_strobes_o = wstrb_i;

  // What nothing reads, for the linters.
  wire unused = &{1'b0, awaddr_i[1:0], araddr_i[1:0]};
endmodule
