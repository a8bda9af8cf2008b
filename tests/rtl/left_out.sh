#!/usr/bin/env bash
# left_out.sh MODULE PARAMETER VALUE: with that value, synthesis for iCE40 leaves no logic of rtl/MODULE.sv.
set -euo pipefail
module=$1 parameter=$2 value=$3
said=$(yosys -Q -q -p "read_verilog -sv rtl/$module.sv; chparam -set $parameter $value $module; synth_ice40 -top $module
  select -assert-none t:SB_*" 2>&1) && exit
grep -q "selection is not empty" <<<"$said" || { echo "$said"; exit 2; }
echo "$module with $parameter = $value: $(grep -c "^$module/" <<<"$said") cells are left"
exit 1
