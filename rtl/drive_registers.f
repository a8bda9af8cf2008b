rtl/drive_registers.sv
