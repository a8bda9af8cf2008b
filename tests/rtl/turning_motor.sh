#!/usr/bin/env bash
# The motor of rtl/bench in Icarus, beside the co-simulation of the same drive file: its lock comes at the same time.
#   turning_motor.sh [--long | --backwards | --heavy] STEPLOCK WORK
#     --long        in Verilator: load, reversal, fault, another start and stop, too
#     --backwards   the same with a motor whose current turns it the wrong way: it must not lock
#     --heavy       the same with ten times the load, more than the limit's current carries
# The drive of the bench does not observe, and its comparators are ideal; so is the drive file's.  A lock may come a look and a
# probe sooner or later, and the three looks that follow a new code: the integration steps differ, and with them the moment at
# which an edge is seen.
set -euo pipefail
mode=icarus
case $1 in --*) mode=${1#--}; shift ;; esac
steplock=$(realpath "$1") work=$2 name=maxon_ec45_flat
cd "$(dirname "$0")/../.."
mkdir -p "$work"
# shellcheck source=tests/rtl/flawed.sh
. tests/rtl/flawed.sh
for key in resistance_ohm flux_vs pole_pairs inertia_kgm2 coulomb_nm viscous_nms bus_v limit_a; do
  file=$(sed -n "s/^$key = //p" "drives/$name.toml") bench=$(sed -n "s/^ *parameter [a-z]* $key = \([^,) ]*\).*/\1/p" rtl/bench/motor.sv)
  same "$key" "$file" "$bench"
done
motor=rtl/bench/motor.sv bench=rtl/bench/turning_motor.sv
case $mode in
  backwards) motor=$(flawed $motor 's/torque = torque + pole_pairs/torque = torque - pole_pairs/') ;;
  heavy) bench=$(flawed $bench 's/motor.load_nm = kHalfOfRated/motor.load_nm = 10.0 * kHalfOfRated/') ;;
esac
options=(--out "$work" --with "$motor" --with "$bench")
if [ $mode != icarus ]; then
  latest=4800000
  [ $mode != backwards ] || latest=700000
  tools/bench "${options[@]}" --define LATEST=$latest verilator turning_motor +long
  exit
fi
tools/bench "${options[@]}" icarus turning_motor | tee "$work/log"
locked=$(sed -n 's/^locked after \([0-9.]*\) ms .*/\1/p' "$work/log")

# Without what the bench does not have; one tick of looking for a spin is the least that the file takes.
sed -e 's/^comparator_offset_v.*/comparator_offset_v = [0, 0, 0]/' -e 's/^comparator_noise_v.*/comparator_noise_v = 0/' \
  -e 's/^duration_s.*/duration_s = 0.2/' -e '/^\(load_step\|load_off\|reverse\|stop\)_s/d' -e 's/^\[start\]/[start]\ndetect_spin_s = 0.001/' \
  "drives/$name.toml" >"$work/$name.toml"
"$steplock" run "$work/$name.toml" --engine fixed --out "$work/run" >/dev/null || true  # it is not at its set speed yet
"$steplock" design "$work/$name.toml" --json >"$work/design.json"
jq -n --argjson bench "$locked" --slurpfile run "$work/run/summary.json" --slurpfile design "$work/design.json" -r '
  ($design[0].config[] | select(.name == "start.detect_spin") | .meant) as $looked |
  (($run[0].lock_time_s - $looked) * 1e3) as $model |
  ($design[0].start | (4 * .look + .probe) * 1e3) as $tolerance |
  "bench \($bench) ms, co-simulation \($model * 100 | round / 100) ms, four looks and a probe \($tolerance * 100 | round / 100) ms: " +
  (if ($bench - $model | fabs) <= $tolerance then "they agree" else "they differ" end)'
