// spi_adc: steplock::SpiAdc, printed by hlsgen from hls/sinusoidal/spi_adc.hpp:36.
// Do not edit: change the C++ and print again.

module spi_adc (
    input  logic        clk,
    input  logic        rst,  // synchronous, active high
    input  logic        sample_i,  // strobe: hold now
    input  logic        miso_i,  // pin, from the converter's DOUT
    input  logic [5:0]  words_half_i,  // clocks of half an sclk period; 0: off
    input  logic [7:0]  words_quiet_i,  // clocks of cs_n high between frames; less than 4 counts as 4
    input  logic [2:0]  words_u_i,  // channel of the current of phase u
    input  logic [2:0]  words_v_i,  // channel of the current of phase v
    input  logic [2:0]  words_dc_i,  // channel of the dc voltage
    input  logic        words_twice_i,  // the range is twice the reference, not once
    output logic        cs_n_o,  // pin
    output logic        sclk_o,  // pin, to SCLK; high between frames
    output logic        mosi_o,  // pin, to DIN
    output logic        codes_valid_o,  // one clock: the codes are of a new sample
    output logic [11:0] codes_u_o,  // s0.11, current of phase u
    output logic [11:0] codes_v_o,  // s0.11, current of phase v
    output logic [11:0] codes_dc_o,  // u0.12, dc voltage
    output logic        ready_o,  // a sample would be taken now
    output logic        missed_o,  // one clock: `sample` came while not ready, and has no codes
    output logic        error_o  // one clock: a wrong answer; the sample has no codes
);
  localparam logic [2:0] Frame_kWake = 3'd0;
  localparam logic [2:0] Frame_kWakeAgain = 3'd1;
  localparam logic [2:0] Frame_kSelect = 3'd2;
  localparam logic [2:0] Frame_kU = 3'd3;
  localparam logic [2:0] Frame_kV = 3'd4;
  localparam logic [2:0] Frame_kDc = 3'd5;

  logic [2:0] frame;  // the present one, or the next
  logic selected;  // within a frame
  logic [4:0] half;  // half periods of sclk since cs_n fell
  logic [7:0] left;  // clocks of this half, or to the next frame, without this one
  logic sclk;
  logic mosi;
  (* ASYNC_REG = "TRUE", syn_preserve = 1,
     altera_attribute = "-name SYNCHRONIZER_IDENTIFICATION FORCED" *)
  logic
      first,  // synchroniser
      second;
  logic [1:0] falls;  // sclk fell in the last clocks
  logic whole;  // one clock: the answer has all its bits
  logic [15:0] answer;
  logic [11:0] u;  // s0.11
  logic [11:0] v;  // s0.11
  logic valid;
  logic missed;
  logic error;

  wire both = !selected && left == 8'd0 && words_half_i != 6'd0;
  wire ready = both && frame == Frame_kU;

  logic [2:0] choice;
  always_comb begin
    case (frame)
      Frame_kWake: choice = Frame_kWakeAgain;
      Frame_kWakeAgain: choice = Frame_kSelect;
      Frame_kU: choice = Frame_kV;
      Frame_kV: choice = Frame_kDc;
      default: choice = Frame_kU;
    endcase
  end

  wire both_114 = whole && (frame == Frame_kU || frame == Frame_kV || frame == Frame_kDc);
  wire [2:0] choice_107 =  // line 107
      (frame == Frame_kU) ? words_u_i :
      (frame == Frame_kV) ? words_v_i :
      words_dc_i;
  wire [3:0] wide_107 = {1'b0, choice_107};  // line 107
  wire unequal_114 = answer[15:12] != wide_107;  // line 114
  wire [2:0] choice_2 =
      (!whole || (both_114 && unequal_114)) ? (whole ? Frame_kWake : frame) : choice;

  always_ff @(posedge clk) begin
    if (both) begin
      if (choice_2 != Frame_kU || sample_i) begin
        frame <= choice_2;
      end else begin
        frame <= Frame_kU;
      end
    end else if (left == 8'd0 && !selected) begin
      frame <= Frame_kWake;
    end else begin
      frame <= choice_2;
    end
    if (left == 8'd0) begin
      if (!selected && words_half_i != 6'd0) begin
        logic [7:0] sum_80;
        sum_80 = {1'b0, words_half_i, 1'b0} - 8'd1;  // line 80
        if (sample_i) begin
          selected <= 1'b1;
          half <= 5'd0;
          left <= sum_80;
          mosi <= 1'b1;
        end else begin
          selected <= choice_2 != Frame_kU;
          if (choice_2 != Frame_kU) begin
            half <= 5'd0;
            left <= sum_80;
          end
          mosi <= choice_2 != Frame_kU || mosi;
        end
      end else begin
        selected <= selected && half != 5'd31;
        if (selected) begin
          case (half)
            5'd31: begin
              if (words_quiet_i[7:2] == 6'd0) begin
                left <= 8'd3;
              end else begin
                left <= words_quiet_i - 8'd1;
              end
            end
            default: begin
              logic [6:0] sum_93;
              logic [7:0] wide_93;
              logic [2:0] address;
              logic either;
              sum_93 = {1'b0, words_half_i} - 7'd1;  // line 93
              wide_93 = {sum_93[6], sum_93};  // line 93
              address =  // line 140
                  (choice_2 != Frame_kU && choice_2 != Frame_kV) ? words_u_i :
                  (choice_2 == Frame_kU) ? words_v_i :
                  words_dc_i;
              either = choice_2 == Frame_kWake || choice_2 == Frame_kWakeAgain;
              case (half)
                5'd1, 5'd3, 5'd15, 5'd17, 5'd23, 5'd25, 5'd27, 5'd29: begin
                  half <= half + 5'd1;
                  left <= wide_93;
                  mosi <= either;
                end
                5'd5: begin
                  half <= half + 5'd1;
                  left <= wide_93;
                  mosi <= either || address[2];
                end
                5'd7: begin
                  half <= half + 5'd1;
                  left <= wide_93;
                  mosi <= either || address[1];
                end
                5'd9: begin
                  half <= half + 5'd1;
                  left <= wide_93;
                  mosi <= either || address[0];
                end
                5'd11, 5'd13, 5'd21: begin
                  half <= half + 5'd1;
                  left <= wide_93;
                  mosi <= 1'b1;
                end
                5'd19: begin
                  half <= half + 5'd1;
                  left <= wide_93;
                  mosi <= either || !words_twice_i;
                end
                default: begin
                  half <= half + 5'd1;
                  left <= wide_93;
                end
              endcase
            end
          endcase
          sclk <= half[0];
        end
      end
    end else begin
      left <= left - 8'd1;
    end
    first <= miso_i;
    second <= first;
    falls <= {falls[0], 1'b0} | {1'b0, !both && left == 8'd0 && selected && !half[0]};  // line 98
    whole <= falls[1] && half == 5'd31;  // line 69
    if (falls[1]) begin
      answer <= {answer[14:0], 1'b0} | {15'd0, second};
    end
    case (frame)
      Frame_kU, Frame_kV: begin
        logic [11:0] current;
        current = answer[11:0] ^ 12'h800;  // line 110
        case (frame)
          Frame_kU: begin
            if (whole) begin
              u <= current;
              error <= unequal_114;
            end else begin
              error <= 1'b0;
            end
            valid <= 1'b0;
          end
          default: begin  // Frame_kV
            if (whole) begin
              v <= current;
              error <= unequal_114;
            end else begin
              error <= 1'b0;
            end
            valid <= 1'b0;
          end
        endcase
      end
      Frame_kDc: begin
        valid <= whole && answer[15:12] == wide_107;
        error <= whole && unequal_114;
      end
      default: begin
        valid <= 1'b0;
        error <= 1'b0;
      end
    endcase
    missed <= sample_i && !ready;  // line 65
    if (rst) begin
      frame <= Frame_kWake;
      selected <= 1'b0;
      half <= 5'd0;
      left <= 8'd0;
      sclk <= 1'b1;
      mosi <= 1'b0;
      first <= 1'b0;
      second <= 1'b0;
      falls <= 2'd0;
      whole <= 1'b0;
      answer <= 16'd0;
      u <= 12'sd0;
      v <= 12'sd0;
      valid <= 1'b0;
      missed <= 1'b0;
      error <= 1'b0;
    end
  end

  assign cs_n_o = !selected;
  assign sclk_o = sclk;
  assign mosi_o = mosi;
  assign codes_valid_o = valid;
  assign codes_u_o = u;
  assign codes_v_o = v;
  assign codes_dc_o = answer[11:0];
  assign ready_o = ready;
  assign missed_o = missed;
  assign error_o = error;
endmodule
