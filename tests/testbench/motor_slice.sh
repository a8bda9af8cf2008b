#!/usr/bin/env bash
# motor_slice.sh STEPLOCK ROOT WORK: the motors of docs/motor_starts.md again, and its first runs: they are those that the
# page was printed from.
set -euo pipefail
steplock=$1 root=$2 work=$3
page=$root/docs/motor_starts.json
rm -rf "$work"
"$steplock" motors --count 300 --seed "$(jq .seed "$page")" --out "$work/motors" >/dev/null
for file in "$work"/motors/*.toml; do "$steplock" design "$file" >/dev/null 2>&1 || rm "$file"; done
# Exit code 1: a run was lost, as the page says of it; the digest below tells whether it is the same one.
"$steplock" sweep "$work"/motors/*.toml --runs "$(jq .prefix.runs "$page")" --seed "$(jq .seed "$page")" \
  --rtl "$(jq .rtl "$page")" --jobs 1 --out "$work/sweep" --page "$work/docs/motor_starts.md" || [ $? -eq 1 ]
[ "$(jq -c .prefix "$work/docs/motor_starts.json")" = "$(jq -c .prefix "$page")" ] || {
  echo "docs/motor_starts.md is stale; print it again with the command in its first line" >&2
  exit 1
}
