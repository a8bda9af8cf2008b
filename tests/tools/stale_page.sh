#!/usr/bin/env bash
# stale_page.sh FLAW: checks docs/sizes.md with a flaw (tools/size --check), and
# has one small module measured again.  Succeeds if that is refused for what it is.
#   none         as it is, which must be taken: so what is refused below is the flaw
#   figure       another figure, as if typed
#   checksum     another checksum, as if of other inputs
#   missing      a module without a row
#   measured     measuring gives something else than the page shows, though all checksums agree
#   comments     none: the module has another header, which no checksum sees, and must take as many cells
set -euo pipefail
root=$(cd "$(dirname "$0")/../.." && pwd)
cd "$root"
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# flawed PAGE SED: a copy, with the flaw
flawed() { sed "$2" "$1" >"$work/page"; ! cmp -s "$1" "$work/page"; }
# refused TEXT TOOL FIGURE: it fails, and says TEXT
refused() {
  if "tools/$2" --check "$work/page" "$3" >"$work/said" 2>&1; then echo "taken all the same"; return 1; fi
  cat "$work/said"
  grep -qF "$1" "$work/said"
}

case $1 in
  none) tools/size --check docs/sizes.md apb ;;
  figure) flawed docs/sizes.md 's/^| apb | [0-9]*/&1/'; refused "is stale (apb);" size apb ;;
  checksum) flawed docs/sizes.md 's/^apb .*/apb 0123456789abcdef/'; refused "is stale (apb);" size apb ;;
  missing) flawed docs/sizes.md '/^| apb |/d; /^apb /d'; refused "is stale (apb);" size apb ;;
  measured)
    cp docs/sizes.md "$work/page"
    printf '#!/bin/sh\n%s "$@" 2>&1 | sed "s/\\(ICESTORM_LC: *\\)\\([0-9]\\)/\\11\\2/"\n' \
      "$(command -v nextpnr-ice40)" >"$work/nextpnr-ice40"
    chmod +x "$work/nextpnr-ice40"
    PATH=$work:$PATH refused "is not what is measured" size apb ;;
  comments)
    # shellcheck source=tools/measured.sh
    . tools/measured.sh
    for lines in 0 1 40; do
      mkdir "$work/$lines"
      { for ((i = 0; i < lines; ++i)); do echo "// Another line."; done; cat rtl/sinusoidal_sequence.sv; } >"$work/$lines/sinusoidal_sequence.sv"
      cells "--hx8k --package ct256" "" sinusoidal_sequence "$work/$lines/sinusoidal_sequence.sv" | tee -a "$work/taken"
    done
    [ "$(sort -u "$work/taken" | wc -l)" = 1 ] ;;
  *) echo "stale_page.sh: no flaw '$1'" >&2; exit 2 ;;
esac
