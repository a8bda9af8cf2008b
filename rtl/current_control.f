rtl/current_control.sv
