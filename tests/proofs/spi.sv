// The SPI slave, rtl/spi.sv, for every sequence of its pins, however fast and however cut: a write is asked for
// with the 48th bit of a frame and a read with the 16th, once each, with the address and data of these
// bits, and nothing else is ever asked for; miso is low without select.
//
//! connect shift dut.shift
//! connect counted dut.bits
//! connect headed dut.headed
//! connect asks dut.asks
//! connect writing dut.write
//! connect was_high dut.was_high
//! connect first_cs dut.first_cs_n
//! connect first_sclk dut.first_sclk
//! connect first_mosi dut.first_mosi
//! connect second_sclk dut.second_sclk
//! connect second_mosi dut.second_mosi

module spi_proof (
    input logic clk,
    input logic rst,
    input logic cs_n,
    input logic sclk,
    input logic mosi,
    input logic data_bit,
    input logic error
);
  logic miso, selected, is_writing, write, read;
  logic [4:0] place;
  logic [9:0] index;
  logic [31:0] data;
  logic [3:0] strobes;

  spi dut (
      .clk(clk), .rst(rst),
      .pins_cs_n_i(cs_n), .pins_sclk_i(sclk), .pins_mosi_i(mosi), .reply_bit_i(data_bit), .reply_error_i(error),
      .miso_o(miso), .selected_o(selected), .writing_o(is_writing), .place_o(place),
      .request_write_o(write), .request_read_o(read), .request_index_o(index),
      .request_data_o(data), .request_strobes_o(strobes)
  );

  // The pins as two flip-flops see them, and the frame so far: its bits, the last 48 of them.
  reg valid = 0;
  reg a_cs = 1, a_sclk = 0, a_mosi = 0, b_cs = 1, b_sclk = 0, b_mosi = 0, c_sclk = 0;
  reg [5:0] count = 0;
  reg [47:0] frame = 0;
  // What is due: after the 16th bit, a clock later, and after the 48th.
  reg head_1 = 0, head_2 = 0, whole = 0;
  reg [15:0] head = 0;
  wire rises = !b_cs && b_sclk && !c_sclk;
  wire [47:0] longer = {frame[46:0], b_mosi};
  always @(posedge clk) begin
    valid <= valid || rst;
    if (rst) begin
      {a_cs, a_sclk, a_mosi, b_cs, b_sclk, b_mosi, c_sclk} <= 7'b1001000;
      count <= 0;
      frame <= 0;
      {head_1, head_2, whole} <= 0;
      head <= 0;
    end else begin
      {a_cs, a_sclk, a_mosi} <= {cs_n, sclk, mosi};
      {b_cs, b_sclk, b_mosi} <= {a_cs, a_sclk, a_mosi};
      c_sclk <= b_sclk;
      if (b_cs) count <= 0;
      else if (rises && count != 56) count <= count + 1;
      if (rises) frame <= longer;
      if (rises && count == 15) head <= longer[15:0];
      head_1 <= rises && count == 15;
      head_2 <= head_1;
      whole <= rises && count == 47;
    end
  end

`ifdef INVARIANTS
  wire [31:0] shift;
  wire [5:0] counted;
  wire headed, asks, writing, was_high, first_cs, first_sclk, first_mosi, second_sclk, second_mosi;
  always @* if (valid && !rst) begin
    assert ({first_cs, first_sclk, first_mosi} == {a_cs, a_sclk, a_mosi});
    assert ({second_sclk, second_mosi, was_high} == {b_sclk, b_mosi, c_sclk});
    assert (counted == count && shift == frame[31:0]);
    assert (headed == head_1 && asks == (head_2 ? !head[15] : whole && head[15]));
    // The clock after a rise has none.
    assert (!(head_1 || whole) || c_sclk);
    assert (!head_1 || (count == 16 && head == frame[15:0] && !writing));
    assert (!head_2 || count == 16 || count == 0);
    assert (!whole || (count == 48 && !head_2));
    assert (!(head_1 && head_2));
    assert (!head_2 || index == head[11:2]);
    assert (!head_2 || writing == (head[15] && count != 0));
    assert (count <= 56 && (count >= 16 || !writing));
    assert (!(count > 16 || (count == 16 && !head_1)) || (index == head[11:2] && writing == head[15]));
  end
`endif

  always @* if (valid && !rst) begin
    assert (selected == !b_cs);
    assert (write == (whole && head[15]));
    assert (read == (head_2 && !head[15]));
    assert (!(write && read));
    if (write) assert (index == head[11:2] && data == frame[31:0] && strobes == 4'hf);
    if (read) assert (index == head[11:2]);
  end

`ifdef SHORT
  // What is covered and refuted is within one frame: sclk runs, select may be lost at first.
  reg [6:0] now = 0;
  always @(posedge clk) now <= rst ? 0 : now + 1;
  always @* begin
    assume (rst == !valid);
    assume (sclk == now[0]);
    if (now >= 10) assume (!cs_n && mosi == now[2]);
  end
`endif

  always @* if (valid && !rst) begin
    cover (read);
    cover (write);
    cover (head_2 && head[15]);
  end
endmodule
