#!/usr/bin/env bash
# The field's words: no name of vocabulary.tsv's first column stands anywhere as a word of its own.
#   vocabulary.sh ROOT WORDS.tsv
# Left out: the change log, what translates old names (drive files' keys, the digest of published starts), and flaws for tests.
set -euo pipefail
words=$(realpath "$2")
cd "$1"
found=0 read=0
while IFS=$'\t' read -r old new; do
  [[ $old && $old != '#'* ]] || continue
  read=$((read + 1))
  if said=$(grep -rInE "\\b$old\\b" README.md CONTRIBUTING.md hls rtl model testbench constraints tests docs generator drives tools \
      --exclude-dir=flaws --exclude="$(basename "$words")" --exclude=renamed_keys.hpp --exclude=starts --exclude=starts_digest.sh \
      --exclude='*.svg' --exclude='*.json'); then
    found=1
    sed "s/^\([^:]*:[0-9]*\):.*/\1: $old; write ${new//\//\\/}/" <<<"$said"
  fi
done <"$words"
[ "$read" -gt 0 ] || { echo "$words: no words in it"; exit 1; }
exit $found
