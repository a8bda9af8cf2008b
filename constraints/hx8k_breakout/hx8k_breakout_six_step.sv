// iCE40-HX8K breakout board: PLL, pads, reset and LEDs around six_step_fixed, the drive of one motor
// (steplock design FILE --verilog).  The PLL makes 36 MHz of the board's 12 MHz.
//
// Doc: docs/boards.md   Pins: hx8k_breakout.pcf   Test: tests/boards/CMakeLists.txt

module hx8k_breakout_six_step (
    input  logic       clk_12mhz,
    input  logic       run,
    input  logic       reverse,
    input  logic [1:0] speed,         // 0 to 3: a quarter to the whole of the set speed
    input  logic       comparator_u,
    input  logic       comparator_v,
    input  logic       comparator_w,
    input  logic       limit,
    input  logic       fault_n,       // of the gate driver: open drain, low on fault
    input  logic       hall_u,
    input  logic       hall_v,
    input  logic       hall_w,
    output logic       gate_uh,
    output logic       gate_ul,
    output logic       gate_vh,
    output logic       gate_vl,
    output logic       gate_wh,
    output logic       gate_wl,
    output logic       turn,          // a tachometer: one period per electrical turn
    output logic       led_locked,
    output logic       led_fault
);
  logic clk, stable, rst;

  // 12 MHz / (DIVR + 1) * (DIVF + 1) / 2^DIVQ
  SB_PLL40_CORE #(
      .FEEDBACK_PATH("SIMPLE"), .DIVR(4'd0), .DIVF(7'd47), .DIVQ(3'd4), .FILTER_RANGE(3'd1)
  ) pll (
      .REFERENCECLK(clk_12mhz), .RESETB(1'b1), .BYPASS(1'b0), .LOCK(stable), .PLLOUTGLOBAL(clk)
  );

  power_on_reset reset (.clk(clk), .hold(!stable), .rst(rst));

  six_step_fixed drive (
      .clk(clk), .rst(rst),
      .pins_comparator_u_i(comparator_u), .pins_comparator_v_i(comparator_v),
      .pins_comparator_w_i(comparator_w), .pins_limit_i(limit), .pins_fault_i(!fault_n),
      .pins_hall_u_i(hall_u), .pins_hall_v_i(hall_v), .pins_hall_w_i(hall_w),
      .controls_run_i(run), .controls_reverse_i(reverse), .controls_speed_i(speed),
      .brake_to_stop_i(1'b0),
      .gates_uh_o(gate_uh), .gates_ul_o(gate_ul), .gates_vh_o(gate_vh),
      .gates_vl_o(gate_vl), .gates_wh_o(gate_wh), .gates_wl_o(gate_wl),
      .locked_o(led_locked), .fault_o(led_fault), .turn_o(turn)
  );
endmodule
