#!/usr/bin/env bash
# page_slice.sh STEPLOCK ROOT WORK PAGE [OPTION...]: the first runs of docs/PAGE.md again, with its seed: they are those
# that the page was printed from.  The options are those of its sweep.  Of motor_starts the motors are drawn again, too.
set -euo pipefail
steplock=$1 root=$2 work=$3 name=$4
shift 4
page=$root/docs/$name.json
"$(dirname "$0")/../empty_folder" "$work"
files=("$root"/drives/*.toml)
if [ "$name" = motor_starts ]; then
  "$steplock" motors --count 300 --seed "$(jq .seed "$page")" --out "$work/motors" >/dev/null
  for file in "$work"/motors/*.toml; do "$steplock" design "$file" >/dev/null 2>&1 || rm "$file"; done
  files=("$work"/motors/*.toml)
fi
# Exit code 1: a run was lost, as the page says of it; the digest below tells whether it is the same one.
"$steplock" sweep "${files[@]}" "$@" --runs "$(jq .prefix.runs "$page")" --seed "$(jq .seed "$page")" \
  --rtl "$(jq .rtl "$page")" --jobs 1 --out "$work/sweep" --page "$work/docs/$name.md" || [ $? -eq 1 ]
[ "$(jq -c .prefix "$work/docs/$name.json")" = "$(jq -c .prefix "$page")" ] || {
  echo "docs/$name.md is stale; print it again with the command in its first line" >&2
  exit 1
}
