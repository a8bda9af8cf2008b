rtl/spi.sv
