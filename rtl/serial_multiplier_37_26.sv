// serial_multiplier_37_26: steplock::SerialMultiplier<37, 26>, printed by hlsgen from hls/numeric/serial_multiplier.hpp:23.
// Do not edit: change the C++ and print again.

module serial_multiplier_37_26 (
    input  logic        clk,
    input  logic        rst,  // synchronous, active high
    input  logic        start_i,  // takes b, begins with a
    input  logic [36:0] a_i,  // hold from start to done
    input  logic [25:0] b_i,  // needed in the clock of start alone
    output logic [62:0] product_o,  // valid from done to the next start
    output logic        done_o,  // one clock
    output logic        busy_o  // from the clock after start to the one before done
);
  logic [36:0] high;  // the product so far, its upper bits
  logic [25:0] low;  // above: its lower bits; below: the bits of b still to come
  logic [36:0] addend;  // a, or 0 where the bit of b is 0
  logic [4:0] left;  // clocks
  logic done;  // the product is complete

  wire [37:0] sum = {high[36], high} + {addend[36], addend};  // line 45
  wire either_47 = start_i || left == 5'd0;  // line 47
  wire [1:0] choice = start_i ? {1'b0, b_i[0]} : {low[1], 1'b0};

  always_ff @(posedge clk) begin
    if (rst) begin
      high <= 37'sd0;
      low <= 26'd0;
      addend <= 37'sd0;
      left <= 5'd0;
      done <= 1'b0;
    end else begin
      if (either_47) begin
        if (start_i) begin
          high <= 37'd0;
          low <= b_i;
          left <= 5'd26;
        end
      end else begin
        high <= sum[37:1];
        low <= {sum[0], low[25:1]};
        left <= left - 5'd1;
      end
      if (choice == 2'd0) begin  // line 56
        addend <= 37'd0;
      end else begin
        addend <= a_i;
      end
      done <= !start_i && left == 5'd1;  // line 46
    end
  end

  assign product_o = {high, 26'd0} | {37'd0, low};
  assign done_o = done;
  assign busy_o = left != 5'd0;
endmodule
