// ULX3S: pads, reset and LEDs around six_step_fixed, the drive of one motor (steplock design FILE
// --verilog).  It runs from the 25 MHz oscillator itself; no PLL.
//
// Doc: docs/boards.md   Pins: ulx3s.lpf   Test: tests/boards/CMakeLists.txt

module ulx3s_six_step (
    input  logic clk_25mhz,
    input  logic button_reset_n,
    input  logic button_run,      // the motor turns while it is held
    input  logic button_reverse,
    input  logic button_fast,     // the whole set speed; else half of it
    input  logic comparator_u,
    input  logic comparator_v,
    input  logic comparator_w,
    input  logic limit,
    input  logic fault_n,         // of the gate driver: open drain, low on fault
    input  logic hall_u,
    input  logic hall_v,
    input  logic hall_w,
    output logic gate_uh,
    output logic gate_ul,
    output logic gate_vh,
    output logic gate_vl,
    output logic gate_wh,
    output logic gate_wl,
    output logic turn,            // a tachometer: one period per electrical turn
    output logic led_locked,
    output logic led_fault,
    output logic wifi_gpio0       // low would put the ESP32 beside it into its boot loader
);
  logic rst;

  power_on_reset reset (.clk(clk_25mhz), .hold(!button_reset_n), .rst(rst));

  six_step_fixed drive (
      .clk(clk_25mhz), .rst(rst),
      .pins_comparator_u_i(comparator_u), .pins_comparator_v_i(comparator_v),
      .pins_comparator_w_i(comparator_w), .pins_limit_i(limit), .pins_fault_i(!fault_n),
      .pins_hall_u_i(hall_u), .pins_hall_v_i(hall_v), .pins_hall_w_i(hall_w),
      .controls_run_i(button_run), .controls_reverse_i(button_reverse),
      .controls_speed_i({button_fast, 1'b1}), .brake_to_stop_i(1'b0),
      .gates_uh_o(gate_uh), .gates_ul_o(gate_ul), .gates_vh_o(gate_vh),
      .gates_vl_o(gate_vl), .gates_wh_o(gate_wh), .gates_wl_o(gate_wl),
      .locked_o(led_locked), .fault_o(led_fault), .turn_o(turn)
  );

  assign wifi_gpio0 = 1'b1;
endmodule
