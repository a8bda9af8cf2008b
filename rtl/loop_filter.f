rtl/serial_multiplier_37_26.sv
rtl/loop_filter.sv
