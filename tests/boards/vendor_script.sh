#!/usr/bin/env bash
# vendor_script.sh SCRIPT TOP LIST OUT: evaluates a vendor's script with stand-ins for the vendor's commands.
# Every file it names is there, every module of LIST (rtl/*.f) is among them, and every port of a constraint is
# one of TOP's.  What the tools make of it only the tools can tell.
set -euo pipefail
script=$1 top=$2 list=$3 out=$4
"$(dirname "$0")/../empty_folder" "$out"
touch "$out/six_step_fixed.sv"  # tools/bitstream leaves it there
sed -n 's/^ *\(in\|out\)put *\(logic\)\? *\(\[[0-9:]*\]\)\? *\([a-z0-9_]*\).*/\4/p' "$top" >"$out/ports"
cat >"$out/stand_ins.tcl" <<'TCL'
# argv: SCRIPT OUT; writes what was called to OUT/called.
lassign $argv script out
set argv [list $out]
set env(STEPLOCK_OUT) $out
set known [split [string trim [read [open $out/ports]]] "\n"]
set called [open $out/called w]
proc package {args} {}
proc unknown {name args} {
  if {[string is integer $name]} { return "\[$name\]" }  ;# speed[0] unquoted, as Quartus has it
  puts $::called "$name $args"
  if {$name eq "get_ports"} {
    foreach port [lindex $args end] {
      if {[regsub {\[.*\]$} $port {}] ni $::known} { error "no port $port in the top" }
    }
  }
  if {$name eq "set_location_assignment" && [regsub {\[.*\]$} [lindex $args end] {}] ni $::known} {
    error "no port [lindex $args end] in the top"
  }
  foreach word [concat {*}$args] {
    if {[regexp {^/.*\.(sv|v|xdc|qsf|sdc|lpf)$} $word] && ![file exists $word]} { error "no file $word" }
    if {[regexp {^/.*\.(xdc|sdc)$} $word]} { uplevel #0 [list source $word] }
  }
  return "$name $args"
}
source $script
close $called
TCL
tclsh "$out/stand_ins.tcl" "$script" "$out"
while read -r file; do
  grep -q "/$file\b" "$out/called" || { echo "vendor_script: $script does not read $file"; exit 1; }
done <"$list"
grep -q "$(basename "$top")" "$out/called" || { echo "vendor_script: $script does not read $top"; exit 1; }
