rtl/open_loop_duty.sv
