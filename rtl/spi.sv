// spi: steplock::Spi, printed by hlsgen from hls/bus/spi.hpp:26.
// Do not edit: change the C++ and print again.

module spi (
    input  logic        clk,
    input  logic        rst,  // synchronous, active high
    input  logic        pins_cs_n_i,
    input  logic        pins_sclk_i,
    input  logic        pins_mosi_i,
    input  logic        reply_bit_i,  // at `place` of the read's answer
    input  logic        reply_error_i,  // of the present frame's answer
    output logic        miso_o,  // pin
    output logic        selected_o,  // miso is to be driven, where several slaves share it
    output logic        writing_o,  // the present frame is a write
    output logic [4:0]  place_o,  // of the data bit that is wanted
    output logic        request_write_o,
    output logic        request_read_o,
    output logic [9:0]  request_index_o,
    output logic [31:0] request_data_o,
    output logic [3:0]  request_strobes_o  // bytes of `data` that count
);
  (* ASYNC_REG = "TRUE", syn_preserve = 1,
     altera_attribute = "-name SYNCHRONIZER_IDENTIFICATION FORCED" *)
  logic
      first_cs_n,
      first_sclk,
      first_mosi,
      second_cs_n,
      second_sclk,
      second_mosi;
  logic was_high;  // sclk, in the clock before
  logic [5:0] bits;  // of this frame
  logic [31:0] shift;  // the last bits
  logic headed;  // one clock: the head has come
  logic asks;  // one clock
  logic write;
  logic [9:0] index;
  logic miso;

  wire both = !second_cs_n && second_sclk && !was_high;

  always_ff @(posedge clk) begin
    first_cs_n <= pins_cs_n_i;
    first_sclk <= pins_sclk_i;
    first_mosi <= pins_mosi_i;
    second_cs_n <= first_cs_n;
    second_sclk <= first_sclk;
    second_mosi <= first_mosi;
    was_high <= second_sclk;
    if (second_cs_n) begin
      bits <= 6'd0;
      headed <= 1'b0;
      write <= 1'b0;
      miso <= 1'b0;
    end else begin
      if (was_high) begin
        headed <= 1'b0;
        if (!second_sclk) begin
          logic choice_69;
          choice_69 = headed ? shift[15] : write;  // line 69
          if ((choice_69 ? 3'd6 : 3'd2) == bits[5:3]) begin
            logic either;
            either = bits[2:0] == 3'd1 || bits[2:0] == 3'd3 || bits[2:0] == 3'd4;
            miso <= either || bits[2:0] == 3'd6 || (bits[2:0] == 3'd5 && reply_error_i);
          end else begin
            miso <= !choice_69 && bits[5:3] > 3'd2 && bits != 6'd56 && reply_bit_i;
          end
        end
      end else begin
        if (second_sclk) begin
          if (bits != 6'd56) begin
            bits <= bits + 6'd1;
          end
          shift <= {shift[30:0], 1'b0} | {31'd0, second_mosi};
        end
        headed <= second_sclk && bits == 6'd15;
      end
      if (headed) begin
        write <= shift[15];
      end
    end
    if (headed) begin
      if (!shift[15] || !both) begin
        asks <= !shift[15];
      end else begin
        asks <= bits == 6'd47 && write;
      end
      index <= shift[11:2];
    end else begin
      asks <= both && bits == 6'd47 && write;
    end
    if (rst) begin
      first_cs_n <= 1'b1;
      first_sclk <= 1'b0;
      first_mosi <= 1'b0;
      second_cs_n <= 1'b1;
      second_sclk <= 1'b0;
      second_mosi <= 1'b0;
      was_high <= 1'b0;
      bits <= 6'd0;
      shift <= 32'd0;
      headed <= 1'b0;
      asks <= 1'b0;
      write <= 1'b0;
      index <= 10'd0;
      miso <= 1'b0;
    end
  end

  assign miso_o = miso;
  assign selected_o = !second_cs_n;
  assign writing_o = write;
  assign place_o = 5'd23 - bits[4:0];
  assign request_write_o = asks && write;
  assign request_read_o = asks && !write;
  assign request_index_o = index;
  assign request_data_o = shift;
  assign request_strobes_o = 4'd15;
endmodule
