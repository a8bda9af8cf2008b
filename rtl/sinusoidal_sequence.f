rtl/sinusoidal_sequence.sv
