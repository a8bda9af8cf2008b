// What a clock of plain RTL costs on this machine: the measure that speed.cpp gives the engines' speeds in.
//
// Sixteen channels, each a counter with its end, a shift register with feedback and a filter that follows it: some
// of all that the drive does in a clock (adders, comparisons, choices, enables), and nothing that changes with the
// drive.  Every ratio in docs/speed.md is a ratio to this: who changes it measures the page anew.
module yardstick (
    input logic clk,
    input logic rst,
    input logic [15:0] period,
    output logic [31:0] watch
);
  logic [15:0] count[16];
  logic [22:0] noise[16];
  logic signed [31:0] level[16];
  logic [15:0] high;

  for (genvar i = 0; i < 16; ++i) begin : channel
    wire ends = count[i] >= period + 16'(i);
    always_ff @(posedge clk) begin
      count[i] <= ends ? 16'd0 : count[i] + 16'd1;
      if (ends || count[i][3:0] == 4'(i)) noise[i] <= {noise[i][21:0], noise[i][22] ^ noise[i][17]};
      if (ends) level[i] <= level[i] + {{12{noise[i][15]}}, noise[i][15:0], 4'd0} - (level[i] >>> 5);
      high[i] <= count[i] < level[i][20:5];
      if (rst) begin
        count[i] <= 16'd0;
        noise[i] <= 23'(i + 1);
        level[i] <= 32'd0;
        high[i] <= 1'b0;
      end
    end
  end
  always_comb begin
    watch = {16'd0, high};
    for (int i = 0; i < 16; ++i) watch ^= level[i];
  end
endmodule
