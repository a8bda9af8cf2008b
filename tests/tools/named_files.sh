#!/usr/bin/env bash
# Every file that a comment names behind Doc, Test or Proof and a colon is there.
#
#     named_files.sh ROOT FOLDER...     folders called `flaws` are left out
set -euo pipefail
cd "$1"
shift
missing=$(grep -rHnE '\b(Doc|Test|Proof):' "$@" --exclude-dir=flaws \
    --include='*.hpp' --include='*.cpp' --include='*.cmake' --include='*.h' |
  { grep -oE '^[^:]+:[0-9]+|\b(docs|tests|generator|tools)/[A-Za-z0-9_./-]+\.[a-z]+\b' || true; } |
  while read -r word; do
    if [[ $word == *:* ]]; then
      place=$word
    elif [[ ! -e $word ]]; then
      echo "$place: no file $word"
    fi
  done)
[[ -z $missing ]] || { echo "$missing"; exit 1; }
