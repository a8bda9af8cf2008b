#!/usr/bin/env bash
# placed.sh BOARD DRIVE OUT: tools/bitstream places the board at its clock, and what it says of cells and clock is
# what docs/boards.md shows of board and drive, to 5 %; block RAMs and DSP are the same.
# placed.sh --judge BOARD DRIVE SAID: the comparison alone
set -euo pipefail
if [ "$1" = --judge ]; then
  board=$2 drive=$3 said=$4
else
  board=$1 drive=$2
  said=$(tools/bitstream "$1" "$2" "$3")
  echo "$said"
  said=${said#*: }
fi
shown=$(sed -n "s/^| [^|]* | \`$board\` | \`$(basename "$drive" .toml)\` | \(.*\) |$/\1/p" docs/boards.md)
# Cells, of how many, block RAMs, DSP, clock, what it is good for.
paste <(grep -oE '[0-9]+(\.[0-9]+)?' <<<"$said") <(grep -oE '[0-9]+(\.[0-9]+)?' <<<"$shown") |
  awk -v shown="$shown" '{ near = NR == 1 || NR == 6 ? 0.05 : 0; if ($1 > (1 + near) * $2 || $1 < (1 - near) * $2) bad = 1 }
    END { if (bad || NR != 6) { print "docs/boards.md shows: " shown; exit 1 } }'
