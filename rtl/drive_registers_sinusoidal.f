rtl/telemetry_copy.sv
rtl/drive_registers_sinusoidal.sv
