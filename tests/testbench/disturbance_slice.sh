#!/usr/bin/env bash
# disturbance_slice.sh STEPLOCK ROOT WORK: the first runs of docs/disturbances.md again, with its seed.  All
# end as they must, where the RTL repeats one it agrees, and they are those that the page was printed from.
set -euo pipefail
steplock=$1 root=$2 work=$3
page=$root/docs/disturbances.json
"$(dirname "$0")/../empty_folder" "$work"
"$steplock" sweep "$root"/drives/*.toml --matrix disturb --runs "$(jq .prefix.runs "$page")" --seed "$(jq .seed "$page")" \
  --jobs 1 --out "$work" --page "$work/docs/disturbances.md"
jq -e '.passed and .silent_step_outs == 0 and .rtl_differing == 0' "$work/sweep.json"
[ "$(jq -c .prefix "$work/docs/disturbances.json")" = "$(jq -c .prefix "$page")" ] || {
  echo "docs/disturbances.md is stale; print it again with the command in its first line" >&2
  exit 1
}
