#!/usr/bin/env bash
# first_tries.sh STEPLOCK ROOT WORK RUNS MOST DRIVE...: drawn starts, all of which succeed, at most MOST after a
# failed attempt or roughly, and the RTL agrees where it repeats one.
#
# The seed is nobody's choice: it follows from the drive, its design and its judge (tools/starts).  Whoever changes one of them is judged on other motors.
# MOST: each attempt at the first try with 98.5 % (the goal for every drive), a sweep passes by chance 9996 times of 10000.
# How many the RTL repeats is by chance too, and may be none; all_of_200_drawn_starts... has some.
set -euo pipefail
steplock=$1 root=$2 work=$3 runs=$4 most=$5
shift 5
rm -rf "$work"
digest=$("$root/tools/starts" --digest)
"$steplock" sweep "$@" --jobs 1 --runs "$runs" --seed-from "$digest" --rtl 0.03 --out "$work" || [ $? -eq 1 ]
jq -e --argjson most "$most" '.runs == .started + .rough and .inside.started_after_retries + .rough <= $most and .rtl_differing == 0' \
  "$work/sweep.json"
