// divide_by_n: steplock::DivideByN, printed by hlsgen from hls/six_step/divide_by_n.hpp:33.
// Do not edit: change the C++ and print again.

module divide_by_n (
    input  logic        clk,
    input  logic        rst,  // synchronous, active high
    input  logic        pulse_i,  // the VCO completed a turn
    input  logic [15:0] phase_i,  // u0.16, VCO turns
    input  logic [1:0]  divide_i,  // N = 6 * 2^divide
    input  logic        reverse_i,  // step counts down
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

  wire either_27 = step[1:0] == 2'd3 || (step[2] && !step[0]);  // line 27
  wire choice_29 =  // line 29
      (!reverse_i || step[2]) ? (reverse_i ? step[0] : either_27) : !step[1] && !step[0];
  wire [1:0] choice_30 = (reverse_i ? either_27 : (step[1] ^ step[0]) && !step[2]) ? 2'd2 : 2'd0;
  wire [2:0] wide_30 = {1'b0, choice_30};  // line 30
  wire [2:0] turned = (choice_29 ? 3'd4 : 3'd0) | wide_30 | {2'd0, !step[0]};  // line 30
  wire [1:0] choice_58 = (divide_i == 2'd2) ? 2'd3 : {1'b0, divide_i == 2'd1};  // line 58
  wire [2:0] wide_58 = {1'b0, choice_58};  // line 58
  wire [2:0] last = (divide_i == 2'd3) ? 3'd7 : wide_58;  // line 58
  wire below_58 = sub < last;  // line 58
  wire [2:0] step_next =
      load_i ? step_i :
      (pulse_i && !(below_58 || hold_i)) ? turned :
      step;
  wire [3:0] sum_61 = {1'b0, last} + 4'd1;  // line 61
  wire at_most = last <= sub;
  wire elapsed = !load_i && pulse_i && at_most;
  wire [2:0] sub_next =
      load_i ? (half_i ? sum_61[3:1] : 3'd0) :
      pulse_i ? ((at_most && !load_i) ? 3'd0 : sub + 3'd1) :
      sub;
  wire [18:0] shifted_78 = ({sub_next, 16'd0} | {3'd0, phase_i}) >> divide_i;  // line 78

  always_ff @(posedge clk) begin
    sub <= sub_next;
    step <= step_next;
    if (rst) begin
      sub <= 3'd0;
      step <= 3'd0;
    end
  end

  assign step_o = step_next;
  assign phase_o = shifted_78[15:0];
  assign commutate_o = load_i || (elapsed && !hold_i);
  assign elapsed_o = elapsed;
  assign turned_o = (!pulse_i || below_58 || hold_i) ? step : turned;

  // What nothing reads, for the linters.
  wire unused = &{1'b0, sum_61[0], shifted_78[18:16]};
endmodule
