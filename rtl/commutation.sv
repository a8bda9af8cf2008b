// commutation: steplock::Commutation, printed by hlsgen from hls/six_step/commutation.hpp:34.
// Do not edit: change the C++ and print again.

module commutation (
    input  logic [2:0] pattern_i,  // kSettle is step 1, whatever `step` says
    input  logic [2:0] step_i,  // 0 to 5; 6 and 7 are off
    input  logic       chop_i,  // PWM and current limit: on
    input  logic       complementary_i,  // low side of a chopped leg on while chop is off
    output logic       uh_o,  // phase U, high side
    output logic       ul_o,  // phase U, low side
    output logic       vh_o,  // phase V, high side
    output logic       vl_o,  // phase V, low side
    output logic       wh_o,  // phase W, high side
    output logic       wl_o  // phase W, low side
);
  localparam logic [2:0] Pattern_kDrive = 3'd1;
  localparam logic [2:0] Pattern_kSettle = 3'd2;
  localparam logic [2:0] Pattern_kReset = 3'd3;
  localparam logic [2:0] Pattern_kBrake = 3'd4;

  wire [2:0] step = (pattern_i == Pattern_kSettle) ? 3'd1 : step_i;  // line 48
  wire either = pattern_i == Pattern_kSettle || pattern_i == Pattern_kDrive;
  wire either_2 = pattern_i == Pattern_kReset || (either && step[2:1] == 2'd0);
  wire both_51 = pattern_i == Pattern_kBrake && chop_i;  // line 51
  wire both_58 = complementary_i && !chop_i;  // line 58
  wire [2:0] sum_55 = step - 3'd3;  // line 55
  wire either_3 = pattern_i == Pattern_kReset || (either && $signed(step) > 3'sd1);
  wire both_56 = pattern_i != Pattern_kSettle && step_i == 3'd0;  // line 56
  wire both = either && (both_56 || (pattern_i != Pattern_kSettle && step_i == 3'd5));
  wire both_2 = either && step[2] && !step[1];
  wire [2:0] sum_57 = step - 3'd1;  // line 57
  wire either_4 = pattern_i == Pattern_kReset || (either && sum_57[2:1] == 2'd0);

  assign uh_o = either_2 && chop_i;
  assign ul_o = (either && sum_55[2:1] == 2'd0) || both_51 || (either_2 && both_58);
  assign vh_o = either_3 && chop_i;
  assign vl_o = both || both_51 || (either_3 && both_58);
  assign wh_o = both_2 && chop_i;
  assign wl_o = either_4 || both_51 || (both_2 && both_58);

  // What nothing reads, for the linters.
  wire unused = &{1'b0, sum_55[0], sum_57[0]};
endmodule
