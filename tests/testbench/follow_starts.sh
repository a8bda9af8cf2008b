#!/usr/bin/env bash
# follow_starts.sh STEPLOCK ROOT WORK RUNS MOST DRIVE...: drawn starts that follow the rotor, all of them started, at most MOST after a
# failed attempt, and the RTL agrees where it repeats one.
#
# The seed is nobody's choice: a digest of the drive, its design and its judge.  Whoever changes one of them is judged on other motors.
# MOST: each attempt at the first try with 98.5 % (the goal for every drive), a sweep passes by chance 9996 times of 10000.
set -euo pipefail
steplock=$1 root=$2 work=$3 runs=$4 most=$5
shift 5
rm -rf "$work"
seed=$(cd "$root" && find hls/bridge hls/numeric hls/six_step model/design testbench/sweep drives -type f | LC_ALL=C sort | xargs cat |
  sha256sum | cut -c 1-12)
seed=$((16#$seed))
echo "seed $seed"
"$steplock" sweep "$@" --jobs 1 --runs "$runs" --seed "$seed" --rtl 0.03 --out "$work"
jq -e --argjson most "$most" '.runs == .started and .inside.started_after_retries <= $most and .rtl_repeats > 0 and .rtl_differing == 0' \
  "$work/sweep.json"
