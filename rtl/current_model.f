rtl/current_model.sv
