rtl/estimator.sv
