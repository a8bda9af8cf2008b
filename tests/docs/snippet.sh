#!/usr/bin/env bash
# snippet.sh PAGE WORK [SED]: the SystemVerilog on a page instantiates six_step_axi as it is in rtl/ today: Verilator
# lints it against these files and has nothing to say.  SED puts a flaw into the snippet first.
set -euo pipefail
cd "$(dirname "$0")/../.."
page=$1 work=$2 flaw=${3-}
mkdir -p "$work"
snippet=$(awk '/^```systemverilog$/ { on = 1; next } /^```$/ { on = 0 } on' "$page" | sed -e "$flaw")
[ -n "$snippet" ] || { echo "$page: no block of systemverilog"; exit 1; }
# What the snippet's user has: pins and clock by the names of the page, the bus by the names of the module (`.*`).
{
  echo "module readme ("
  sed -n 's/^ *\(\(in\|out\)put  *logic [^/]*axi_[a-z_]*\),\{0,1\}.*/    \1,/p' rtl/six_step_axi.sv
  cat <<'PORTS'
    input  logic       clk,
    input  logic       rst,
    input  logic [2:0] bemf,
    input  logic       over_current,
    input  logic       driver_fault_n,
    output logic [2:0] gate_high,
    output logic [2:0] gate_low,
    output logic       irq,
    output logic       locked,
    output logic       fault
);
PORTS
  printf '%s\nendmodule\n' "$snippet"
} >"$work/readme.sv"
mapfile -t files <rtl/six_step_axi.f
said=$(verilator --lint-only -Wall --top-module readme "${files[@]}" "$work/readme.sv" 2>&1) && [ -z "$said" ] ||
  { echo "$page: the snippet is not what rtl/ has:"; head -n 10 <<<"$said"; exit 1; }
