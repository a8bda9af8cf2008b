rtl/protection.sv
