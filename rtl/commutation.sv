// commutation: steplock::Commutation, printed by hlsgen from hls/six_step/commutation.hpp:35.
// Do not edit: change the C++ and print again.

module commutation (
    input  logic [4:0] pattern_bits_i,  // public, for a set to be a port
    input  logic       legs_uh_i,  // phase U, high side
    input  logic       legs_ul_i,  // phase U, low side
    input  logic       legs_vh_i,  // phase V, high side
    input  logic       legs_vl_i,  // phase V, low side
    input  logic       legs_wh_i,  // phase W, high side
    input  logic       legs_wl_i,  // phase W, low side
    input  logic       chop_i,  // PWM and current limit: on
    input  logic       complementary_i,  // low side of a chopped leg on while chop is off
    output logic       uh_o,  // phase U, high side
    output logic       ul_o,  // phase U, low side
    output logic       vh_o,  // phase V, high side
    output logic       vl_o,  // phase V, low side
    output logic       wh_o,  // phase W, high side
    output logic       wl_o  // phase W, low side
);
  wire either = pattern_bits_i[3] || pattern_bits_i[2] || (pattern_bits_i[1] && legs_uh_i);
  wire both_60 = pattern_bits_i[4] && chop_i;  // line 60
  wire both_64 = complementary_i && !chop_i;  // line 64
  wire either_62 = pattern_bits_i[3] || (pattern_bits_i[1] && legs_vh_i);  // line 62
  wire both_63 = pattern_bits_i[1] && legs_wh_i;  // line 63

  assign uh_o = either && chop_i;
  assign ul_o = (pattern_bits_i[1] && legs_ul_i) || both_60 || (either && both_64);
  assign vh_o = either_62 && chop_i;
  assign vl_o = (pattern_bits_i[1] && legs_vl_i) || both_60 || (either_62 && both_64);
  assign wh_o = both_63 && chop_i;
  assign wl_o =
      pattern_bits_i[3:2] != 2'd0 || (pattern_bits_i[1] && legs_wl_i) ||
      both_60 || (both_63 && both_64);

  // What nothing reads, for the linters.
  wire unused = &{1'b0, pattern_bits_i[0]};
endmodule
