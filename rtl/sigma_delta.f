rtl/sinc3.sv
rtl/sigma_delta.sv
