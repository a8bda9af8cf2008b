#!/usr/bin/env bash
# board_flaws.sh FLAW OUT: tools/bitstream must refuse the iCEBreaker with that flaw, and say why.
set -euo pipefail
flaw=$1 out=$2
"$(dirname "$0")/../empty_folder" "$out"
cp -r constraints/icebreaker "$out/icebreaker"
pcf=$out/icebreaker/icebreaker.pcf top=$out/icebreaker/icebreaker_six_step.sv
drive=drives/amano2003.toml lint=--lint says="disagree about the pins"
case $flaw in
  pin_without_port) echo "set_io gate_xh 21" >>"$pcf" ;;
  port_without_pin) sed -i '/^set_io gate_uh/d' "$pcf" ;;
  pin_of_two_ports) sed -i 's/^set_io gate_vh .*/set_io gate_vh 4/' "$pcf"; says="gives a pin to two ports: 4" ;;
  tie_of_another_width) sed -i "s/{button_fast, 1'b1}/button_fast/" "$top"; says="WIDTH" ;;
  clock_too_fast)  # by a quarter, for what docs/timing.md shows on UP5K; a drive whose gain its word holds at that clock, too
    drive=drives/m2310p_servo.toml
    hz=$(awk -F'|' '$2 == " six_step_fixed " { printf "%d", 1.25e6 * $4 }' docs/timing.md)
    sed -i "s/^# clock_hz: .*/# clock_hz: ${hz:?docs\/timing.md has no such row}/" "$pcf"; lint="" says="Max frequency" ;;
esac
# shellcheck disable=SC2086  # no word when there is none
if tools/bitstream $lint "$out/icebreaker" "$drive" "$out/made" >"$out/said" 2>&1; then
  echo "board with $flaw: accepted"
  exit 1
fi
grep -q "$says" "$out/said" || { cat "$out/said"; echo "board with $flaw: refused for another reason"; exit 1; }
[ ! -e "$out/made/icebreaker_six_step.bin" ] || { echo "board with $flaw: left a bitstream"; exit 1; }
