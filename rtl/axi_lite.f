rtl/axi_lite.sv
