rtl/commutation.sv
