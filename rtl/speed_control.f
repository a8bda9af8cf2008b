rtl/serial_multiplier_17_16.sv
rtl/speed_control.sv
