# Vivado: bitstream of the Arty A7-35T.  Untested: no Vivado has run it; the tests evaluate it with stand-ins
# for Vivado's commands (docs/boards.md).
#
#   tools/bitstream arty_a7 my_motor.toml OUT
#   vivado -mode batch -source constraints/arty_a7/vivado.tcl -tclargs OUT        OUT/vivado/arty_a7_six_step.bit

set folder [file dirname [file normalize [info script]]]
set root [file dirname [file dirname $folder]]
set out [file normalize [lindex $argv 0]]

create_project -force -in_memory -part xc7a35ticsg324-1L
set list [open $root/rtl/six_step_standalone.f]
foreach name [split [string trim [read $list]] "\n"] { read_verilog -sv $root/$name }
close $list
read_verilog -sv [list $out/six_step_fixed.sv $root/constraints/power_on_reset.sv $folder/arty_a7_six_step.sv]
read_xdc $folder/arty_a7.xdc

file mkdir $out/vivado
synth_design -top arty_a7_six_step
opt_design
place_design
route_design
report_utilization -file $out/vivado/utilization.txt
report_timing_summary -report_unconstrained -file $out/vivado/timing.txt
report_cdc -file $out/vivado/cdc.txt
if {[get_property SLACK [get_timing_paths -max_paths 1]] < 0} { error "the clock is faster than the logic: $out/vivado/timing.txt" }
write_bitstream -force $out/vivado/arty_a7_six_step.bit
