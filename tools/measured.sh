# shellcheck shell=bash disable=SC2154  # work
# To synthesize for iCE40 and count, and to know what need not be measured again.  tools/size sources
# it, in the root of the project and with `work` a scratch folder.
#
# A page keeps in a comment at its end a checksum of each thing measured: of all that its figures follow from (the
# Verilog without comments, the tools' versions, how they are called), and of the figures as they stand in the page.
# Where it agrees the figures are taken from the page.  A checksum can be made up, so the tests measure some again,
# drawn by the commit: in time all of them.

# without_comments FILE...: what is measured and what a checksum is of.  Comments name lines of the C++, which move; and Yosys
# names what it makes after the line it stands in: sinusoidal_sequence took 619 to 666 cells under headers of other lengths.
without_comments() { sed 's#//.*##; s/[[:space:]]*$//; /^$/d' "$@"; }

# cells DEVICE SYNTH_OPTIONS MODULE FILE...: "cells luts flops carries dsp ram", logic cells those of nextpnr after
# packing, the rest those of Yosys
cells() {
  local device=$1 options=$2 module=$3; shift 3
  local stem=$work/$module.$BASHPID.$RANDOM packed file names=()
  mkdir "$stem.rtl"
  for file in "$@"; do
    names+=("${file##*/}")
    without_comments "$file" >"$stem.rtl/${file##*/}"
  done
  # In their folder, since names of files are in those names, too.
  # shellcheck disable=SC2086  # several options
  (cd "$stem.rtl" && yosys -Q -p "read_verilog -sv ${names[*]}; synth_ice40 $options -top $module -json $stem.json; tee -o $stem.stat stat") \
    >"$stem.log" 2>&1 || { tail -n 5 "$stem.log" >&2; echo "tools/${0##*/}: Yosys could not synthesize $module" >&2; return 1; }
  # shellcheck disable=SC2086
  nextpnr-ice40 $device --pack-only --json "$stem.json" >"$stem.pack" 2>&1 || true  # more than fit: packed all the same
  packed=$(sed -n 's/^Info:[[:space:]]*ICESTORM_LC:[[:space:]]*\([0-9]*\)\/.*/\1/p' "$stem.pack" | tail -n 1)
  [ -n "$packed" ] || { tail -n 5 "$stem.pack" >&2; echo "tools/${0##*/}: nextpnr could not pack $module" >&2; return 1; }
  awk -v cells="$packed" '
    $1 == "SB_LUT4" { lut = $2 } $1 ~ /^SB_DFF/ { ff += $2 } $1 == "SB_CARRY" { carry = $2 } $1 ~ /^SB_MAC16/ { dsp += $2 }
    $1 ~ /^SB_RAM40/ { ram += $2 }
    END { printf "%d %d %d %d %d %d\n", cells, lut, ff, carry, dsp, ram }' "$stem.stat"
}

yosys_version=$(yosys -V)
nextpnr_version=$(nextpnr-ice40 --version 2>&1)
# tools_used OPTIONS: for the head of a page
tools_used() {
  echo "$(cut -d' ' -f1,2 <<<"$yosys_version"), \`synth_ice40\`$1;" \
    "$(sed -n 's/.*(Version \([^)]*\)).*/nextpnr-ice40 \1/p' <<<"$nextpnr_version")"
}

# checksum FIGURES HOW FILE...: HOW is the text of what calls the tools, beside cells().
checksum() {
  local figures=$1 how=$2; shift 2
  { echo "$figures"; echo "$how"; declare -f cells without_comments; echo "$yosys_version $nextpnr_version"
    without_comments "$@"; } | sha256sum | cut -c 1-16
}

# known PAGE NAME CHECKSUM
known() {
  [ -f "$1" ] && awk -v line="$2 $3" '/^<!-- checksums/ { on = 1 } on && $0 == line { found = 1 } END { exit !found }' "$1"
}

# checksums FILE: the comment, of the lines `NAME CHECKSUM`
checksums() { printf '\n<!-- checksums of what was measured and what it was measured from: tools/measured.sh\n'; cat "$1"; echo '-->'; }

# drawn CELLS: of the lines `NAME CELLS` read, the names to measure again: in an order that follows from the commit, the
# first, and those after it until they are CELLS in all.  To begin a measurement takes as long as a thousand of them.
drawn() {
  local by name cells all
  by=$(git rev-parse HEAD 2>/dev/null || date +%F)
  all=$(while read -r name cells; do echo "$(sha256sum <<<"$by $name" | cut -c 1-16) $name $cells"; done | sort |
    awk -v most="$1" '{ all += $3 + 1000 } NR == 1 || all <= most { print $2 }')
  # shellcheck disable=SC2086  # in a line
  echo "tools/${0##*/}: measured again, as drawn by $by:" $all >&2
  echo "$all"
}

# refuse_stale PAGE PART NAME...: fails if there are any
refuse_stale() {
  [ $# -gt 2 ] || return 0
  echo "$1 is stale (${*:3}); print it again with tools/pages $2" >&2
  return 1
}

# measure_again STEM COMMAND NAME...: what `COMMAND NAME` prints, into $work/STEM.NAME, one on each core
measure_again() {
  local stem=$1 command=$2 name pid pids=(); shift 2
  for name in "$@"; do
    while [ "$(jobs -rp | wc -l)" -ge "$(nproc)" ]; do wait -n; done
    "$command" "$name" >"$work/$stem.$name" &
    pids+=($!)
  done
  for pid in "${pids[@]}"; do wait "$pid"; done
}

# show_or_compare MODE PAGE PRINTED: with --check it fails if they differ
show_or_compare() {
  if [ "$1" != --check ]; then cat "$3"; return; fi
  diff "$2" "$3" >"$work/differs" && return
  echo "$2 is not what is measured (<: the page); print it again with tools/${0##*/} --again:" >&2
  head -n 10 "$work/differs" >&2
  return 1
}
