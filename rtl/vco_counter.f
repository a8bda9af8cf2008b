rtl/vco_counter.sv
