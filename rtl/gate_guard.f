rtl/guarded_leg.sv
rtl/gate_guard.sv
