#!/usr/bin/env bash
# slice.sh STEPLOCK ROOT WORK I/N: every N-th of the first 100 runs of docs/starts.md again, with its seed, into a folder
# of its own: so as many cores as there are take part from the first second.
# slice.sh STEPLOCK ROOT WORK whole N: these N together.  All start, where the RTL repeats one it agrees on every clock,
# at most 7 after a failed attempt, and they are those that the page was printed from.  (7: each attempt at the first try with 98.5 %,
# the goal for every drive, a sweep passes by chance 9998 times of 10000.)
# Of them so few are repeated that there may be none: four more are all repeated.
set -euo pipefail
steplock=$1 root=$2 work=$3 part=$4
page=$root/docs/starts.json
runs=$(jq .prefix.runs "$page")
again() { "$steplock" sweep "$root"/drives/*.toml --jobs 1 --runs "$runs" --seed "$(jq .seed "$page")" "$@"; }
if [ "$part" != whole ]; then
  rm -rf "$work/${part%/*}"
  again --shard "$part" --out "$work/${part%/*}"
  exit
fi
count=$5
rm -rf "$work/whole"
mapfile -t shards < <(seq -f "$work/%g" 0 $((count - 1)))
"$steplock" merge "${shards[@]}" --out "$work/whole" >/dev/null || [ $? -eq 1 ]
again --resume --out "$work/whole" --page "$work/whole/docs/starts.md" >/dev/null || [ $? -eq 1 ]
jq -e --argjson runs "$runs" '.runs == $runs and .started == $runs and .inside.started_after_retries <= 7 and .rtl_differing == 0' "$work/whole/sweep.json"
rm -rf "$work/rtl"
"$steplock" sweep "$root"/drives/*.toml --runs 4 --rtl 1 --seed "$(jq .seed "$page")" --out "$work/rtl" >/dev/null
jq -e '.rtl_repeats == 4 and .rtl_differing == 0' "$work/rtl/sweep.json"
[ "$(jq -c .prefix "$work/whole/docs/starts.json")" = "$(jq -c .prefix "$page")" ] || {
  echo "docs/starts.md is stale; print it again with the command in its first line" >&2
  exit 1
}
