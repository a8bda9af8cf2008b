#!/usr/bin/env bash
# page.sh ROOT BUILD [EQUIVALENT]: docs/mutants.md counts as many mutants of each block as there are now, and none that survives;
# and what tests/mutants/equivalent.tsv (or EQUIVALENT) excuses is a mutant of today.
set -euo pipefail
cd "$1"
status=0
while IFS=$'\t' read -r block listed survive; do
  now=$("$2/bin/draw_mutants" "$(ls hls/*/"$block.hpp" model/plant/"$block.cpp" 2>/dev/null)" | wc -l)
  [ "$now" -eq "$listed" ] || { echo "docs/mutants.md lists $listed mutants of $block, there are $now; run tools/mutants"; status=1; }
  [ "$survive" -eq 0 ] || { echo "docs/mutants.md: $survive mutants of $block survive"; status=1; }
done < <(sed -n 's/^| \[\([a-z0-9_]*\)\](.*) | \([0-9]*\) |.* | \([0-9]*\) |$/\1\t\2\t\3/p' docs/mutants.md)
for stem in $(STEPLOCK_BUILD=$2 tools/mutants --list); do
  grep -q "^| \[${stem##*/}\]" docs/mutants.md || { echo "docs/mutants.md has no ${stem##*/}; run tools/mutants"; status=1; }
done
# Number, file, line, column, from, to, as tools/mutants looks for them: with the code of the line, and what stands before.
while IFS=$'\t' read -r file code before from to _; do
  "$2/bin/draw_mutants" "$file" | while IFS=$'\t' read -r _ line column was becomes; do
    [ "$was" = "$from" ] && [ "$becomes" = "$to" ] || continue
    text=$(sed -n "${line}p" "$file")
    if [ "$(sed 's/^ *//; s/ *\/\/.*//' <<<"$text")" = "$code" ] && [ "$(sed 's/^ *//' <<<"${text:0:column-1}")" = "$before" ]; then echo found; fi
  done | grep -q found || { echo "$(basename "${3-equivalent.tsv}"): no mutant of $file puts '$to' for '$from' in: $code"; status=1; }
done <"${3-tests/mutants/equivalent.tsv}"
grep -q '^| \[' docs/mutants.md || { echo "docs/mutants.md has no blocks"; status=1; }
exit $status
