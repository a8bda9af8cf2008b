rtl/pwm_generator.sv
