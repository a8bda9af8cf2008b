rtl/spi_adc.sv
