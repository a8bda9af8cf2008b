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
    output logic        busy_o,  // from the clock after start to the one before done
    output logic        ends_o  // done comes in the next clock, unless a start drops it
);
  logic [33:0] high;  // the product so far, its upper bits
  logic [21:0] low;  // above: its lower bits; below: the bits of b still to come
  logic [33:0] addend;  // a, or 0 where the bit of b is 0
  logic [4:0] left;  // clocks
  logic last;  // of them 1
  logic dropping;  // b is used up; the clocks that are left shift the product
  logic done;  // the product is complete

  wire both = last && !dropping && shift_i != 4'd0;
  wire ends = last && !both;  // line 44

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
      last <= 1'b0;
      dropping <= 1'b0;
    end else if (left != 5'd0) begin
      logic [34:0] sum;
      sum = {high[33], high} + {addend[33], addend};  // line 49
      high <= sum[34:1];
      low <= {sum[0], low[21:1]};
      if (both) begin
        addend <= 34'd0;
        left <= {1'b0, shift_i};
        last <= shift_i == 4'd1;
      end else begin
        if (!low[1] || last || dropping) begin
          addend <= 34'd0;
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
      high <= 34'sd0;
      low <= 22'd0;
      addend <= 34'sd0;
      left <= 5'd0;
      last <= 1'b0;
      dropping <= 1'b0;
      done <= 1'b0;
    end
  end

  assign product_o = {high, 22'd0} | {34'd0, low};
  assign done_o = done;
  assign busy_o = left != 5'd0;
  assign ends_o = ends;
endmodule
