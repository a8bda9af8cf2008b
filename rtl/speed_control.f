rtl/serial_multiplier_27_16.sv
rtl/speed_control.sv
