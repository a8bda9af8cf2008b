#!/usr/bin/env bash
# stale_print.sh FLAW: checks the page of Matsui's paper with a flaw (tools/pages --check, tools/printed.sh), and has its
# shortest section, 7, measured again.  Succeeds if that is refused for what it is.
#   none         as it is, which must be taken: so what is refused below is the flaw
#   edited       another figure, as if typed, in a section that is not measured again; drawn the same of a drawing
#   measured     a figure of section 7 is not what is measured, though the checksum agrees; missing the row is not there
#   experiment   the page was printed by another experiment
set -euo pipefail
root=$(cd "$(dirname "$0")/../.." && pwd)
cd "$root"
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cp -r docs "$work/docs"
page=$work/docs/papers/matsui1996.md
export STEPLOCK_DOCS=$work/docs STEPLOCK_SECTIONS=7

# sealed: with the checksum that the flawed page would have
sealed() {
  # shellcheck source=tools/printed.sh
  (docs=$STEPLOCK_DOCS && . tools/printed.sh && seal matsui1996 "$docs") >"$work/seal"
  sed -i '$d' "$page"
  cat "$work/seal" >>"$page"
}
# flawed SED: changes the page
flawed() { cp "$page" "$work/whole"; sed -i "$1" "$page"; ! cmp -s "$page" "$work/whole"; }
# refused TEXT: it fails, and says TEXT
refused() {
  if tools/pages --check matsui1996 >"$work/said" 2>&1; then echo "taken all the same"; return 1; fi
  cat "$work/said"
  grep -qF "$1" "$work/said"
}
section='/^## Fig. 6/,/^## Fig. 7/'

case $1 in
  none) tools/pages --check matsui1996 ;;
  edited) flawed '/^## Fig. 4/,/^## /s/^\(| [^|]*| [^|]*| -\?[0-9]*\)\([0-9]\)/\1\27/'; refused "its checksum is not that" ;;
  drawn)
    figure=$(find "$work/docs/papers/matsui1996" -name '*.svg' | sort | head -n 1)
    sed -i 's/width="/width="1/' "$figure"
    refused "its checksum is not that" ;;
  measured) flawed "$section"'s/^\(| [^|]*| [^|]*| -\?[0-9]*\)\([0-9]\)/\1\27/'; sealed; refused "it is not what is measured" ;;
  missing) flawed "$section"'{/^| [^q-]/d}'; sealed; refused "it is not what is measured" ;;
  experiment)
    docs=$STEPLOCK_DOCS; . tools/printed.sh
    eval "$(declare -f printed_by | sed '1s/printed_by/as_printed/')"
    printf 'another\n' >"$work/other.cpp"
    printed_by() { as_printed "$1"; echo "$work/other.cpp"; }
    seal matsui1996 "$docs" >"$work/seal"
    sed -i '$d' "$page"
    cat "$work/seal" >>"$page"
    refused "its checksum is not that" ;;
  *) echo "stale_print.sh: no flaw '$1'" >&2; exit 2 ;;
esac
