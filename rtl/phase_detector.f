rtl/phase_detector.sv
