rtl/word_mirror.sv
rtl/word_registers.sv
