#!/usr/bin/env bash
# Of the wires and registers that generated modules declare, how many have a name that says nothing: only an operator
# and a number, as `choice_149_4`; and how many end in an operator, as `duty_next_sum_2`.  Fails above 5 in 100 of either,
# and where hardly anything is declared.
#   generic_names.sh FILE.sv...
# A name counts as generic even where the C++ chose it (`sum`), so the count errs on the strict side.
# Test: tests/rtl/CMakeLists.txt, which also gives it a module whose names were taken away
set -euo pipefail
awk '
  /^ *(wire|logic) / {
    name = $0
    sub(/^ *(wire|logic) +(signed +)?(\[[^]]*\] +)?/, "", name)
    sub(/[^A-Za-z0-9_].*/, "", name)
    ++declared
    operator = "(sum|difference|product|both|either|differ|inverse|shifted|equal|unequal|below|at_most|choice|part|joined|wide|entry|value)(_[0-9]+)*$"
    if (name ~ "^" operator) ++generic
    if (name ~ "(^|_)" operator) {
      ++ending
      ++of[FILENAME]
    }
  }
  END {
    for (file in of) printf "%4d %s\n", of[file], file | "sort -rn"
    close("sort -rn")
    printf "%d of %d declared names are generic: %.1f %%, at most 5 %%\n", generic, declared, 100 * generic / declared
    printf "%d end in an operator: %.1f %%, at most 5 %%\n", ending, 100 * ending / declared
    exit declared < 50 || 100 * generic > 5 * declared || 100 * ending > 5 * declared
  }' "$@"
