rtl/telemetry.sv
