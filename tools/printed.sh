# shellcheck shell=bash disable=SC2154  # work, steplock, docs: of tools/pages, which sources it
# Pages of simulated figures: known by a checksum, and measured again in part.
#
# Such a page keeps in its last line a checksum of all else in it, of its figures, and of what printed them beside the
# drive: the experiment's source without comments, and the drive files.  So a figure typed into any row is noticed, and
# so is another experiment.  The drive itself and the motor (hls/, model/) are not in it.  Who changes those changes
# what is simulated, and each check simulates some again, spread over the page:
#
#   amano2003, matsui1996   some sections, drawn by the commit (tools/measured.sh): in time all of them
#   load                    of every drive one set speed of four, drawn by the commit
#   gallery                 three motors, drawn by the commit
#   range                   every cell of the table, which is from 10,000 eRPM on; slower points stand in the figure alone
#   sinusoidal_range        likewise, from 5,000 eRPM on
#
# Test: tests/tools/stale_print.sh

page_of() { case $1 in amano2003 | matsui1996) echo "papers/$1.md" ;; *) echo "$1.md" ;; esac; }

# printed_by PART: the experiment and its drives
printed_by() {
  case $1 in
    amano2003 | matsui1996) ls testbench/paper/"$1"* testbench/paper/paper_page.cpp drives/amano2003.toml drives/matsui1996.toml \
      drives/ipm_2k2.toml ;;
    load) ls testbench/range/load_envelope.cpp; grep -L '^kind *= *"sinusoidal"' drives/*.toml ;;
    gallery) ls testbench/range/gallery.cpp drives/data_sheets/*.toml ;;
    range) ls testbench/range/range.cpp testbench/range/six_step_range.cpp testbench/paper/ideal_rotor.hpp drives/br2804_drone.toml ;;
    sinusoidal_range) ls testbench/range/range.cpp testbench/range/sinusoidal_range.cpp drives/m2310p_sinusoidal.toml ;;
  esac
}

# figures_of PART DOCS
figures_of() {
  case $1 in
    amano2003 | matsui1996) ls "$2/papers/$1"/*.svg ;;
    load) ls "$2"/figures/load_*.svg ;;
    gallery) ls "$2"/figures/gallery_*.svg ;;
    range | sinusoidal_range) ls "$2"/figures/"$1".svg ;;
  esac
}

# seal PART DOCS: the last line
seal() {
  local sources figures
  mapfile -t sources < <(printed_by "$1")
  mapfile -t figures < <(figures_of "$1" "$2")
  { grep -v '^<!-- checksum ' "$2/$(page_of "$1")"
    cat "${figures[@]}"
    sed 's#//.*##; s/[[:space:]]*$//; /^$/d' "${sources[@]}"; } | sha256sum |
    sed 's/^\(.\{16\}\).*/<!-- checksum \1: tools\/printed.sh -->/'
}

# CPU ms of each section with the RTL engine
sections() {
  case $1 in
    amano2003) printf '%s\n' "1 15000" "2 9000" "3 16000" "4 12000" "5 20000" "6 32000" "7 30000" "8 31000" "9 80000" "10 40000" ;;
    matsui1996) printf '%s\n' "2 17000" "3 22000" "4 63000" "5 45000" "6 4000" "7 1000" "8 18000" "9 17000" "10 7000" ;;
  esac
}

# print_some PART: part of the page, into $work/docs
print_some() {
  local part=$1 some
  case $part in
    amano2003 | matsui1996)
      some=${STEPLOCK_SECTIONS:-$(sections "$part" | drawn 25000)}
      # shellcheck disable=SC2086  # several
      "$steplock" paper "$part" --engine rtl --section $some --out "$work/docs/papers" ;;
    load)
      some=$((16#$(git rev-parse HEAD 2>/dev/null | cut -c 1-6 | grep . || echo 0) % 4 + 1))
      echo "tools/pages: measured again, as drawn by the commit: set speed $some of each drive" >&2
      # shellcheck disable=SC2046  # a list of files
      "$steplock" envelope $(printed_by load | grep toml) --speed "$some" --out "$work/docs" ;;
    gallery)
      # shellcheck disable=SC2046  # a list of files
      "$steplock" gallery $(printed_by gallery | grep toml | sed 's/$/ 1000/' | drawn 6000 | sort) --out "$work/docs" ;;
    range) "$steplock" range --from 10000 --out "$work/docs" ;;
    sinusoidal_range) "$steplock" range drives/m2310p_sinusoidal.toml --from 5000 --out "$work/docs" ;;
  esac >"$work/$part.log" || { cat "$work/$part.log" >&2; return 1; }
}

# check_print PART: fails, and says why, if the page is stale
check_print() {
  local part=$1 page figure figures
  page=$docs/$(page_of "$part")
  if [ "$(tail -n 1 "$page")" != "$(seal "$part" "$docs")" ]; then
    echo "$page is stale: its checksum is not that of its text, its figures and what prints it; tools/pages $part" >&2
    return 1
  fi
  print_some "$part" || return 1
  grep -q '^| ' "$work/docs/$(page_of "$part")" || { echo "tools/pages: nothing of $page was measured" >&2; return 1; }
  # Every line that was printed stands there, in this order.
  diff "$page" "$work/docs/$(page_of "$part")" >"$work/$part.diff" || true
  if grep '^>' "$work/$part.diff" >"$work/$part.new"; then
    echo "$page is stale: it is not what is measured; print it again with tools/pages $part:" >&2
    head -n 10 "$work/$part.new" >&2
    return 1
  fi
  case $part in load | range | sinusoidal_range) return 0 ;; esac  # their figures are of all points
  mapfile -t figures < <(cd "$work/docs" && find . -name '*.svg' -path "*$part*")
  for figure in "${figures[@]}"; do
    cmp -s "$work/docs/$figure" "$docs/$figure" && continue
    echo "$docs/${figure#./} is stale; print it again with tools/pages $part" >&2
    return 1
  done
}
