#!/usr/bin/env bash
# size_ratios.sh PAGE LIMIT: every module of the printed page with a hand-written yardstick takes at
# most LIMIT times its cells, and there are two yardsticks at least.
set -euo pipefail
awk -F'|' -v limit="$2" '
  NF > 8 && $9 ~ /[0-9]/ { ++rows; printf "%s %.2f\n", $2, $9; if ($9 > limit) { bad = 1; print "  is above " limit } }
  END { if (rows < 2) { print "fewer than two yardsticks"; exit 1 } exit bad }' "$1"
