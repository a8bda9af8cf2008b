#!/usr/bin/env bash
# hard_slice.sh STEPLOCK ROOT WORK: the first runs of docs/hard_starts.md again, with its seed: they are those that the
# page was printed from.
set -euo pipefail
steplock=$1 root=$2 work=$3
page=$root/docs/hard_starts.json
rm -rf "$work"
# Exit code 1: a run was lost, as the page says of it; the digest below tells whether it is the same one.
"$steplock" sweep "$root"/drives/*.toml --matrix hard --runs "$(jq .prefix.runs "$page")" --seed "$(jq .seed "$page")" \
  --rtl "$(jq .rtl "$page")" --jobs 1 --out "$work" --page "$work/docs/hard_starts.md" || [ $? -eq 1 ]
[ "$(jq -c .prefix "$work/docs/hard_starts.json")" = "$(jq -c .prefix "$page")" ] || {
  echo "docs/hard_starts.md is stale; print it again with the command in its first line" >&2
  exit 1
}
