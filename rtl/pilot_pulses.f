rtl/pilot_pulses.sv
