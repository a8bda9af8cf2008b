#!/usr/bin/env bash
# stale_timing.sh FLAW: tools/timing --check refuses docs/timing.md with a flaw, before it places anything, and names the row.
#   figure       another clock, as if typed
#   cells        other cells of another family
#   checksum     another checksum, as if of other inputs
#   missing      a top without a row
set -euo pipefail
cd "$(dirname "$0")/../.."
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
case $1 in
  figure) row=six_step_axi change='s/^\(| six_step_axi |\) [0-9]*/\1 999/' ;;
  cells) row=six_step_axi_lean change='s/^\(| six_step_axi_lean .*\)\([0-9]\) |$/\1\29 |/' ;;
  checksum) row=six_step_fixed change='s/^six_step_fixed .*/six_step_fixed 0123456789abcdef/' ;;
  missing) row=sinusoidal_top change='/^| sinusoidal_top |/d' ;;
  *) echo "stale_timing.sh: no flaw '$1'" >&2; exit 2 ;;
esac
sed "$change" docs/timing.md >"$work/page"
! cmp -s docs/timing.md "$work/page" || { echo "$1: the page stays as it is"; exit 1; }
if tools/timing --check "$work/page" >"$work/said" 2>&1; then echo "$1: taken all the same"; exit 1; fi
grep -qF "$work/page is stale ($row);" "$work/said" || { cat "$work/said"; echo "$1: refused for another reason"; exit 1; }
echo "$1: refused"
