#!/usr/bin/env bash
# Random traffic on a drive under the properties of rtl/bench, in Verilator; or on one with a flaw, which they have to notice.
#   properties.sh [--sinusoidal] CLOCKS WORK         traffic, with the words of a drive
#   properties.sh [--sinusoidal] --FLAW WORK         one of those below: prints `noticed` if the right promise was found broken
#   properties.sh [--sinusoidal] --icarus WORK       Icarus and Verilator count the same
#   properties.sh [--sinusoidal] --map WORK          the registers that they take for keyed or read-only are those of the register map's page
#   properties.sh [--sinusoidal] --bound WORK         bound, as docs/integration.md says, to the drive of another bench, which has a flaw: they notice
set -euo pipefail
kind= core=six_step_axi bench=random_traffic words=rtl/config/m2310p_servo.mem page=docs/six_step_registers.md fault_pin=pins_fault_i driven=first_start
if [ "$1" = --sinusoidal ]; then
  kind=_sinusoidal core=sinusoidal_axi bench=random_sinusoidal_traffic words=rtl/config/m2310p_sinusoidal.mem page=docs/sinusoidal_registers.md fault_pin=fault_i driven=turning_sinusoidal
  shift
fi
mode=$1 work=$2
cd "$(dirname "$0")/../.."
tests/empty_folder "$work"
# shellcheck source=tests/rtl/flawed.sh
. tests/rtl/flawed.sh
clocks=200000 file='' said=''
case $mode in
  --both) file=$core flaw='s/assign gates_ul_o = .*/assign gates_ul_o = gates_uh_o;/' said='both gates of a leg are on' ;;
  --dead_time) file=guarded_leg flaw="s/timer <= dead_time_i/timer <= 8'd2/" said='within the dead time' ;;
  --reset) file=guarded_leg flaw="s/if (rst) begin/if (1'b0) begin/" said='a gate is on in the clock after a reset' ;;
  --deaf) file=$core flaw="s/\.$fault_pin($fault_pin)/.$fault_pin(1'b0)/" said='a gate is on 3 clocks after the fault pin' ;;
  --latched) file=$core flaw='s/assign fault_o = .*/assign fault_o = locked_o || gates_uh_o;/' said='a gate is on 4 clocks after the fault was latched|in lock and in fault' ;;
  --unconfigured) file=$core flaw='s/assign gates_vl_o = .*/logic on; always_ff @(posedge clk) on <= !rst; assign gates_vl_o = on;/' said='a gate is on, and CONTROL.configured was not written' ;;
  --taken_away) file=drive_registers$kind flaw='s/assign command_configured_o = .*/logic ever; always_ff @(posedge clk) ever <= !rst \&\& (ever || configured); assign command_configured_o = ever;/' said='after CONTROL.configured was taken away' ;;
  --dropped) file=$core flaw='s/assign axi_bvalid_o = .*/assign axi_bvalid_o = axi_bvalid \&\& !axi_arvalid_i;/' said="a write's answer has changed|a write is taken before the last one is answered" ;;
  --invented | --bound) file=$core flaw='s/assign axi_rvalid_o = \(.*\);/assign axi_rvalid_o = \1 || axi_bvalid_o;/' said='an answer without a read' ;;
  --unlocked) file=config_registers$kind flaw='s/stopped_i && unlocked;/stopped_i;/' said='a keyed register was written behind the closed lock' ;;
  --read_only) file=$core flaw="s/assign axi_bresp_o = .*/assign axi_bresp_o = 2'd0;/" said='(keyed|read-only) register was written' ;;
  --icarus) clocks=40000 ;;
  --map) ;;
  *) clocks=$mode ;;
esac
if [ "$mode" = --map ]; then
  # Of each of the map's 64 words what the page says, holes included, and what the properties say in Icarus.
  sed -n 's/^| \(0x[0-9a-f]*\) | [^|]* | \([^|]*\) | 0x.*/\1 \2/p' $page | while read -r address access; do
    echo "$((address / 4)) $access"
  done | awk '{ known[$1] = 1; keyed[$1] = /keyed/; ro[$1] = $2 == "ro" }
    END { for (k = 0; k < 64; k++) print k, keyed[k] + 0, (k in known) ? ro[k] : "-" }' >"$work/page"
  { echo "module map; localparam logic SINUSOIDAL = $([ -z "$kind" ] && echo 0 || echo 1);"; grep -E '^  localparam logic \[63:0\] k(Keyed|ReadOnly) = ' rtl/bench/drive_properties.sv
    echo 'initial for (int k = 0; k < 64; k++) $display("%0d %0d %0d", k, kKeyed[k], kReadOnly[k]); endmodule'; } >"$work/map.sv"
  iverilog -g2012 -o "$work/map.vvp" "$work/map.sv"
  vvp -n "$work/map.vvp" >"$work/properties"
  # What is no register may be either.
  paste -d' ' "$work/page" "$work/properties" | awk '$2 != $5 || ($3 != "-" && $3 != $6) { print "word " $1 ": page " $2, $3 ", properties " $5, $6; bad = 1 }
    END { if (NR != 64) bad = 1; if (!bad) print "they are those of the map"; exit bad }'
  exit
fi
options=(--out "$work")
if [ -n "$file" ]; then options+=(--with "$(flawed "rtl/$file.sv" "$flaw")"); fi
if [ "$mode" = --bound ]; then
  bench=$driven
  grep "^bind $core " docs/integration.md >"$work/bind.sv"
  options+=(--with rtl/bench/drive_properties.sv --with "$work/bind.sv")
fi
tools/bench "${options[@]}" verilator $bench "+config=$words" "+clocks=$clocks" >"$work/log" 2>&1 || [ $? != 2 ] || { cat "$work/log"; exit 2; }
grep -v -e finish -e Error -e Abort "$work/log"
case $mode in
  --icarus)
    tools/bench "${options[@]}" icarus $bench "+config=$words" "+clocks=$clocks" | grep -v -e WARNING -e finish >"$work/icarus"
    diff <(grep -v finish "$work/log") "$work/icarus" && echo "both say the same" ;;
  --*) grep -q -E "FAILED: [0-9]*: .*($said)" "$work/log" && echo "noticed" ;;
esac
