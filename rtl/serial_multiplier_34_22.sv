// serial_multiplier_34_22: steplock::SerialMultiplier<34, 22>, printed by hlsgen from hls/numeric/serial_multiplier.hpp:24.
// Do not edit: change the C++ and print again.

module serial_multiplier_34_22 (
    input  logic        clk,
    input  logic        rst,  // synchronous, active high
    input  logic        start_i,  // takes b, begins with a
    input  logic [33:0] a_i,  // hold from start to done
    input  logic [21:0] b_i,  // needed in the clock of start alone
    input  logic [3:0]  shift_i,  // bits to drop from the product's end; hold from start to done
    output logic [55:0] product_o,  // valid from done to the next start
    output logic        done_o,  // one clock
    output logic        busy_o  // from the clock after start to the one before done
);
  logic [33:0] high;  // the product so far, its upper bits
  logic [21:0] low;  // above: its lower bits; below: the bits of b still to come
  logic [33:0] addend;  // a, or 0 where the bit of b is 0
  logic [4:0] left;  // clocks
  logic dropping;  // b is used up; the clocks that are left shift the product
  logic done;  // the product is complete

  always_ff @(posedge clk) begin
    if (start_i) begin
      high <= 34'd0;
      low <= b_i;
      if (b_i[0]) begin
        addend <= a_i;
      end else begin
        addend <= 34'd0;
      end
      left <= 5'd22;
      dropping <= 1'b0;
      done <= 1'b0;
    end else begin
      case (left)
        5'd0: done <= 1'b0;
        default: begin
          logic [34:0] sum;
          logic [21:0] joined_59;
          sum = {high[33], high} + {addend[33], addend};  // line 46
          joined_59 = {sum[0], low[21:1]};  // line 59
          case (left)
            5'd1: begin
              high <= sum[34:1];
              low <= joined_59;
              addend <= 34'd0;
              if (dropping) begin
                left <= left - 5'd1;
                dropping <= 1'b1;
                done <= 1'b1;
              end else begin
                if (shift_i != 4'd0) begin
                  left <= {1'b0, shift_i};
                end else begin
                  left <= left - 5'd1;
                end
                dropping <= shift_i != 4'd0;
                done <= shift_i == 4'd0;
              end
            end
            default: begin
              high <= sum[34:1];
              low <= joined_59;
              if (!low[1] || dropping) begin
                addend <= 34'd0;
              end else begin
                addend <= a_i;
              end
              left <= left - 5'd1;
              done <= 1'b0;
            end
          endcase
        end
      endcase
    end
    if (rst) begin
      high <= 34'sd0;
      low <= 22'd0;
      addend <= 34'sd0;
      left <= 5'd0;
      dropping <= 1'b0;
      done <= 1'b0;
    end
  end

  assign product_o = {high, 22'd0} | {34'd0, low};
  assign done_o = done;
  assign busy_o = left != 5'd0;
endmodule
