// Yosys' comparison with a constant, unsigned or signed, as a tree of look-up tables: for `techmap -map`, before
// synth_* makes a carry chain of it.  A pair of bits, then of pairs, says which of the two numbers is less.
(* techmap_celltype = "$lt $le $gt $ge" *)
module compare_with_constant (A, B, Y);
  parameter A_SIGNED = 0, B_SIGNED = 0, A_WIDTH = 1, B_WIDTH = 1, Y_WIDTH = 1;
  parameter _TECHMAP_CELLTYPE_ = "";
  parameter [A_WIDTH-1:0] _TECHMAP_CONSTMSK_A_ = 0;
  parameter [B_WIDTH-1:0] _TECHMAP_CONSTMSK_B_ = 0;
  input [A_WIDTH-1:0] A;
  input [B_WIDTH-1:0] B;
  output [Y_WIDTH-1:0] Y;

  wire _TECHMAP_FAIL_ = A_SIGNED != B_SIGNED || !(&_TECHMAP_CONSTMSK_A_ || &_TECHMAP_CONSTMSK_B_);

  localparam BITS = A_WIDTH > B_WIDTH ? A_WIDTH : B_WIDTH;
  localparam LEAVES = 1 << $clog2(BITS);
  // A sign counts the other way round.
  wire [LEAVES-1:0] sign = A_SIGNED ? 1 << (LEAVES - 1) : 0;
  wire [LEAVES-1:0] a = (A_SIGNED ? {{LEAVES{A[A_WIDTH-1]}}, A} : A) ^ sign;
  wire [LEAVES-1:0] b = (A_SIGNED ? {{LEAVES{B[B_WIDTH-1]}}, B} : B) ^ sign;
  wire [2*LEAVES-1:0] less, more;

  genvar i;
  generate
    for (i = 0; i < LEAVES; i = i + 1) begin
      assign less[LEAVES+i] = ~a[i] & b[i], more[LEAVES+i] = a[i] & ~b[i];
    end
    for (i = 1; i < LEAVES; i = i + 1) begin
      assign less[i] = less[2*i+1] | (less[2*i] & ~more[2*i+1]);
      assign more[i] = more[2*i+1] | (more[2*i] & ~less[2*i+1]);
    end
  endgenerate

  assign Y = _TECHMAP_CELLTYPE_ == "$lt" ? less[1] :
             _TECHMAP_CELLTYPE_ == "$gt" ? more[1] :
             _TECHMAP_CELLTYPE_ == "$le" ? !more[1] : !less[1];
endmodule
