#!/usr/bin/env bash
# netlist.sh BOARD OUT: the netlist in OUT, from which tools/bitstream made an iCE40 board's bitstream, is the RTL of
# that board.  Yosys proves by induction over two clocks that each flip-flop of both takes the same value, and each output
# is the same, whatever the inputs are and the flip-flops held, if they held the same.  That they wake up the same is not
# part of it: power_on_reset wakes up by its initial values and resets all others.
#   netlist.sh --flaw BOARD OUT      the same of a netlist with one wrong bit in one look-up table, which is read where
#                                    all inputs of the table are 0 but those that are 1 for good
#   netlist.sh --undriven BOARD OUT  the same of a netlist in which nothing drives the gate of U's high side
set -euo pipefail
change=.
case $1 in
  --flaw) shift
    change='.modules[$top].cells |=
      (([to_entries[] | select(.value.type == "SB_LUT4" and (.key | test("guard")))] | last | .key) as $table |
       (.[$table].connections | [.I0, .I1, .I2, .I3] | to_entries |
         map(if .value == ["1"] then pow(2; .key) else 0 end) | 15 - add) as $bit |
       .[$table].parameters.LUT_INIT |= (.[:$bit] + (if .[$bit:$bit + 1] == "1" then "0" else "1" end) + .[$bit + 1:]))' ;;
  --undriven) shift
    change='.modules[$top] |= (.ports.gate_uh.bits = ["x"] | .netnames.gate_uh.bits = ["x"])' ;;
esac
board=$1 out=$2 top=${1}_six_step
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
share=$(dirname "$(command -v yosys)")/../share/yosys

netlist=$work/netlist.json
jq --arg top "$top" "$change" "$out/$top.json" >"$netlist"

# Models of the cells that synthesis maps to; all others are boxes, whose pins become ports on both sides.
{ sed '/^module /,$d' "$share/ice40/cells_sim.v"
  awk '/^module (SB_LUT4|SB_CARRY|SB_DFF[A-Z]*) /{ on = 1 } on { print } /^endmodule/ { on = 0 }' "$share/ice40/cells_sim.v"
} >"$work/cells.v"

# Only the names of flip-flops of the RTL, and of ports, are compared: between them synthesis does as it likes.
cat >"$work/make.ys" <<YS
read_verilog -lib +/ice40/cells_sim.v
read_verilog -sv $(tr '\n' ' ' <rtl/six_step_standalone.f) $out/six_step_fixed.sv constraints/power_on_reset.sv constraints/$board/$top.sv
hierarchy -top $top
proc; flatten; async2sync; dffunmap; opt_clean
rename -hide w:* t:\$dff %co1:+[Q] %d
expose -evert t:SB_*; opt_clean
rename $top gold
design -stash gold

read_json $netlist
delete SB_LUT4 SB_CARRY SB_DFF*
read_verilog $work/cells.v
hierarchy -top $top
proc; flatten; async2sync; dffunmap; check -assert
expose -evert t:SB_*
rename $top gate
design -stash gate

design -copy-from gold -as gold gold
design -copy-from gate -as gate gate
equiv_make gold gate equiv
hierarchy -top equiv
opt_clean
write_rtlil $work/equiv.il
write_json $work/equiv.json
tee -o $work/compared equiv_status
YS
yosys -q "$work/make.ys" >"$work/log" 2>&1 || { tail -n 5 "$work/log"; exit 1; }

# A flip-flop that nothing reads is not in the netlist: its wire has no driver there, and, as `check` has told, no reader.
# An output has one: whoever reads it is outside.  (Pins of boxes are outputs here, too.)
undriven=$(jq -r '.modules.equiv
  | [.cells[] | select(.type == "$equiv" and .connections.B == ["x"]) | .connections.Y[0]] as $dropped
  | .ports | to_entries[] | select(.value.direction == "output" and any(.value.bits[]; IN($dropped[]))) | .key' "$work/equiv.json")
[ -z "$undriven" ] || { echo "nothing drives:" $undriven; exit 1; }
unread=$(sed -n "s/^ *Unproven \$equiv \(.*\): .* 1'x\$/c:\1/p" "$work/compared" | tr '\n' ' ')
# Two clocks: a register that wakes up as 1, as the reset does, is stored as its opposite and has lost its name.  What it
# holds follows from the registers of the clock before.
cat >"$work/prove.ys" <<YS
read_rtlil $work/equiv.il
${unread:+equiv_remove -gold $unread}
equiv_induct -seq 2
tee -o $work/proved equiv_status -assert
YS
if ! yosys -q "$work/prove.ys" >"$work/log" 2>&1; then
  grep '^ *Unproven' "$work/proved" | sed 's/.*: \\/not the same: /' | head -n 5
  tail -n 1 "$work/log"
  exit 1
fi
echo "$board: $(sed -n 's/^ *Of those cells \([0-9]*\) are proven and 0 are unproven.*/\1/p' "$work/proved") bits of registers and outputs are proved the same"
