# Of the packaged IP, scoped to it: the pins end in the first flops of synchronisers, and only these paths are cut.
set_false_path -from [get_ports {comparator_u comparator_v comparator_w limit fault_n hall_u hall_v hall_w}] \
  -to [get_cells -hierarchical -regexp {.*/first_(comparator|limit|fault|hall).*_reg.*}]
