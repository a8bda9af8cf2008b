#!/usr/bin/env bash
# What a drive does when it is used wrongly, in Verilator: docs/wrong_uses.md.
#   wrong_uses.sh --print WORK        its rows, into the page; some minutes
#   wrong_uses.sh --check WORK        the uses that end within 310 ms again: fails if the page's rows are others, or if the page, whose other
#                                     rows take minutes, is of another core, bench or configuration than these
set -euo pipefail
mode=$1 work=$2 page=docs/wrong_uses.md
cd "$(dirname "$0")/../.."
tests/empty_folder "$work"
bench=(rtl/bench/axi_host.sv rtl/bench/host_tasks.svh rtl/bench/hosted_drive.sv rtl/bench/judge.sv rtl/bench/drive_properties.sv rtl/bench/motor.sv rtl/bench/wrong_uses.sv)
words=rtl/config/maxon_ec45_flat.mem
# Without comments: of what the rows follow from.
of="<!-- of $(xargs cat <rtl/six_step_axi.f | cat - "${bench[@]}" "$words" | sed 's, *//.*,,; /^$/d' | sha256sum | cut -c 1-16) -->"
if [ "$mode" = --check ] && ! grep -q -x -F -e "$of" "$page"; then
  echo "$page is of another core, bench or configuration; print it again with tests/rtl/wrong_uses.sh --print WORK"
  exit 1
fi
tools/bench --out "$work" --compile verilator wrong_uses
uses=$(seq 0 24)
[ "$mode" = --print ] || uses=$(awk -F'|' '/^\| [0-9]/ && $8 + 0 <= 310 { print $2 + 0 }' "$page")
export work words
for use in $uses; do echo "$use"; done | xargs -P "$(nproc)" -I USE sh -c \
  '"$work/verilated/Vwrong_uses" +config=$words +use=USE >"$work/USE.log" 2>&1 || true'
grep -h -a FAILED "$work"/*.log && exit 1
said=$(cat "$work"/*.log | grep -c '^|') asked=$(echo "$uses" | wc -l)
[ "$said" = "$asked" ] && [ "$asked" -ge 15 ] || { echo "$said rows of $asked uses; $page should have fifteen that end soon"; exit 1; }
rows=$(grep -h '^|' "$work"/*.log | sort -t'|' -k2n)
if [ "$mode" = --print ]; then
  # A row where the page has the one of that number, and of what they are.
  awk -F'|' -v of="$of" 'NR == FNR { row[$2 + 0] = $0; next }
    /^\| [0-9]/ { print row[$2 + 0]; delete row[$2 + 0]; next }
    /^<!-- of / { print of; next }
    { print }
    END { for (use in row) { print "the page has no row " use > "/dev/stderr"; exit 1 } }' <(echo "$rows") "$page" >"$work/page.md"
  cp "$work/page.md" "$page"
  echo "wrote $page"
  exit
fi
missing=$(echo "$rows" | grep -v -x -F -f "$page" || true)
[ -z "$missing" ] || { echo "$page has not these rows; print them again with tests/rtl/wrong_uses.sh --print WORK:"; echo "$missing"; exit 1; }
echo "$(echo "$rows" | wc -l) rows are current"
