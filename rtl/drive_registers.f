rtl/telemetry_copy.sv
rtl/drive_registers.sv
