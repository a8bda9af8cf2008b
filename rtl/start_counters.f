rtl/start_counters.sv
