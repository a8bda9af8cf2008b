#!/usr/bin/env bash
# constraints/clock_watch.sv under tests/boards/clock_watch.sv, in Icarus.
#   clock_watch.sh none | asks_anyway | never_low | too_short WORK
set -euo pipefail
work=$2 edit=''
cd "$(dirname "$0")/../.."
mkdir -p "$work"
case $1 in
  none) ;;
  asks_anyway) edit='s/if (answer\[1\] == ask) ask/ask/' ;;
  never_low) edit="s/alive <= answer\[1\] == ask/alive <= 1'b1/" ;;
  too_short) edit="s/kRound = 4'd8/kRound = 4'd3/" ;;
esac
sed "$edit" constraints/clock_watch.sv >"$work/dut.sv"
[ "$1" = none ] || ! cmp -s constraints/clock_watch.sv "$work/dut.sv" || { echo "clock_watch.sh: the flaw found no place"; exit 2; }
iverilog -g2012 -o "$work/bench.vvp" -s clock_watch_bench "$work/dut.sv" tests/boards/clock_watch.sv
vvp -n "$work/bench.vvp"
