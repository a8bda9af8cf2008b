#!/usr/bin/env bash
# The sinusoidal bench of rtl/bench in Verilator, beside the co-simulation of the same drive file: its lock comes at the same time.
#   turning_sinusoidal.sh [--icarus | --backwards | --mirrored] STEPLOCK WORK
#     --icarus      the first 4 ms, in Icarus
#     --backwards   a motor whose current turns it the wrong way: it must not lock
#     --mirrored    likewise an ADC of phase U that shows its current with the other sign
# The ADCs of the bench have no noise; so have the file's.  How far apart the locks may be is how far the co-simulation's own moves
# from 1 % less resistance to 1 % more: the bench's Euler steps and its diodes without resistance are less than that.
set -euo pipefail
mode=verilator
case $1 in --*) mode=${1#--}; shift ;; esac
steplock=$(realpath "$1") work=$2 name=m2310p_sinusoidal
cd "$(dirname "$0")/../.."
mkdir -p "$work"
# shellcheck source=tests/rtl/flawed.sh
. tests/rtl/flawed.sh
for key in resistance_ohm flux_vs pole_pairs inertia_kgm2 coulomb_nm viscous_nms bus_v limit_a current_a voltage_v; do
  file=$(sed -n "s/^$key = \([^ ]*\).*/\1/p" "drives/$name.toml") bench=$(sed -n "/^  hosted\|^  motor #/,/^  )/s/.*\.$key(\([^)]*\)).*/\1/p" rtl/bench/turning_sinusoidal.sv | grep -v motor | head -n 1)
  same "$key" "$file" "$bench"
done
motor=rtl/bench/motor.sv drive=rtl/bench/hosted_sinusoidal.sv latest=12000000
case $mode in
  backwards) motor=$(flawed $motor 's/torque = torque + pole_pairs/torque = torque - pole_pairs/') latest=6000000 ;;
  mirrored) drive=$(flawed $drive 's/clipped(current_u_a/clipped(-current_u_a/') latest=6000000 ;;
esac
options=(--out "$work" --with "$motor" --with "$drive")
if [ $mode = icarus ]; then
  tools/bench "${options[@]}" icarus turning_sinusoidal +first_ms=4
  exit
fi
tools/bench "${options[@]}" --define LATEST=$latest verilator turning_sinusoidal | tee "$work/log"
[ $mode = verilator ] || exit 0
locked=$(sed -n 's/^locked after \([0-9.]*\) ms .*/\1/p' "$work/log" | head -n 1)

# lock FACTOR: ms from the rise of `run` to the lock, with so many times the resistance
lock() {
  sed -e 's/^current_noise_a.*/current_noise_a = 0/' -e '/^\(load_step\|load_off\|stop\)_s/d' -e 's/^duration_s.*/duration_s = 0.3/' \
    -e "s/^resistance_ohm.*/resistance_ohm = $(awk -v f="$1" 'BEGIN { print 0.38 * f }')/" "drives/$name.toml" >"$work/$name.toml"
  "$steplock" run "$work/$name.toml" --engine fixed --out "$work/run" >/dev/null || true  # it is not at its set speed yet
  awk -F, 'NR == 1 { for (i = 1; i <= NF; i++) if ($i == "state") column = i }
           $column == "calibrate" && !from { from = $1 } $column == "run" { printf "%.2f", ($1 - from) * 1e3; exit }' "$work/run/run.csv"
}
jq -n --argjson bench "$locked" --argjson model "$(lock 1)" --argjson low "$(lock 0.99)" --argjson high "$(lock 1.01)" -r '
  ($high - $low | fabs) as $tolerance |
  "bench \($bench) ms, co-simulation \($model) ms, 2 % of resistance \($tolerance * 100 | round / 100) ms: " +
  (if ($bench - $model | fabs) <= $tolerance then "they agree" else "they differ" end)'
