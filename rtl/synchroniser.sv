// synchroniser: steplock::Synchroniser, printed by hlsgen from hls/bridge/synchroniser.hpp:16.
// Do not edit: change the C++ and print again.

module synchroniser (
    input  logic clk,
    input  logic rst,  // synchronous, active high
    input  logic comparator_u_i,  // terminal U above the reference
    input  logic comparator_v_i,  // terminal V above the reference
    input  logic comparator_w_i,  // terminal W above the reference
    input  logic limit_i,  // shunt current above the limit
    input  logic fault_i,  // external fault, active high
    input  logic hall_u_i,  // Hall sensor U
    input  logic hall_v_i,  // Hall sensor V
    input  logic hall_w_i,  // Hall sensor W
    output logic comparator_u_o,  // terminal U above the reference
    output logic comparator_v_o,  // terminal V above the reference
    output logic comparator_w_o,  // terminal W above the reference
    output logic limit_o,  // shunt current above the limit
    output logic fault_o,  // external fault, active high
    output logic hall_u_o,  // Hall sensor U
    output logic hall_v_o,  // Hall sensor V
    output logic hall_w_o  // Hall sensor W
);
  (* ASYNC_REG = "TRUE", syn_preserve = 1,
     altera_attribute = "-name SYNCHRONIZER_IDENTIFICATION FORCED" *)
  logic
      first_comparator_u,  // terminal U above the reference
      first_comparator_v,  // terminal V above the reference
      first_comparator_w,  // terminal W above the reference
      first_limit,  // shunt current above the limit
      first_fault,  // external fault, active high
      first_hall_u,  // Hall sensor U
      first_hall_v,  // Hall sensor V
      first_hall_w,  // Hall sensor W
      second_comparator_u,  // terminal U above the reference
      second_comparator_v,  // terminal V above the reference
      second_comparator_w,  // terminal W above the reference
      second_limit,  // shunt current above the limit
      second_fault,  // external fault, active high
      second_hall_u,  // Hall sensor U
      second_hall_v,  // Hall sensor V
      second_hall_w;  // Hall sensor W

  always_ff @(posedge clk) begin
    first_comparator_u <= comparator_u_i;
    first_comparator_v <= comparator_v_i;
    first_comparator_w <= comparator_w_i;
    first_limit <= limit_i;
    first_fault <= fault_i;
    first_hall_u <= hall_u_i;
    first_hall_v <= hall_v_i;
    first_hall_w <= hall_w_i;
    second_comparator_u <= first_comparator_u;
    second_comparator_v <= first_comparator_v;
    second_comparator_w <= first_comparator_w;
    second_limit <= first_limit;
    second_fault <= first_fault;
    second_hall_u <= first_hall_u;
    second_hall_v <= first_hall_v;
    second_hall_w <= first_hall_w;
    if (rst) begin
      first_comparator_u <= 1'b0;
      first_comparator_v <= 1'b0;
      first_comparator_w <= 1'b0;
      first_limit <= 1'b0;
      first_fault <= 1'b0;
      first_hall_u <= 1'b0;
      first_hall_v <= 1'b0;
      first_hall_w <= 1'b0;
      second_comparator_u <= 1'b0;
      second_comparator_v <= 1'b0;
      second_comparator_w <= 1'b0;
      second_limit <= 1'b0;
      second_fault <= 1'b0;
      second_hall_u <= 1'b0;
      second_hall_v <= 1'b0;
      second_hall_w <= 1'b0;
    end
  end

  assign comparator_u_o = second_comparator_u;
  assign comparator_v_o = second_comparator_v;
  assign comparator_w_o = second_comparator_w;
  assign limit_o = second_limit;
  assign fault_o = second_fault;
  assign hall_u_o = second_hall_u;
  assign hall_v_o = second_hall_v;
  assign hall_w_o = second_hall_w;
endmodule
