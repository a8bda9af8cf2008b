rtl/start_counters.sv
rtl/open_loop_duty.sv
rtl/start_sequence.sv
