#!/usr/bin/env bash
# The first start of rtl/bench in Icarus, for a drive's words, or with a flaw that it has to notice.
#   bench.sh [--verilator | --spi | --bit | --deaf | --both | --fast] DRIVE WORK
#     --verilator  in Verilator, which has to say the same as Icarus
#     --bit   a bit in the list that no register has       --deaf  a drive that does not hear its fault pin
#     --both  a drive that turns on both gates of a leg        --spi   over SPI
#     --fast  over SPI, twice as fast as the drive takes it
set -euo pipefail
flaw=none edit=''
case $1 in --*) flaw=$1; shift ;; esac
drive=$1 work=$2
cd "$(dirname "$0")/../.."
mkdir -p "$work"
# shellcheck source=tests/rtl/flawed.sh
. tests/rtl/flawed.sh
words=$work/$drive.mem
cp "rtl/config/$drive.mem" "$words"
options=(--out "$work")
case $flaw in
  --bit) sed -i 's/^0000008c_./0000008c_8/' "$words"; cmp -s "rtl/config/$drive.mem" "$words" && exit 2 ;;
  --deaf) edit="s/\.pins_fault_i(pins_fault_i)/.pins_fault_i(1'b0)/" ;;
  --fast) options+=(--with "$(flawed rtl/bench/spi_host.sv 's/int HALF = 4/int HALF = 2/')") ;;
  --both) edit='s/assign gates_ul_o = .*/assign gates_ul_o = gates_uh_o;/' ;;
esac
if [ -n "$edit" ]; then options+=(--with "$(flawed rtl/six_step_axi.sv "$edit")"); fi
bench=first_start
case $flaw in --spi | --fast) bench=first_start_spi ;; esac
tools/bench "${options[@]}" icarus $bench "+config=$words" | tee "$work/log"
[ $flaw = --verilator ] || exit 0
grep -v WARNING "$work/log" >"$work/icarus"
tools/bench "${options[@]}" verilator first_start "+config=$words" | grep -v finish >"$work/verilator"
diff "$work/icarus" "$work/verilator" && echo "both say the same"
