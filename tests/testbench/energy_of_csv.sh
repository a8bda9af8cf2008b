#!/usr/bin/env bash
# The plant's energy from its CSV alone, by awk: nothing of ours does the sums.  A motor is driven by six-step with PWM, coasts, and is braked
# by its shorted windings.
#   energy_of_csv.sh none | torque | current | resistance | inertia STEPLOCK WORK
#     with a flaw one of the figures is off by 1 %, and a balance has to notice
#
#     terminals   int sum v i dt = int R sum i^2 dt + sum L i^2 / 2 + int torque speed dt
#     rotor       J (rise of speed) = int (torque - coulomb - viscous speed) dt, while it turns forwards
#     bridge      0 <= int bus source dt - int sum v i dt <= int sum (diode |i| + (its slope or the switch) i^2) dt
#
# Tolerance: the trapezoids' own.  A voltage that jumps between two samples leaves half of the jump, times the current and the step; a
# torque, which only bends, leaves an eighth of its second difference, times the step.
set -euo pipefail
flaw=$1 steplock=$(realpath "$2") work=$3 name=m2310p_servo
cd "$(dirname "$0")/../.."
mkdir -p "$work"
# Of the drive file, or the default that its page shows.
value() {
  { sed -n "s/^$1 = \"\?\([0-9.e-]*\).*/\1/p" "drives/$name.toml"; sed -n "s/^| \`$1\` | [^|]* | \([0-9.e-]*\) | .*/\1/p" docs/drive_file.md; } | sed -n 1p
}
r=$(value resistance_ohm) l=$(awk -v mh="$(value inductance_h)" 'BEGIN { print mh * 1e-3 }') j=$(value inertia_kgm2) coulomb=$(value coulomb_nm) viscous=$(value viscous_nms)
torque=1 current=1
case $flaw in
  none) ;;
  torque) torque=1.01 ;;
  current) current=1.01 ;;
  resistance) r=$(awk -v r="$r" 'BEGIN { print 1.01 * r }') ;;
  inertia) j=$(awk -v j="$j" 'BEGIN { print 1.01 * j }') ;;
  *) echo "energy_of_csv.sh: no flaw '$flaw'" >&2; exit 2 ;;
esac
# Steps of 2 ms at 30 kHz and 45 %, from rest at the middle of the first; off from 14 ms on; low sides from 16 to 18 ms.
awk 'BEGIN {
  split("1 0 0 1 0 0,1 0 0 0 0 1,0 0 1 0 0 1,0 1 1 0 0 0,0 1 0 0 1 0,0 0 0 1 1 0", on, ","); period = 1 / 30e3
  print "time_s,uh,ul,vh,vl,wh,wl,load_nm"
  for (t = 0; t < 0.014 - period / 2; t += period) {
    split(on[int(t / 0.002) % 6 + 1], g, " ")
    printf "%.10f,%d,%d,%d,%d,%d,%d,0\n", t, g[1], g[2], g[3], g[4], g[5], g[6]
    printf "%.10f,%d,%d,%d,%d,%d,%d,0\n", t + 0.45 * period, 0, g[2], 0, g[4], 0, g[6]
  }
  print "0.014,0,0,0,0,0,0,0"; print "0.016,0,1,0,1,0,1,0"; print "0.018,0,0,0,0,0,0,0"
}' >"$work/gates.csv"
"$steplock" plant "drives/$name.toml" --gates "$work/gates.csv" --out "$work/plant.csv" --dt 1e-7 --angle 30
awk -F, -v r="$r" -v l="$l" -v j="$j" -v coulomb="$coulomb" -v viscous="$viscous" -v torque=$torque -v current=$current \
  -v diode="$(value diode_drop_v)" -v slope="$(value diode_resistance_ohm)" -v on="$(value on_resistance_ohm)" '
  NR == 1 { for (k = 1; k <= NF; k++) at[$k] = k; next }
  function col(name) { return $at[name] }
  function abs(x) { return x < 0 ? -x : x }
  {
    t = col("time_s"); power = copper = magnetic = most = 0
    split("iu iv iw", i_name, " "); split("vu vv vw", v_name, " ")
    for (k = 1; k <= 3; k++) {
      i[k] = current * col(i_name[k]); v[k] = col(v_name[k])
      power += v[k] * i[k]; copper += r * i[k] ^ 2; magnetic += l * i[k] ^ 2 / 2; most += diode * abs(i[k]) + (slope > on ? slope : on) * i[k] ^ 2
    }
    w = col("speed_rad_s"); m = torque * col("torque_nm"); mech = m * w; in_ = col("bus_v") * col("source_a"); drag = coulomb + viscous * w
    if (NR > 2) {
      h = t - was_t
      terminals += h * (power + was_power) / 2; heat += h * (copper + was_copper) / 2; work += h * (mech + was_mech) / 2
      source += h * (in_ + was_in) / 2; losses += h * (most + was_most) / 2; turned += h * (m - drag + was_m - was_drag) / 2
      for (k = 1; k <= 3; k++) slack += h / 2 * abs(v[k] - was_v[k]) * (abs(i[k]) > abs(was_i[k]) ? abs(i[k]) : abs(was_i[k]))
      source_slack += h / 2 * abs(in_ - was_in); turn_slack += h / 8 * abs(m - 2 * was_m + before_m)
      if (w < 0) { print "the rotor turns backwards: the pattern drives it the wrong way"; exit 1 }
    } else { first = magnetic; first_w = w }
    was_t = t; was_power = power; was_copper = copper; was_mech = mech; was_in = in_; was_most = most; before_m = NR > 2 ? was_m : m; was_m = m; was_drag = drag
    for (k = 1; k <= 3; k++) { was_i[k] = i[k]; was_v[k] = v[k] }
  }
  END {
    left = terminals - heat - (magnetic - first) - work; spun = j * (w - first_w) - turned
    printf "terminals %.5f J = heat %.5f + stored %.5f + work %.5f, left %.2g, allowed %.2g\n", terminals, heat, magnetic - first, work, left, slack
    printf "rotor %.5g N m s, left %.2g, allowed %.2g\n", j * (w - first_w), spun, turn_slack
    printf "bridge %.5f J, at most %.5f\n", source - terminals, losses
    bad = abs(left) > slack || abs(spun) > turn_slack || source - terminals < -source_slack - slack || source - terminals > losses + source_slack + slack
    print bad ? "a balance does not hold" : "the balances hold"
    exit bad
  }' "$work/plant.csv"
