rtl/word_registers.sv
