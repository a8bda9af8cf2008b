rtl/start_sequence.sv
