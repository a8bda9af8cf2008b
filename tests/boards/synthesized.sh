#!/usr/bin/env bash
# synthesized.sh BOARD DRIVE OUT: tools/bitstream synthesizes the board, and its cells are those that docs/boards.md
# shows, to 5 %: another Yosys maps otherwise.       synthesized.sh --judge BOARD CELLS: the comparison alone
set -euo pipefail
if [ "$1" = --judge ]; then
  board=$2 made=$3
else
  board=$1
  made=$(tools/bitstream "$1" "$2" "$3")
  echo "$made"
  made=${made#*: }
fi
shown=$(sed -n "s/^| [^|]* | \`$board\` |[^|]*| \([^|]*DSP\) |.*/\1/p" docs/boards.md)
paste <(grep -o '[0-9]\+' <<<"$made") <(grep -o '[0-9]\+' <<<"$shown") |
  awk -v shown="$shown" '{ ++rows; if ($1 > 1.05 * $2 || $1 < 0.95 * $2) bad = 1 }
    END { if (bad || rows != 3) { print "docs/boards.md shows: " shown; exit 1 } }'
