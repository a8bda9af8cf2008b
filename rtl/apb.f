rtl/apb.sv
