#!/usr/bin/env bash
# unproved.sh PROVE MODULE SED_EXPRESSION ASSERTS: with that change in rtl/MODULE.sv its proof must fail, by an assertion.
set -euo pipefail
prove=$1 module=$2 expression=$3 asserts=$4
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
sed "$expression" "rtl/$module.sv" >"$work/$module.sv"
! cmp -s "$work/$module.sv" "rtl/$module.sv" || { echo "the expression changes nothing: $expression"; exit 1; }
if "$prove" "tests/proofs/$module.sv" 1 "$asserts" 0 "$work/$module.sv" >"$work/log" 2>&1; then
  echo "proved all the same"; exit 1
fi
grep "Assert failed\|does not close\|not hold" "$work/log" || { cat "$work/log"; exit 1; }
