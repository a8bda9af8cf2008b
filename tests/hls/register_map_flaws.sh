#!/usr/bin/env bash
# A register map that breaks a rule does not compile, and says which header to look at.
#   register_map_flaws.sh CXX FLAW     in the root of the tree; about a second
set -euo pipefail
cxx=$1
case $2 in
  overlap) file=hls/bus/word_rows.hpp edit='s/"PWM", "centred", 0x80, 16/"PWM", "centred", 0x80, 13/' ;;
  misfit) file=hls/bus/word_rows.hpp edit='s/"LOOP_GAIN", "kp", 0x98, 16/"LOOP_GAIN", "kp", 0x98, 17/' ;;
  reset) file=hls/bus/six_step_registers.hpp edit='s/.kind = 1,/.kind = 16,/' ;;
  sinusoidal) file=hls/bus/sinusoidal_rows.hpp edit='s/"SPEED_GAIN", "k_i", 0xd4, 16/"SPEED_GAIN", "k_i", 0xd4, 14/' ;;
  two_registers) file=hls/bus/word_rows.hpp edit='s/"SPEED_SLEW", "slew", 0xd0/"SPEED_SLEW", "slew", 0xd4/' ;;
  *) echo "register_map_flaws.sh: unknown flaw '$2'" >&2; exit 2 ;;
esac
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
mkdir -p "$work/hls/bus" "$work/map"
tr '\n' '\a' <"$file" | sed 's/(\a        "/("/g' | tr '\a' '\n' >"$work/joined"
sed "$edit" "$work/joined" >"$work/$file"
! cmp -s "$work/joined" "$work/$file" || { echo "the edit for '$2' changes nothing in $file" >&2; exit 1; }
printf '#include "hls/bus/%s_registers.hpp"\n' six_step sinusoidal >"$work/map/map.cpp"
# The map as it is compiles the same way: a failure is the flaw's.
"$cxx" -std=c++20 -fsyntax-only -I. "$work/map/map.cpp"
if "$cxx" -std=c++20 -fsyntax-only -I"$work" -I. "$work/map/map.cpp" 2>"$work/errors"; then
  echo "a map with the flaw '$2' compiles" >&2
  exit 1
fi
grep -q "the register map breaks a rule" "$work/errors" || { cat "$work/errors" >&2; exit 1; }
