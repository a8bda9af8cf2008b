rtl/hall_decoder.sv
