// iCEBreaker: pads, reset and LEDs around six_step_fixed, the drive of one motor (steplock design
// FILE --verilog).  It runs from the 12 MHz oscillator itself; no PLL.  The FPGA's own oscillator watches that one: where it stops, the
// gates are off 3 us later.
//
// Doc: docs/boards.md   Pins: icebreaker.pcf   Test: tests/boards/CMakeLists.txt

module icebreaker_six_step (
    input  logic clk_12mhz,
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
    output logic led_locked_n,
    output logic led_fault_n
);
  logic rst, locked, fault, other, alive;
  logic [5:0] gates;

  SB_HFOSC #(.CLKHF_DIV("0b11")) oscillator (.CLKHFPU(1'b1), .CLKHFEN(1'b1), .CLKHF(other));  // 48 MHz / 8
  clock_watch watch (.clk(clk_12mhz), .other(other), .alive(alive));
  power_on_reset reset (.clk(clk_12mhz), .hold(!button_reset_n || !alive), .rst(rst));
  assign {gate_uh, gate_ul, gate_vh, gate_vl, gate_wh, gate_wl} = gates & {6{alive}};

  six_step_fixed drive (
      .clk(clk_12mhz), .rst(rst),
      .pins_comparator_u_i(comparator_u), .pins_comparator_v_i(comparator_v),
      .pins_comparator_w_i(comparator_w), .pins_limit_i(limit), .pins_fault_i(!fault_n),
      .pins_hall_u_i(hall_u), .pins_hall_v_i(hall_v), .pins_hall_w_i(hall_w),
      .controls_run_i(button_run), .controls_reverse_i(button_reverse),
      .controls_speed_i({button_fast, 1'b1}), .brake_to_stop_i(1'b0),
      .gates_uh_o(gates[5]), .gates_ul_o(gates[4]), .gates_vh_o(gates[3]),
      .gates_vl_o(gates[2]), .gates_wh_o(gates[1]), .gates_wl_o(gates[0]),
      .locked_o(locked), .fault_o(fault), .turn_o(turn)
  );

  assign led_locked_n = !locked;
  assign led_fault_n = !fault;
endmodule
