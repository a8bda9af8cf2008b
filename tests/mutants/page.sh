#!/usr/bin/env bash
# page.sh ROOT BUILD: docs/mutants.md counts as many mutants of each block as there are now, and none that survives.
set -euo pipefail
cd "$1"
status=0
while IFS=$'\t' read -r block listed survive; do
  now=$("$2/bin/draw_mutants" hls/*/"$block.hpp" | wc -l)
  [ "$now" -eq "$listed" ] || { echo "docs/mutants.md lists $listed mutants of $block, there are $now; run tools/mutants"; status=1; }
  [ "$survive" -eq 0 ] || { echo "docs/mutants.md: $survive mutants of $block survive"; status=1; }
done < <(sed -n 's/^| \[\([a-z_]*\)\](.*) | \([0-9]*\) |.* | \([0-9]*\) |$/\1\t\2\t\3/p' docs/mutants.md)
for stem in $(sed -n 's/^all=(\(.*\))$/\1/p' tools/mutants); do
  grep -q "^| \[${stem##*/}\]" docs/mutants.md || { echo "docs/mutants.md has no ${stem##*/}; run tools/mutants"; status=1; }
done
grep -q '^| \[' docs/mutants.md || { echo "docs/mutants.md has no blocks"; status=1; }
exit $status
