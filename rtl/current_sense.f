rtl/current_sense.sv
