#!/usr/bin/env bash
# slice.sh STEPLOCK ROOT WORK: the first 300 runs of docs/starts.md again, with its seed.  All start, where
# the RTL repeats one it agrees on every clock, and they are those that the page was printed from.
set -euo pipefail
steplock=$1 root=$2 work=$3
page=$root/docs/starts.json
rm -rf "$work"
"$steplock" sweep "$root"/drives/*.toml --jobs 1 --runs "$(jq .prefix.runs "$page")" --seed "$(jq .seed "$page")" \
  --out "$work" --page "$work/docs/starts.md"
jq -e '.runs == 300 and .started == 300 and .rtl_repeats > 0 and .rtl_differing == 0' "$work/sweep.json"
[ "$(jq -c .prefix "$work/docs/starts.json")" = "$(jq -c .prefix "$page")" ] || {
  echo "docs/starts.md is stale; print it again with the command in its first line" >&2
  exit 1
}
