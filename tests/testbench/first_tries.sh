#!/usr/bin/env bash
# first_tries.sh STEPLOCK ROOT WORK RUNS DRIVE...: whether drawn starts all succeed at the first attempt: true or false, last.
#
# The seed is nobody's choice: it follows from the drive, its design and its judge (tools/starts).
set -euo pipefail
steplock=$1 root=$2 work=$3 runs=$4
shift 4
"$(dirname "$0")/../empty_folder" "$work"
digest=$(STEPLOCK_BUILD=$(dirname "$(dirname "$steplock")") "$root/tools/starts" --digest)
"$steplock" sweep "$@" --jobs 1 --runs "$runs" --seed-from "$digest" --rtl 0 --out "$work" || [ $? = 1 ]  # 1: a run was lost
jq -e '.runs == .started and .inside.started_after_retries == 0' "$work/sweep.json"
