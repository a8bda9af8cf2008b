#!/usr/bin/env bash
# slice.sh STEPLOCK DRIVES WORK: 300 starts with a fixed seed all succeed, and where the RTL repeats one
# it agrees on every clock.
set -euo pipefail
steplock=$1 drives=$2 work=$3
rm -rf "$work"
"$steplock" sweep "$drives"/*.toml --runs 300 --seed 1 --out "$work"
jq -e '.runs == 300 and .started == 300 and .rtl_repeats > 0 and .rtl_differing == 0' "$work/sweep.json"
