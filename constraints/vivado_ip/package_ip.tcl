# Vivado: six_step_axi as an IP for block designs, its AXI4-Lite slave, interrupt and reset as interfaces.
# Untested: no Vivado has run it; the tests evaluate it with stand-ins for Vivado's commands (docs/boards.md).
#
#   vivado -mode batch -source constraints/vivado_ip/package_ip.tcl -tclargs OUT     OUT/steplock_six_step/component.xml
# Then add OUT to the project's IP repositories (set_property ip_repo_paths OUT [current_project]).

set folder [file dirname [file normalize [info script]]]
set root [file dirname [file dirname $folder]]
set ip [file normalize [lindex $argv 0]]/steplock_six_step

file mkdir $ip
create_project -force package $ip/project
set list [open $root/rtl/six_step_axi.f]
foreach name [split [string trim [read $list]] "\n"] { add_files -norecurse $root/$name }
close $list
add_files -norecurse $folder/steplock_six_step.v
add_files -fileset constrs_1 -norecurse $folder/steplock_six_step.xdc
set_property top steplock_six_step [current_fileset]
update_compile_order -fileset sources_1

# Interfaces are inferred from the names s_axi_*; -import_files copies the sources beside component.xml.
ipx::package_project -root_dir $ip -vendor steplock -library motor -taxonomy /UserIP -import_files
set core [ipx::current_core]
set_property name steplock_six_step $core
set_property version 0.1 $core
set_property display_name "Steplock six-step motor drive" $core
set_property description "Sensorless six-step drive of a brushless motor behind AXI4-Lite" $core
set_property supported_families {artix7 Production kintex7 Production zynq Production spartan7 Production} $core
ipx::infer_bus_interface irq xilinx.com:signal:interrupt_rtl:1.0 $core
ipx::associate_bus_interfaces -busif s_axi -clock s_axi_aclk $core
ipx::create_xgui_files $core
ipx::update_checksums $core
ipx::check_integrity $core
ipx::save_core $core
close_project
