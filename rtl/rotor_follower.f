rtl/rotor_follower.sv
