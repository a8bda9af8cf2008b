rtl/current_limit.sv
