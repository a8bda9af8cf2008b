#!/usr/bin/env bash
# slice.sh STEPLOCK DRIVES WORK: 300 starts with a fixed seed.  All start but the one that is known
# (docs/sweep.md, "What is not"); another failure, one that is mended but still named here, or one clock
# on which the RTL differs fails the test.
set -euo pipefail
steplock=$1 drives=$2 work=$3
known='["amano2003 5181020259702096 silent_step_out"]'
rm -rf "$work"
"$steplock" sweep "$drives"/*.toml --runs 300 --seed 1 --out "$work" || [ $? -eq 1 ]
jq -e --argjson known "$known" '
  .runs == 300 and .rtl_repeats > 0 and .rtl_differing == 0 and
  [.failures[] | "\(.drive) \(.seed) \(.outcome)"] == $known' "$work/sweep.json"
