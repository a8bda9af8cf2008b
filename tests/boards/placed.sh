#!/usr/bin/env bash
# placed.sh BOARD DRIVE OUT: tools/bitstream places the board at its clock, and what it says of cells and clock is
# what docs/boards.md shows of board and drive, to 5 %; block RAMs and DSP are the same.
# placed.sh --judge same | cells | dsp BOARD DRIVE: the comparison alone, with the page's own figures, or 6 % more cells, or other DSP
set -euo pipefail
judge=""
if [ "$1" = --judge ]; then judge=$2; shift 2; fi
board=$1 drive=$2
shown=$(sed -n "s/^| [^|]* | \`$board\` | \`$(basename "$drive" .toml)\` | \(.*\) |$/\1/p" docs/boards.md)
case $judge in
  "")
    said=$(tools/bitstream "$board" "$drive" "$3")
    echo "$said"
    said=${said#*: } ;;
  same) said=$shown ;;
  cells) said=$(awk '{ $1 = int(1.06 * $1); print }' <<<"$shown") ;;
  dsp) said=$(sed -E 's/[0-9]+ DSP/99 DSP/' <<<"$shown") ;;
  *) echo "placed.sh: '$judge' is none of same, cells, dsp" >&2; exit 2 ;;
esac
# Cells, of how many, block RAMs, DSP, clock, what it is good for.
paste <(grep -oE '[0-9]+(\.[0-9]+)?' <<<"$said") <(grep -oE '[0-9]+(\.[0-9]+)?' <<<"$shown") |
  awk -v shown="$shown" '{ near = NR == 1 || NR == 6 ? 0.05 : 0; if ($1 > (1 + near) * $2 || $1 < (1 - near) * $2) bad = 1 }
    END { if (bad || NR != 6) { print "docs/boards.md shows: " shown; exit 1 } }'
