// open_loop_duty: steplock::OpenLoopDuty, printed by hlsgen from hls/six_step/open_loop_duty.hpp:25.
// Do not edit: change the C++ and print again.

module open_loop_duty (
    input  logic        clk,
    input  logic        rst,  // synchronous, active high
    input  logic [10:0] state_bits_i,  // public, for a set to be a port
    input  logic        strong_i,  // two tries failed
    input  logic        commutate_i,  // strobe: a new step began
    input  logic        lags_i,  // the last error was negative: the rotor lags the VCO
    input  logic [15:0] reset_duty_i,  // u1.15
    input  logic [15:0] start_duty_i,  // u1.15
    input  logic [15:0] brake_duty_i,  // u1.15
    output logic [15:0] duty_o  // u1.15, of the state a clock ago
);
  logic [15:0] duty;  // u1.15, of the state a clock ago; in kPullIn it fades
  logic faded;  // it is below the start's

  wire [15:0] start =  // line 68
      strong_i ? ((start_duty_i[15:14] == 2'd0) ? {start_duty_i[14:0], 1'b0} : 16'd32768) :
      start_duty_i;
  wire inverse = !lags_i;
  wire [12:0] change = {{1'b0, duty[15:5]} ^ {12{inverse}}, 1'b0} | {12'd0, inverse};  // line 55
  wire [16:0] change_2 = {{4{change[12]}}, change};  // line 55
  wire [16:0] sum_56 = {duty, 1'b1} + change_2;  // line 56

  always_ff @(posedge clk) begin
    if (state_bits_i[6]) begin
      if (commutate_i && (inverse || faded)) begin
        duty <= sum_56[16:1];
      end
    end else if (state_bits_i[5]) begin
      duty <= start;
    end else if (state_bits_i[4:3] == 2'd0) begin
      if (state_bits_i[2]) begin
        duty <= brake_duty_i;
      end else begin
        duty <= 16'd0;
      end
    end else if (strong_i) begin
      if (reset_duty_i[15:14] == 2'd0) begin
        duty <= {reset_duty_i[14:0], 1'b0};
      end else begin
        duty <= 16'd32768;
      end
    end else begin
      duty <= reset_duty_i;
    end
    faded <= duty < start;  // line 47
    if (rst) begin
      duty <= 16'd0;
      faded <= 1'b0;
    end
  end

  assign duty_o = duty;

  // What nothing reads, for the linters.
  wire unused = &{1'b0, state_bits_i[1:0], state_bits_i[10:7], sum_56[0]};
endmodule
