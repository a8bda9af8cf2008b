rtl/voltage_model.sv
