#!/usr/bin/env bash
# empty_folder.sh WORK: tests/empty_folder empties what may be emptied, and nothing else: a copy of it stands in a checkout of its own.
set -euo pipefail
root=$(cd "$(dirname "$0")/../.." && pwd)
work=$1
"$root/tests/empty_folder" "$work"
mkdir -p "$work/ours/"{tests,docs/blocks,.git,build/left} "$work/another/.git"
cp "$root/tests/empty_folder" "$work/ours/tests/"
touch "$work/ours/docs/page" "$work/ours/build/left/over" "$work/another/kept" "$work/file"
empty=$work/ours/tests/empty_folder
refused() {
  if said=$("$empty" "$@" 2>&1); then echo "not refused: $*"; exit 1; fi
  [[ $said == empty_folder:* ]] || { echo "refused otherwise: $said"; exit 1; }
}
refused
refused ""
refused "$work/ours"
refused "$work"
refused "$work/ours/docs"
refused "$work/ours/docs/blocks"
refused "$work/ours/.git"
refused "$work/another"
refused "$work/file"
(cd "$work/ours/docs" && refused . && refused .. && refused ../docs/blocks)
for kept in ours/docs/page another/kept file; do [ -e "$work/$kept" ] || { echo "$kept is gone"; exit 1; }; done
"$empty" "$work/ours/build/left"
[ -d "$work/ours/build/left" ] && [ ! -e "$work/ours/build/left/over" ] || { echo "build/left was not emptied"; exit 1; }
(cd "$work" && "$empty" new/one)
[ -d "$work/new/one" ] || { echo "new/one was not made"; exit 1; }
echo 'only what may be emptied is'
