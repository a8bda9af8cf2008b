#!/usr/bin/env bash
# disturbance_slice.sh STEPLOCK ROOT WORK KIND PAGE: the first runs of docs/PAGE.md again, of drives of this kind, with its seed.  It is
# that of what is judged today; none of the runs is silently out of step, those of six-step drives all end as they must, where the RTL repeats
# one it agrees, and they are those that the page was printed from.
set -euo pipefail
steplock=$1 root=$2 work=$3 kind=$4 page=$5
json=$root/docs/$page.json
"$(dirname "$0")/../empty_folder" "$work"
"$steplock" sweep "$root"/drives/*.toml --kind "$kind" --matrix disturb --runs "$(jq .prefix.runs "$json")" --seed "$(jq .seed "$json")" \
  --jobs 1 --out "$work" --page "$work/docs/$page.md" || [ "$kind" = sinusoidal ]
[ "$kind" = sinusoidal ] && of=--sinusoidal || of=
digest=$(STEPLOCK_BUILD=$(dirname "$(dirname "$steplock")") "$root/tools/starts" $of --disturb --digest)
[ "$(jq -r .judged "$json")" = "$digest" ] || {
  echo "docs/$page.md is of another drive or judge than today's; print it again with the command in its first line" >&2
  exit 1
}
jq -e '(.passed or .drive_kind == "sinusoidal") and .silent_step_outs == 0 and .rtl_differing == 0' "$work/sweep.json"
[ "$(jq -c .prefix "$work/docs/$page.json")" = "$(jq -c .prefix "$json")" ] || {
  echo "docs/$page.md is stale; print it again with the command in its first line" >&2
  exit 1
}
