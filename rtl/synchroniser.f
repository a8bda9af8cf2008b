rtl/synchroniser.sv
