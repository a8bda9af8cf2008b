rtl/space_vector.sv
