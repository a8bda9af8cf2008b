rtl/sinc3.sv
