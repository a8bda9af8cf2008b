// sinc3: steplock::Sinc3<6>, printed by hlsgen from hls/sinusoidal/sinc3.hpp:24.
// Do not edit: change the C++ and print again.

module sinc3 (
    input  logic        clk,
    input  logic        rst,  // synchronous, active high
    input  logic        start_i,  // a window begins; a bit of this clock is not in it
    input  logic        valid_i,  // there is a bit
    input  logic        bit_i,
    output logic        busy_o,  // within a window
    output logic        done_o,  // one clock: the value is new
    output logic [17:0] value_o  // s0.(kBits - 1), full scale of the modulator
);
  logic [1:0] third;  // of the window, 1 to 3; 0: no window
  logic [5:0] bits;
  logic [18:0] first_integral;
  logic [18:0] second_integral;
  logic [18:0] third_integral;
  logic [18:0] difference;
  logic done;

  wire [18:0] centred = difference - 19'd131072;  // line 44
  wire [18:0] sum = third_integral + second_integral;  // line 47
  wire [18:0] thrice = sum * 19'd3;  // line 48

  always_ff @(posedge clk) begin
    if (start_i) begin
      third <= 2'd1;
      bits <= 6'd0;
      first_integral <= 19'd0;
      second_integral <= 19'd0;
      third_integral <= 19'd0;
      done <= 1'b0;
    end else if (valid_i) begin
      case (third)
        2'd0: done <= 1'b0;
        default: begin
          logic [18:0] sum_58;
          sum_58 = second_integral + first_integral;  // line 58
          case (third)
            2'd1: begin
              if (bits == 6'd63) begin
                third <= third + 2'd1;
                difference <= thrice;
              end
              bits <= bits + 6'd1;
              second_integral <= sum_58;
              third_integral <= sum;
              done <= 1'b0;
            end
            2'd2: begin
              if (bits == 6'd63) begin
                third <= third + 2'd1;
                difference <= difference - thrice;
              end
              bits <= bits + 6'd1;
              second_integral <= sum_58;
              third_integral <= sum;
              done <= 1'b0;
            end
            default: begin  // 2'd3
              if (bits == 6'd63) begin
                third <= third + 2'd1;
                difference <= difference + sum;
              end
              bits <= bits + 6'd1;
              second_integral <= sum_58;
              third_integral <= sum;
              done <= bits == 6'd63;
            end
          endcase
        end
      endcase
      if (third != 2'd0 && bit_i) begin
        first_integral <= first_integral + 19'd1;
      end
    end else begin
      done <= 1'b0;
    end
    if (rst) begin
      third <= 2'd0;
      bits <= 6'd0;
      first_integral <= 19'd0;
      second_integral <= 19'd0;
      third_integral <= 19'd0;
      difference <= 19'd0;
      done <= 1'b0;
    end
  end

  assign busy_o = third != 2'd0;
  assign done_o = done;
  assign value_o =
      centred[18] ? ((difference[18:17] == 2'd0) ? centred[17:0] : -18'sd131072) :
      (!difference[18] && difference[17]) ? centred[17:0] :
      18'sd131071;
endmodule
