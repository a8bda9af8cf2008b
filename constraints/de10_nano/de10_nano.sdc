# DE10-Nano: timing of de10_nano_six_step, for Quartus.

create_clock -name oscillator -period 20.0 [get_ports clk_50mhz]
derive_clock_uncertainty

# Inputs: 2 ns are left for a path that ends anywhere but in the first flop of a synchroniser; only these are cut.
set asynchronous [get_ports {comparator_u comparator_v comparator_w limit fault_n hall_u hall_v hall_w
                             key_run_n key_reset_n reverse speed[0] speed[1]}]
set_input_delay -clock oscillator 18.0 $asynchronous
foreach first {comparator limit fault hall run reverse speed} {
  set_false_path -from $asynchronous -to [get_registers "*|first_$first*"]
}
set_false_path -from $asynchronous -to [get_registers {*:reset|held[0]}]
# Outputs: at their pins 18 ns after the edge: two gates are at most that apart, a 13th of the least dead time.
set_output_delay -clock oscillator 2.0 \
  [get_ports {gate_uh gate_ul gate_vh gate_vl gate_wh gate_wl turn led_locked led_fault}]
