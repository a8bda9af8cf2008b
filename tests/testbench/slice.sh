#!/usr/bin/env bash
# slice.sh STEPLOCK DRIVES WORK: 300 starts with a fixed seed.  Those that fail are known and printed with
# their seeds; more of them than 3 in 100, or one clock on which the RTL differs, fail the test.
set -euo pipefail
steplock=$1 drives=$2 work=$3
rm -rf "$work"
"$steplock" sweep "$drives"/*.toml --runs 300 --seed 1 --out "$work" || [ $? -eq 1 ]
jq -e '.runs == 300 and .started >= 0.97 * .runs and .rtl_repeats > 0 and .rtl_differing == 0' "$work/sweep.json"
