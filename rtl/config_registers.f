rtl/config_mirror.sv
rtl/config_registers.sv
