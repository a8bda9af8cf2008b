// A product as rows of full adders, for tools/prove_print: the same on both sides, whatever things are
// called.  The order in which Yosys itself adds partial products depends on names, and two orders of one
// product are more than cec can prove.
//
// Test: tests/generator/rows_of_adders.sh
(* techmap_celltype = "$mul" *)
module rows_of_adders (A, B, Y);
  parameter A_SIGNED = 0;
  parameter B_SIGNED = 0;
  parameter A_WIDTH = 1;
  parameter B_WIDTH = 1;
  parameter Y_WIDTH = 1;
  input [A_WIDTH-1:0] A;
  input [B_WIDTH-1:0] B;
  output [Y_WIDTH-1:0] Y;
  wire [Y_WIDTH-1:0] a, b;
  wire [Y_WIDTH*(Y_WIDTH+1)-1:0] sums;  // row by row
  genvar row, i;
  generate
    for (i = 0; i < Y_WIDTH; i = i + 1) begin : extend
      assign a[i] = i < A_WIDTH ? A[i < A_WIDTH ? i : 0] : A_SIGNED && A[A_WIDTH-1];
      assign b[i] = i < B_WIDTH ? B[i < B_WIDTH ? i : 0] : B_SIGNED && B[B_WIDTH-1];
    end
    assign sums[Y_WIDTH-1:0] = 0;
    for (row = 0; row < Y_WIDTH; row = row + 1) begin : rows
      wire [Y_WIDTH:0] carry;
      wire [Y_WIDTH-1:0] sum = sums[Y_WIDTH*row+:Y_WIDTH];
      wire [Y_WIDTH-1:0] part = b[row] ? a << row : 0;
      assign carry[0] = 0;
      for (i = 0; i < Y_WIDTH; i = i + 1) begin : adders
        assign sums[Y_WIDTH*(row+1)+i] = sum[i] ^ part[i] ^ carry[i];
        assign carry[i+1] = sum[i] & part[i] | carry[i] & (sum[i] ^ part[i]);
      end
    end
    assign Y = sums[Y_WIDTH*Y_WIDTH+:Y_WIDTH];
  endgenerate
endmodule
