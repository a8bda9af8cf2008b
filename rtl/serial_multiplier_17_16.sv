// serial_multiplier_17_16: steplock::SerialMultiplier<17, 16>, printed by hlsgen from hls/numeric/serial_multiplier.hpp:23.
// Do not edit: change the C++ and print again.

module serial_multiplier_17_16 (
    input  logic        clk,
    input  logic        rst,  // synchronous, active high
    input  logic        start_i,  // takes b, begins with a
    input  logic [16:0] a_i,  // hold from start to done
    input  logic [15:0] b_i,  // needed in the clock of start alone
    output logic [32:0] product_o,  // valid from done to the next start
    output logic        done_o,  // one clock
    output logic        busy_o  // from the clock after start to the one before done
);
  logic [16:0] high;  // the product so far, its upper bits
  logic [15:0] low;  // above: its lower bits; below: the bits of b still to come
  logic [16:0] addend;  // a, or 0 where the bit of b is 0
  logic [4:0] left;  // clocks
  logic done;  // the product is complete

  wire [17:0] sum = {high[16], high} + {addend[16], addend};  // line 45
  wire either_47 = start_i || left == 5'd0;  // line 47
  wire [1:0] choice = start_i ? {1'b0, b_i[0]} : {low[1], 1'b0};

  always_ff @(posedge clk) begin
    if (rst) begin
      high <= 17'sd0;
      low <= 16'd0;
      addend <= 17'sd0;
      left <= 5'd0;
      done <= 1'b0;
    end else begin
      if (either_47) begin
        if (start_i) begin
          high <= 17'd0;
          low <= b_i;
          left <= 5'd16;
        end
      end else begin
        high <= sum[17:1];
        low <= {sum[0], low[15:1]};
        left <= left - 5'd1;
      end
      if (choice == 2'd0) begin  // line 56
        addend <= 17'd0;
      end else begin
        addend <= a_i;
      end
      done <= !start_i && left == 5'd1;  // line 46
    end
  end

  assign product_o = {high, 16'd0} | {17'd0, low};
  assign done_o = done;
  assign busy_o = left != 5'd0;
endmodule
