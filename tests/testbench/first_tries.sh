#!/usr/bin/env bash
# first_tries.sh STEPLOCK ROOT WORK RUNS MOST DRIVE...: drawn starts, all of which succeed, at most MOST after a
# failed attempt, and the RTL agrees where it repeats one; how many that is, is by chance, so two more are all repeated.
#
# The seed is nobody's choice: it follows from the drive, its design and its judge (tools/starts).  Whoever changes one of them is judged on other motors.
# MOST: each attempt at the first try with 98.5 % (the goal for every drive), a sweep passes by chance 9996 times of 10000.
set -euo pipefail
steplock=$1 root=$2 work=$3 runs=$4 most=$5
shift 5
"$(dirname "$0")/../empty_folder" "$work"
digest=$(STEPLOCK_BUILD=$(dirname "$(dirname "$steplock")") "$root/tools/starts" --digest)
"$steplock" sweep "$@" --jobs 1 --runs "$runs" --seed-from "$digest" --rtl 0.03 --out "$work" || [ $? = 1 ]  # 1: a run was lost, which the next line tells
jq -e --argjson most "$most" '.runs == .started and .inside.started_after_retries <= $most and .rtl_differing == 0' "$work/sweep.json"
"$steplock" sweep "$@" --jobs 1 --runs 2 --seed-from "$digest" --rtl 1 --out "$work/rtl"
jq -e '.rtl_repeats == 2 and .rtl_differing == 0' "$work/rtl/sweep.json"
