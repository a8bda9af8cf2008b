#!/usr/bin/env bash
# The first start of rtl/bench in Icarus, for a drive's words, or with a flaw that it has to notice.
#   bench.sh [--verilator | --bit | --deaf | --both] DRIVE WORK
#     --verilator  in Verilator, which has to say the same as Icarus
#     --bit   a bit in the list that no register has       --deaf  a drive that does not hear its fault pin
#     --both  a drive that turns on both gates of a leg
set -euo pipefail
flaw=none
case $1 in --*) flaw=$1; shift ;; esac
drive=$1 work=$2
cd "$(dirname "$0")/../.."
mkdir -p "$work"
words=$work/$drive.mem
cp "rtl/words/$drive.mem" "$words"
mapfile -t files <rtl/six_step_axi.f
top=$work/six_step_axi.sv
case $flaw in
  --bit) sed -i 's/^0000008c_./0000008c_8/' "$words"; cmp -s "rtl/words/$drive.mem" "$words" && exit 2 ;;
  --deaf) sed "s/\.pins_fault_i(pins_fault_i)/.pins_fault_i(1'b0)/" rtl/six_step_axi.sv >"$top" ;;
  --both) sed 's/assign gates_ul_o = .*/assign gates_ul_o = gates_uh_o;/' rtl/six_step_axi.sv >"$top" ;;
esac
if [ -f "$top" ]; then
  cmp -s rtl/six_step_axi.sv "$top" && { echo "bench.sh: the flaw found no place"; exit 2; }
  files=("${files[@]/rtl\/six_step_axi.sv/$top}")
fi
iverilog -g2012 -o "$work/first_start.vvp" -s first_start "${files[@]}" rtl/bench/axi_host.sv rtl/bench/hosted_drive.sv rtl/bench/judge.sv rtl/bench/first_start.sv
vvp -n "$work/first_start.vvp" "+words=$words" | tee "$work/log"
[ $flaw = --verilator ] || exit 0
grep -v WARNING "$work/log" >"$work/icarus"
verilator --binary --timing -Wno-fatal -Wno-TIMESCALEMOD --top-module first_start --Mdir "$work/verilated" "${files[@]}" \
  rtl/bench/axi_host.sv rtl/bench/hosted_drive.sv rtl/bench/judge.sv rtl/bench/first_start.sv >"$work/verilator.log" 2>&1 || { tail -n 5 "$work/verilator.log"; exit 2; }
"$work/verilated/Vfirst_start" "+words=$words" | grep -v finish >"$work/verilator"
diff "$work/icarus" "$work/verilator" && echo "both say the same"
