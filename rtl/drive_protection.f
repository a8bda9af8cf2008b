rtl/drive_protection.sv
