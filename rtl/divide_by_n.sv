// divide_by_n: steplock::DivideByN, printed by hlsgen from hls/six_step/divide_by_n.hpp:30.
// Do not edit: change the C++ and print again.

module divide_by_n (
    input  logic        clk,
    input  logic        rst,  // synchronous, active high
    input  logic        pulse_i,  // the VCO completed a turn; the last load or turn was two clocks ago, or more
    input  logic [15:0] phase_i,  // u0.16, VCO turns
    input  logic [1:0]  divide_i,  // N = 6 * 2^divide
    input  logic        reverse_i,  // step counts down; counts from the next clock on
    input  logic        hold_i,  // turns do not move the step: a sensor will
    input  logic        load_i,  // takes `step`, from the middle or the beginning; wins over a pulse
    input  logic [2:0]  step_i,  // 0 to 5
    input  logic        half_i,  // load the middle of the step (the VCO: half a turn if divide is 0)
    output logic [2:0]  step_o,  // 0 to 5
    output logic [15:0] phase_o,  // u0.16, turns of one step
    output logic        commutate_o,  // one clock, the first of a new step
    output logic        elapsed_o,  // one clock: a step's worth of VCO turns is over, even if held
    output logic [2:0]  turned_o  // the step, but for a load in this clock: ready before it
);
  logic [2:0] sub;  // VCO turns into the step
  logic [2:0] step;
  logic [2:0] next;  // the one after, a clock after the step: turns are many clocks apart

  wire [1:0] choice = (divide_i == 2'd2) ? 2'd3 : {1'b0, divide_i == 2'd1};
  wire [2:0] wide = {1'b0, choice};
  wire [2:0] last = (divide_i == 2'd3) ? 3'd7 : wide;
  wire at_most = last <= sub;
  wire either_55 = !(pulse_i && at_most) || hold_i;  // line 55
  wire [2:0] step_next =
      load_i ? step_i :
      (pulse_i && !either_55) ? next :
      step;
  wire [3:0] sum_59 = {1'b0, last} + 4'd1;  // line 59
  wire elapsed = !load_i && pulse_i && at_most;  // line 54
  wire [2:0] sub_next =
      load_i ? (half_i ? sum_59[3:1] : 3'd0) :
      pulse_i ? ((!load_i && at_most) ? 3'd0 : sub + 3'd1) :
      sub;
  wire [18:0] shifted_76 = ({sub_next, 16'd0} | {3'd0, phase_i}) >> divide_i;  // line 76

  always_ff @(posedge clk) begin
    sub <= sub_next;
    step <= step_next;
    if (reverse_i) begin
      if (step == 3'd0) begin
        next <= 3'd5;
      end else begin
        next <= step - 3'd1;
      end
    end else if (step > 3'd4) begin
      next <= 3'd0;
    end else begin
      next <= step + 3'd1;
    end
    if (rst) begin
      sub <= 3'd0;
      step <= 3'd0;
      next <= 3'd1;
    end
  end

  assign step_o = step_next;
  assign phase_o = shifted_76[15:0];
  assign commutate_o = load_i || (elapsed && !hold_i);
  assign elapsed_o = elapsed;
  assign turned_o = either_55 ? step : next;

  // What nothing reads, for the linters.
  wire unused = &{1'b0, sum_59[0], shifted_76[18:16]};
endmodule
