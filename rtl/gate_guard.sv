// gate_guard: steplock::GateGuard<12>, printed by hlsgen from hls/bridge/gate_guard.hpp:29.
// Do not edit: change the C++ and print again.

module gate_guard (
    input  logic       clk,
    input  logic       rst,  // synchronous, active high
    input  logic       request_uh_i,  // phase U, high side
    input  logic       request_ul_i,  // phase U, low side
    input  logic       request_vh_i,  // phase V, high side
    input  logic       request_vl_i,  // phase V, low side
    input  logic       request_wh_i,  // phase W, high side
    input  logic       request_wl_i,  // phase W, low side
    input  logic       enable_i,  // false: all six off
    input  logic       fault_i,  // true: all six off
    input  logic [7:0] dead_time_i,  // clocks; Floor if that is more
    input  logic [7:0] minimum_i,  // clocks of on-time at least
    output logic       uh_o,  // phase U, high side
    output logic       ul_o,  // phase U, low side
    output logic       vh_o,  // phase V, high side
    output logic       vl_o,  // phase V, low side
    output logic       wh_o,  // phase W, high side
    output logic       wl_o  // phase W, low side
);
  wire either_44 = fault_i || !enable_i;  // line 44
  wire [7:0] dead = (dead_time_i[7:2] < 6'd3) ? 8'd12 : dead_time_i;  // line 45

  wire u_high;
  wire u_low;
  guarded_leg u (
      .clk(clk),
      .rst(rst),
      .high_i(request_uh_i),
      .low_i(request_ul_i),
      .off_i(either_44),
      .dead_time_i(dead),
      .minimum_i(minimum_i),
      .high_o(u_high),
      .low_o(u_low)
  );

  wire v_high;
  wire v_low;
  guarded_leg v (
      .clk(clk),
      .rst(rst),
      .high_i(request_vh_i),
      .low_i(request_vl_i),
      .off_i(either_44),
      .dead_time_i(dead),
      .minimum_i(minimum_i),
      .high_o(v_high),
      .low_o(v_low)
  );

  wire w_high;
  wire w_low;
  guarded_leg w (
      .clk(clk),
      .rst(rst),
      .high_i(request_wh_i),
      .low_i(request_wl_i),
      .off_i(either_44),
      .dead_time_i(dead),
      .minimum_i(minimum_i),
      .high_o(w_high),
      .low_o(w_low)
  );

  assign uh_o = u_high;
  assign ul_o = u_low;
  assign vh_o = v_high;
  assign vl_o = v_low;
  assign wh_o = w_high;
  assign wl_o = w_low;
endmodule
