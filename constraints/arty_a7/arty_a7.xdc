# Arty A7-35T, Artix-7 (XC7A35TICSG324-1L): for tools/bitstream, which reads the next line.
# clock_hz: 50000000
#
# Sites from Digilent's published master constraints (Arty-A7-35-Master.xdc, Rev. D and E).  Not placed here:
# synthesized by Yosys; vivado.tcl reads it.
#
# While the FPGA is not configured its pins float: give each gate 4.7 kohm to ground at the gate driver.
# Inputs are pulled up, so that an open limit wire stops the chopped gate, and an open Hall wire is an
# illegal code; an open fault wire is not noticed.

set_property -dict {PACKAGE_PIN E3 IOSTANDARD LVCMOS33} [get_ports clk_100mhz]
create_clock -name oscillator -period 10.0 [get_ports clk_100mhz]
create_generated_clock -name clk [get_pins pll/CLKOUT0]

# Reset button (low when pressed), buttons BTN0 to BTN2 (high), LEDs LD4 and LD5
set_property -dict {PACKAGE_PIN C2 IOSTANDARD LVCMOS33} [get_ports button_reset_n]
set_property -dict {PACKAGE_PIN D9 IOSTANDARD LVCMOS33} [get_ports button_run]
set_property -dict {PACKAGE_PIN C9 IOSTANDARD LVCMOS33} [get_ports button_reverse]
set_property -dict {PACKAGE_PIN B9 IOSTANDARD LVCMOS33} [get_ports button_fast]
set_property -dict {PACKAGE_PIN H5 IOSTANDARD LVCMOS33} [get_ports led_locked]
set_property -dict {PACKAGE_PIN J5 IOSTANDARD LVCMOS33} [get_ports led_fault]

# Pmod JA: gates above, low sides below, and what stops them
set_property -dict {PACKAGE_PIN G13 IOSTANDARD LVCMOS33} [get_ports gate_uh]
set_property -dict {PACKAGE_PIN B11 IOSTANDARD LVCMOS33} [get_ports gate_vh]
set_property -dict {PACKAGE_PIN A11 IOSTANDARD LVCMOS33} [get_ports gate_wh]
set_property -dict {PACKAGE_PIN D12 IOSTANDARD LVCMOS33 PULLUP true} [get_ports fault_n]
set_property -dict {PACKAGE_PIN D13 IOSTANDARD LVCMOS33} [get_ports gate_ul]
set_property -dict {PACKAGE_PIN B18 IOSTANDARD LVCMOS33} [get_ports gate_vl]
set_property -dict {PACKAGE_PIN A18 IOSTANDARD LVCMOS33} [get_ports gate_wl]
set_property -dict {PACKAGE_PIN K16 IOSTANDARD LVCMOS33 PULLUP true} [get_ports limit]

# Pmod JD: sensors and the tachometer
set_property -dict {PACKAGE_PIN D4 IOSTANDARD LVCMOS33 PULLUP true} [get_ports comparator_u]
set_property -dict {PACKAGE_PIN D3 IOSTANDARD LVCMOS33 PULLUP true} [get_ports comparator_v]
set_property -dict {PACKAGE_PIN F4 IOSTANDARD LVCMOS33 PULLUP true} [get_ports comparator_w]
set_property -dict {PACKAGE_PIN F3 IOSTANDARD LVCMOS33} [get_ports turn]
set_property -dict {PACKAGE_PIN E2 IOSTANDARD LVCMOS33 PULLUP true} [get_ports hall_u]
set_property -dict {PACKAGE_PIN D2 IOSTANDARD LVCMOS33 PULLUP true} [get_ports hall_v]
set_property -dict {PACKAGE_PIN H2 IOSTANDARD LVCMOS33 PULLUP true} [get_ports hall_w]

# Inputs: 2 ns are left for a path that ends anywhere but in the first flop of a synchroniser; only these are cut.
set asynchronous [get_ports {comparator_u comparator_v comparator_w limit fault_n hall_u hall_v hall_w
                             button_run button_reverse button_fast button_reset_n}]
set_input_delay -clock clk 18.0 $asynchronous
set_false_path -from $asynchronous \
  -to [get_cells -hierarchical -regexp {.*/first_(comparator|limit|fault|hall|run|reverse|speed).*_reg.*|reset/held_reg.0.}]
# Outputs: at their pins 18 ns after the edge: two gates are at most that apart, a 13th of the least dead time.
set_output_delay -clock clk 2.0 [get_ports {gate_uh gate_ul gate_vh gate_vl gate_wh gate_wl turn led_locked led_fault}]

set_property CFGBVS VCCO [current_design]
set_property CONFIG_VOLTAGE 3.3 [current_design]
