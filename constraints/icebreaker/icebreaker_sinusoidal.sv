// iCEBreaker: PLL, pads, reset and LEDs around sinusoidal_fixed, the drive of one motor with sinusoidal
// currents (steplock design FILE --verilog).  The PLL makes 24 MHz of the board's 12 MHz.
//
// The ADC is an AD7928 with u on input 0, v on 1 and the dc voltage on 2.
//
// Doc: docs/boards.md   Pins: icebreaker_sinusoidal.pcf   Test: tests/boards/CMakeLists.txt

module icebreaker_sinusoidal (
    input  logic clk_12mhz,
    input  logic button_reset_n,
    input  logic button_run,      // the motor turns while it is held
    input  logic button_reverse,
    input  logic button_fast,     // the whole set speed; else half of it
    input  logic fault_n,         // of the gate driver: open drain, low on fault
    output logic gate_uh,
    output logic gate_ul,
    output logic gate_vh,
    output logic gate_vl,
    output logic gate_wh,
    output logic gate_wl,
    output logic adc_cs_n,
    output logic adc_sclk,
    output logic adc_din,
    input  logic adc_dout,
    output logic turn,            // a tachometer: one period per electrical turn
    output logic led_locked_n,
    output logic led_fault_n
);
  logic clk, stable, rst, locked, fault;

  // 12 MHz / (DIVR + 1) * (DIVF + 1) / 2^DIVQ; the oscillator's pin is the PLL's own pad
  SB_PLL40_PAD #(
      .FEEDBACK_PATH("SIMPLE"), .DIVR(4'd0), .DIVF(7'd63), .DIVQ(3'd5), .FILTER_RANGE(3'd1)
  ) pll (
      .PACKAGEPIN(clk_12mhz), .RESETB(1'b1), .BYPASS(1'b0), .LOCK(stable), .PLLOUTGLOBAL(clk)
  );

  power_on_reset reset (.clk(clk), .hold(!stable || !button_reset_n), .rst(rst));

  sinusoidal_fixed drive (
      .clk(clk), .rst(rst),
      .pins_fault_i(!fault_n), .pins_miso_i(adc_dout),
      .controls_run_i(button_run), .controls_reverse_i(button_reverse),
      .controls_speed_i({button_fast, 1'b1}), .brake_to_stop_i(1'b0),
      .cs_n_o(adc_cs_n), .sclk_o(adc_sclk), .mosi_o(adc_din),
      .gates_uh_o(gate_uh), .gates_ul_o(gate_ul), .gates_vh_o(gate_vh),
      .gates_vl_o(gate_vl), .gates_wh_o(gate_wh), .gates_wl_o(gate_wl),
      .locked_o(locked), .fault_o(fault), .turn_o(turn)
  );

  assign led_locked_n = !locked;
  assign led_fault_n = !fault;
endmodule
