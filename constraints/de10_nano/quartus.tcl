# Quartus Prime (Lite): bitstream of the DE10-Nano.  Untested: no Quartus has run it; the tests evaluate it with
# stand-ins for Quartus' commands (docs/boards.md).
#
#   tools/bitstream de10_nano my_motor.toml OUT
#   quartus_sh -t constraints/de10_nano/quartus.tcl OUT        OUT/quartus/output_files/de10_nano_six_step.sof

package require ::quartus::project
package require ::quartus::flow

set folder [file dirname [file normalize [info script]]]
set root [file dirname [file dirname $folder]]
set out [file normalize [lindex $argv 0]]

file mkdir $out/quartus
cd $out/quartus
project_new -overwrite de10_nano_six_step
set_global_assignment -name FAMILY "Cyclone V"
set_global_assignment -name DEVICE 5CSEBA6U23I7
set_global_assignment -name TOP_LEVEL_ENTITY de10_nano_six_step
set_global_assignment -name PROJECT_OUTPUT_DIRECTORY output_files
set list [open $root/rtl/six_step_standalone.f]
foreach name [split [string trim [read $list]] "\n"] {
  set_global_assignment -name SYSTEMVERILOG_FILE $root/$name
}
close $list
foreach name [list $out/six_step_fixed.sv $root/constraints/power_on_reset.sv $folder/de10_nano_six_step.sv] {
  set_global_assignment -name SYSTEMVERILOG_FILE $name
}
set_global_assignment -name SDC_FILE $folder/de10_nano.sdc
source $folder/de10_nano.qsf
export_assignments

execute_flow -compile
project_close
