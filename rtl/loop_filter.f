rtl/serial_multiplier_34_22.sv
rtl/loop_filter.sv
