#!/usr/bin/env bash
# The digest from which the seed of the published starts follows: it stays where nothing that is judged changes, and does not where it does.
#   starts_digest.sh WORK
set -euo pipefail
work=$1
cd "$(dirname "$0")/../.."
rm -rf "$work"
mkdir -p "$work/tree"
cp -r --parents tools/starts rtl model/design testbench/sweep testbench/drive_file drives "$work/tree"
cd "$work/tree"
digest() { tools/starts --digest; }
was=$(digest)
[[ $was =~ ^[0-9a-f]{16}$ ]] || { echo "no digest: $was"; exit 1; }
failed=0
# after WHAT FILE SED stays|changes: a change, which is taken back.
after() {
  local what=$1 file=$2 change=$3 must=$4 now said
  cp "$file" "$work/kept"
  sed -i "$change" "$file"
  ! cmp -s "$file" "$work/kept" || { echo "$what: $file stayed as it is"; failed=1; return; }
  now=$(digest)
  [ "$now" = "$was" ] && said=stays || said=changes
  [ $said = "$must" ] || { echo "$what: the digest $said"; failed=1; }
  cp "$work/kept" "$file"
}
after "a comment in the RTL"            rtl/vco_counter.sv 's,^module ,// more to say\n&,' stays
after "a port's name in one file alone" rtl/rotor_follower.sv 's/\bprobe_i\b/probe_clocks_i/' changes
after "another number in the RTL"       rtl/hall_decoder.sv "0,/3'd1/s/3'd1/3'd2/" changes
after "another operator in the RTL"     rtl/hall_decoder.sv '0,/ \^ /s/ ^ / | /' changes
after "a comment of the design"         model/design/speed_rules.cpp 's,^void ,// more to say\n&,' stays
after "a number of the design"          model/design/speed_rules.cpp 's/kInertias = 16/kInertias = 17/' changes
after "a name of the judge"             testbench/sweep/start_judge.hpp 's/kCreeps/kRises/' changes
after "what reads a drive file"         testbench/drive_file/drive_file.cpp '$a int more();' stays
after "how a motor is drawn"            testbench/drive_file/drawn_motor.cpp '$a int more();' changes
after "a drive file's comment"          drives/bly172s.toml '1s/$/ with more to say/' stays
after "a drive file's value"            drives/bly172s.toml 's/^bus_v = .*/bus_v = 23.9/' changes
# A name that is another one everywhere.
sed -i 's/\bfollower_drives_i\b/the_follower_drives_i/g' rtl/*.sv
[ "$(digest)" = "$was" ] || { echo "a port's name, changed everywhere: the digest changes"; failed=1; }
# Two ports that are wired the other way round.
sed -i 's/\.comparator_u_i(/.swap_i(/; s/\.comparator_v_i(/.comparator_u_i(/; s/\.swap_i(/.comparator_v_i(/' rtl/six_step_top.sv
[ "$(digest)" != "$was" ] || { echo "two ports wired the other way round: the digest stays"; failed=1; }
[ $failed = 0 ] && echo 'the digest knows what is judged'
