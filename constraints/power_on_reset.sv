// Power-on reset for FPGAs whose flip-flops wake up as their initial values say (iCE40 does): `rst` is
// high for 2^10 clocks after configuration, and again after `hold`, which is asynchronous.
//
// Doc: docs/boards.md   Test: tests/boards/CMakeLists.txt

module power_on_reset (
    input  logic clk,
    input  logic hold,
    output logic rst
);
  // Of Vivado, Synplify and Lattice's own synthesis, and Quartus: two flip-flops close to each other.
  (* ASYNC_REG = "TRUE", syn_preserve = 1,
     altera_attribute = "-name SYNCHRONIZER_IDENTIFICATION FORCED" *)
  logic [1:0] held = 2'b00;
  logic [9:0] clocks = 10'd0;
  initial rst = 1'b1;

  always_ff @(posedge clk) begin
    held <= {held[0], hold};
    if (held[1]) clocks <= 10'd0;
    else if (clocks != 10'h3ff) clocks <= clocks + 10'd1;
    rst <= clocks != 10'h3ff;
  end
endmodule
