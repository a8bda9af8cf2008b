rtl/speed_regulator.sv
