#!/usr/bin/env bash
# survivor.sh ROOT BUILD: where a block has one test that asks nothing, tools/mutants must say what survives, and fail; where
# that test does not compile, that it fails without a mutant.
set -euo pipefail
root=$1 build=$2 tree=$2/mutants_of_no_test
"$(dirname "$0")/../empty_folder" "$tree"
mkdir -p "$tree/tests/hls" "$tree/tools" "$tree/tests/mutants"
cp -r "$root/hls" "$tree/"
cp "$root/tools/mutants" "$tree/tools/"
cp "$root/tests/mutants/equivalent.tsv" "$tree/tests/mutants/"
printf '#include "hls/six_step/protection.hpp"\n#include <gtest/gtest.h>\nTEST(Protection, Ticks) { steplock::Protection().tick({}); }\n' \
  >"$tree/tests/hls/protection_test.cpp"
! STEPLOCK_BUILD=$build STEPLOCK_MUTANTS=$tree/out "$tree/tools/mutants" --tenth 00000000 protection >"$tree/said" 2>&1 ||
  { cat "$tree/said"; echo "survivor: nothing survived"; exit 1; }
grep -q '^hls/six_step/protection.hpp:[0-9]*:[0-9]*  "' "$tree/said" || { cat "$tree/said"; echo "survivor: not told"; exit 1; }
echo '#error no compiler takes this' >>"$tree/tests/hls/protection_test.cpp"
! STEPLOCK_BUILD=$build STEPLOCK_MUTANTS=$tree/out "$tree/tools/mutants" --tenth 00000000 protection >"$tree/said" 2>&1 ||
  { echo "survivor: what does not compile killed all"; exit 1; }
grep -q '^tools/mutants: hls/six_step/protection.hpp: a test fails' "$tree/said" || { cat "$tree/said"; echo "survivor: not told why"; exit 1; }
