# Lattice Diamond with Synplify: bitstream of the ULX3S.  Untested: no Diamond has run it; the tests evaluate it
# with stand-ins for Diamond's commands (docs/boards.md).  With nextpnr-ecp5 instead:
#   nextpnr-ecp5 --85k --package CABGA381 --json OUT/ulx3s_six_step.json --lpf constraints/ulx3s/ulx3s.lpf \
#     --textcfg OUT/ulx3s_six_step.config && ecppack OUT/ulx3s_six_step.config OUT/ulx3s_six_step.bit
#
#   tools/bitstream ulx3s my_motor.toml OUT
#   STEPLOCK_OUT=OUT diamondc constraints/ulx3s/diamond.tcl       OUT/diamond/impl/ulx3s_six_step_impl.bit

set folder [file dirname [file normalize [info script]]]
set root [file dirname [file dirname $folder]]
set out [file normalize $env(STEPLOCK_OUT)]

file mkdir $out/diamond
cd $out/diamond
prj_project new -name ulx3s_six_step -impl impl -dev LFE5U-85F-6BG381C -synthesis synplify -lpf $folder/ulx3s.lpf
set list [open $root/rtl/six_step_standalone.f]
foreach name [split [string trim [read $list]] "\n"] { prj_src add $root/$name }
close $list
prj_src add $out/six_step_fixed.sv
prj_src add $root/constraints/power_on_reset.sv
prj_src add $folder/ulx3s_six_step.sv
prj_impl option top ulx3s_six_step
prj_project save
prj_run Export -impl impl -task Bitgen
prj_project close
