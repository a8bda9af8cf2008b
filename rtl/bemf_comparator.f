rtl/bemf_comparator.sv
