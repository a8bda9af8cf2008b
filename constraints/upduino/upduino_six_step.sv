// UPduino 3: oscillator, pads, reset and LEDs around six_step_fixed, the drive of one motor (steplock
// design FILE --verilog).  The FPGA's own oscillator, 48 MHz / 4, needs no jumper and is good to 10 %:
// so is the speed.
//
// Doc: docs/boards.md   Pins: upduino.pcf   Test: tests/boards/CMakeLists.txt

module upduino_six_step (
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
    output logic       led_green,     // locked
    output logic       led_blue,      // never
    output logic       led_red        // fault
);
  logic clk, rst, locked, fault;

  SB_HFOSC #(.CLKHF_DIV("0b10")) oscillator (.CLKHFPU(1'b1), .CLKHFEN(1'b1), .CLKHF(clk));

  power_on_reset reset (.clk(clk), .hold(1'b0), .rst(rst));

  six_step_fixed drive (
      .clk(clk), .rst(rst),
      .pins_comparator_u_i(comparator_u), .pins_comparator_v_i(comparator_v),
      .pins_comparator_w_i(comparator_w), .pins_limit_i(limit), .pins_fault_i(!fault_n),
      .pins_hall_u_i(hall_u), .pins_hall_v_i(hall_v), .pins_hall_w_i(hall_w),
      .controls_run_i(run), .controls_reverse_i(reverse), .controls_speed_i(speed),
      .brake_to_stop_i(1'b0),
      .gates_uh_o(gate_uh), .gates_ul_o(gate_ul), .gates_vh_o(gate_vh),
      .gates_vl_o(gate_vl), .gates_wh_o(gate_wh), .gates_wl_o(gate_wl),
      .locked_o(locked), .fault_o(fault), .turn_o(turn)
  );

  SB_RGBA_DRV #(
      .CURRENT_MODE("0b1"),  // half: 2 mA each
      .RGB0_CURRENT("0b000001"), .RGB1_CURRENT("0b000001"), .RGB2_CURRENT("0b000001")
  ) leds (
      .CURREN(1'b1), .RGBLEDEN(1'b1), .RGB0PWM(locked), .RGB1PWM(1'b0), .RGB2PWM(fault),
      .RGB0(led_green), .RGB1(led_blue), .RGB2(led_red)
  );
endmodule
