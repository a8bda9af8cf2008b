rtl/wishbone.sv
