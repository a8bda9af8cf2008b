rtl/divide_by_n.sv
