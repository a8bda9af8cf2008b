# shellcheck shell=bash
# What the words of a drive leave of the six-step core when they are constants, before Yosys maps it to a device.
# tools/bitstream and tools/timing source it.

# constants ROOT TOP: Yosys' commands for it, between read_verilog and synth_*
#   A comparison with a constant is a few look-up tables, and would be a carry chain of its own.
#   A counter has as many bits as its words, and would have as many as the longest word.  opt_dff proves of a
#   flip-flop that it never leaves the value that it is reset to; of a counter that is the uppermost bit, and in the next
#   round the one below.  Only those counters are asked that no more than a word fills: to ask all takes half a minute.
constants() {
  local round="opt_dff -sat -nodffe w:*.guard.*.timer w:*.pwm.* %u %ci1:+[Q]; opt_expr; opt_clean;" rounds="" i
  for ((i = 0; i < 14; i++)); do rounds+=" $round"; done
  echo "hierarchy -top $2; proc; flatten; opt_expr; opt_clean;" \
    "techmap -map $1/constraints/compare_with_constant.v; opt_expr; opt_clean;$rounds"
}
