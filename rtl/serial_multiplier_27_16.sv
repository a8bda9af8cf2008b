// serial_multiplier_27_16: steplock::SerialMultiplier<27, 16>, printed by hlsgen from hls/numeric/serial_multiplier.hpp:24.
// Do not edit: change the C++ and print again.

module serial_multiplier_27_16 (
    input  logic        clk,
    input  logic        rst,  // synchronous, active high
    input  logic        start_i,  // takes b, begins with a
    input  logic [26:0] a_i,  // hold from start to done
    input  logic [15:0] b_i,  // needed in the clock of start alone
    input  logic [3:0]  shift_i,  // bits to drop from the product's end; hold from start to done
    output logic [42:0] product_o,  // valid from done to the next start
    output logic        done_o,  // one clock
    output logic        busy_o,  // from the clock after start to the one before done
    output logic        ends_o  // done comes in the next clock, unless a start drops it
);
  logic [26:0] high;  // the product so far, its upper bits
  logic [15:0] low;  // above: its lower bits; below: the bits of b still to come
  logic [26:0] addend;  // a, or 0 where the bit of b is 0
  logic [4:0] left;  // clocks
  logic last;  // of them 1
  logic dropping;  // b is used up; the clocks that are left shift the product
  logic done;  // the product is complete

  wire both = last && !dropping && shift_i != 4'd0;
  wire ends = last && !both;  // line 44

  always_ff @(posedge clk) begin
    if (start_i) begin
      high <= 27'd0;
      low <= b_i;
      if (b_i[0]) begin
        addend <= a_i;
      end else begin
        addend <= 27'd0;
      end
      left <= 5'd16;
      last <= 1'b0;
      dropping <= 1'b0;
    end else if (left != 5'd0) begin
      logic [27:0] sum;
      sum = {high[26], high} + {addend[26], addend};  // line 49
      high <= sum[27:1];
      low <= {sum[0], low[15:1]};
      if (both) begin
        addend <= 27'd0;
        left <= {1'b0, shift_i};
        last <= shift_i == 4'd1;
      end else begin
        if (!low[1] || last || dropping) begin
          addend <= 27'd0;
        end else begin
          addend <= a_i;
        end
        left <= left - 5'd1;
        last <= left == 5'd2;
      end
      dropping <= dropping || both;
    end
    done <= !start_i && ends;  // line 50
    if (rst) begin
      high <= 27'sd0;
      low <= 16'd0;
      addend <= 27'sd0;
      left <= 5'd0;
      last <= 1'b0;
      dropping <= 1'b0;
      done <= 1'b0;
    end
  end

  assign product_o = {high, 16'd0} | {27'd0, low};
  assign done_o = done;
  assign busy_o = left != 5'd0;
  assign ends_o = ends;
endmodule
