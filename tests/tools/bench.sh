#!/usr/bin/env bash
# tools/bench: what it refuses, and what it would have simulators do that are not here.
#   bench.sh refusals           each wrong call is one line, exit code 2, and nothing is made
#   bench.sh commands WORK      for each simulator and bench every file that is named is there, a file of one's own stands once in place of the
#                               bench's, and stand-ins for Vivado's and Questa's programs are called with them, word for word
#   bench.sh elsewhere WORK     from another directory, with files named from there
set -euo pipefail
mode=$1 work=${2:-}
root=$(cd "$(dirname "$0")/../.." && pwd)
cd "$root"
# As it lists them itself.
benches=$(tools/bench icarus none 2>&1 | sed 's/.* it is one of //; s/,//g') || true
[ "$(wc -w <<<"$benches")" -gt 5 ] || { echo "tools/bench lists no benches: $benches"; exit 1; }

refuses() {  # refuses PART CALL...
  local part=$1 said status=0
  shift
  said=$(tools/bench "$@" 2>&1) || status=$?
  [ $status = 2 ] && [ "$(echo "$said" | wc -l)" = 1 ] && [[ $said == *"$part"* ]] || { echo "tools/bench $*: exit $status, said: $said"; exit 1; }
}
case $mode in
  refusals)
    refuses "there is no bench 'turn'" icarus turn
    refuses "there is no simulator 'modelsim'" modelsim first_start
    refuses "there is no configuration none.mem" icarus first_start +config=none.mem
    refuses "'long' is no argument of a bench" icarus turning_motor long
    refuses 'there is no file motor.v' --with motor.v icarus turning_motor
    refuses 'xvlog is not here; it comes with Vivado' --out /nonexistent/x xsim first_start
    refuses 'vlog is not here; it comes with questa' --out /nonexistent/x questa first_start
    said=$(tools/bench --nonsense 2>&1) && exit 1
    [[ $said == *SIMULATOR*BENCH* ]] || { echo "no usage: $said"; exit 1; }
    echo 'each is refused' ;;
  commands)
    tests/empty_folder "$work"
    mkdir -p "$work/bin"
    cp rtl/bench/motor.sv "$work/motor.sv"
    for program in xvlog xelab xsim vlib vlog vsim; do
      printf '#!/bin/sh\nfor word; do echo "%s $word" >>"$CALLED"; done\n' $program >"$work/bin/$program"
      chmod +x "$work/bin/$program"
    done
    for simulator in verilator icarus xsim questa; do
      for bench in $benches; do
        said=$(tools/bench --print --with "$work/motor.sv" --define LATEST=7 $simulator "$bench" +long)
        files=$(echo "$said" | tr ' ' '\n' | grep -E '\.(sv|mem)$' | sed 's/.*config=//')
        echo "$files" | while read -r file; do [ -f "$file" ] || { echo "$simulator $bench names $file, which is not there"; exit 1; }; done
        [ "$(echo "$files" | grep -c 'motor\.sv$')" = $((1 + $(echo "$files" | grep -c 'turning_motor\.sv$'))) ] || { echo "$simulator $bench: motor.sv does not stand once"; exit 1; }
        [[ $said == *LATEST=7* && $said == *long* ]] || { echo "$simulator $bench: parameter or argument is lost: $said"; exit 1; }
      done
    done
    for simulator in xsim questa; do
      export CALLED=$work/$simulator.log
      PATH=$work/bin:$PATH tools/bench --out "$work/$simulator" --define LATEST=7 $simulator turning_motor +long
    done
    # A word is what the program sees as one: no option has its value stuck to it, no command is torn apart.
    for word in 'xelab --generic_top' 'xelab LATEST=7' 'xelab work.turning_motor' "xvlog $root/rtl/bench" 'xsim --testplusarg' 'xsim long' "xsim config=$root/rtl/config/maxon_ec45_flat.mem" "xvlog $root/rtl/six_step_axi.sv"; do
      grep -q -x -F -e "$word" "$work/xsim.log" || { echo "xsim: no '$word'"; exit 1; }
    done
    for word in 'vlog -timescale' 'vlog +incdir+rtl/bench' 'vlog rtl/six_step_axi.sv' 'vsim -gLATEST=7' 'vsim +long' 'vsim run -all; quit -f'; do
      grep -q -x -F -e "$word" "$work/questa.log" || { echo "questa: no '$word'"; exit 1; }
    done
    echo 'each names what is there' ;;
  elsewhere)
    tests/empty_folder "$work"
    cp rtl/config/amano2003.mem "$work/mine.mem"
    sed 's/PASSED/PASSED with my own/' rtl/bench/first_start.sv >"$work/first_start.sv"
    cmp -s rtl/bench/first_start.sv "$work/first_start.sv" && exit 1
    cd "$work"
    "$root/tools/bench" --out made --with first_start.sv icarus first_start +config=mine.mem
    [ -f made/first_start.vvp ] || { echo 'it was not made here'; exit 1; } ;;
esac
