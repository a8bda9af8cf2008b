#!/usr/bin/env bash
# The digest from which the seed of the published starts follows: it stays where nothing that is judged changes, and does not where it does.
#   starts_digest.sh STEPLOCK WORK
set -euo pipefail
steplock=$1 work=$2
cd "$(dirname "$0")/../.."
tests/empty_folder "$work"
mkdir -p "$work/tree" "$work/bin"
cp -r --parents tools/starts rtl model/design testbench/sweep testbench/drive_file drives "$work/tree"
cd "$work/tree"
# A stand-in for another design library: with a file `spoils` in the folder, which holds a sed command, it says something else.
printf '#!/bin/sh\n%s "$@" | if [ -f "%s/spoils" ]; then sed -f "%s/spoils"; else cat; fi\n' "$steplock" "$work" "$work" > "$work/bin/steplock"
chmod +x "$work/bin/steplock"
export STEPLOCK_BUILD=$work
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
after "a line of the design's code"     model/design/speed_rules.cpp '$a int more();' stays
after "a bound of a start"              model/design/bounds.cpp '$a int more();' changes
after "a name of the judge"             testbench/sweep/start_judge.hpp 's/kCreeps/kRises/' changes
after "a name that was another one"     testbench/sweep/witness.cpp 's/kRetryDelay/kRest/' stays
after "what reads a drive file"         testbench/drive_file/drive_file.cpp '$a int more();' stays
after "how a motor is drawn"            testbench/drive_file/drawn_motor.cpp '$a int more();' changes
after "a drive file's comment"          drives/bly172s.toml '1s/$/ with more to say/' stays
after "a drive file's value"            drives/bly172s.toml 's/^bus_v = .*/bus_v = 23.9/' changes
after "a drive file's name"             drives/bly172s.toml 's/^name = .*/name = "another"/' stays
after "a drive file's scenario"         drives/bly172s.toml 's/^duration_s = .*/duration_s = 77/' changes
# A word, a setting and a bound of the design library, of a drive's or of a drawn motor's.
for spoils in '/SPEED_SLEW$/s/^\(.*\)[0-9a-f]/\11234/' 's/^sensors.comparator_noise_v = 0.01$/&1/' 's/^bounds [0-9]*/&1/'; do
  echo "$spoils" > "$work/spoils"
  [ "$(digest)" != "$was" ] || { echo "the library says otherwise ($spoils): the digest stays"; failed=1; }
done
rm "$work/spoils"
# A name that is another one everywhere.
sed -i 's/\bfollower_drives_i\b/the_follower_drives_i/g' rtl/*.sv
[ "$(digest)" = "$was" ] || { echo "a port's name, changed everywhere: the digest changes"; failed=1; }
# Wires that had names of their own, and wires of two modules that get one name.
sed -i 's/\bto_high\b/is_high/g' rtl/start_sequence.sv
sed -i 's/\bheavy\b/is_high/g' rtl/protection.sv
[ "$(digest)" = "$was" ] || { echo "wires of two modules with one name: the digest changes"; failed=1; }
# Two ports that are wired the other way round.
sed -i 's/\.comparator_u_i(/.swap_i(/; s/\.comparator_v_i(/.comparator_u_i(/; s/\.swap_i(/.comparator_v_i(/' rtl/six_step_top.sv
[ "$(digest)" != "$was" ] || { echo "two ports wired the other way round: the digest stays"; failed=1; }
# A design library that fails leaves no digest.
printf '#!/bin/sh\nexit 1\n' > "$work/bin/steplock"
if said=$(tools/starts --digest 2>&1); then echo "a refused drive has a digest: $said"; failed=1; fi
[ $failed = 0 ] && echo 'the digest knows what is judged'
