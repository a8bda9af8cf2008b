#!/usr/bin/env bash
# compare_with_constant.sh: constraints/compare_with_constant.v is Yosys' own comparison.  SAT proves it for every
# constant of five bits and some that are wider or narrower than what they are compared with, signed and unsigned, on
# either side, and that none is left for the adders.
#   compare_with_constant.sh --flaw   the same of a map that takes "less or equal" for "less"
set -euo pipefail
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
map=constraints/compare_with_constant.v
if [ "${1-}" = --flaw ]; then
  sed 's/!more\[1\]/less[1]/' "$map" >"$work/map.v"
  ! cmp -s "$map" "$work/map.v" || { echo "the flaw is not in $map"; exit 1; }
  map=$work/map.v
fi

awk 'BEGIN {
  for (value = 0; value < 32; value++) { unsigned[++n] = "5\x27d" value; signed[n] = value < 16 ? "5\x27sd" value : "-5\x27sd" 32 - value }
  unsigned[++n] = "3\x27d6"; signed[n] = "-3\x27sd3"; unsigned[++n] = "9\x27d300"; signed[n] = "-9\x27sd200"; unsigned[++n] = "1\x27d1"; signed[n] = "9\x27sd200"
  split("< <= > >=", operator, " ")
  for (i = 1; i <= n; i++) for (o = 1; o <= 4; o++)
    list = list sprintf("%sx %s %s, %s %s x, s %s %s, %s %s s", list ? ",\n    " : "", operator[o], unsigned[i], unsigned[i], operator[o],
      operator[o], signed[i], signed[i], operator[o])
  printf "module compares (input [4:0] x, input signed [4:0] s, output [%d:0] y);\n  assign y = {\n    %s};\nendmodule\n", n * 16 - 1, list
}' >"$work/compares.sv"

yosys -q -p "read_verilog -sv $work/compares.sv; proc; copy compares mapped
  cd mapped; select -assert-min 100 t:\$lt t:\$le t:\$gt t:\$ge; techmap -map $map; select -assert-none t:\$lt t:\$le t:\$gt t:\$ge; cd ..
  miter -equiv -flatten compares mapped both; sat -verify -prove trigger 0 both" >"$work/log" 2>&1 ||
  { grep -E "ERROR" "$work/log" | head -n 3; exit 1; }
echo "$(grep -c '' "$work/compares.sv") lines of comparisons are proved the same"
