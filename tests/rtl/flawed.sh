# shellcheck shell=bash disable=SC2154
# What the scripts of the benches share; sourced, in the root of the project, with `work` set.

# same KEY FILE BENCH: the value of the drive file's key is that of the bench
same() {
  awk -v a="$2" -v b="$3" 'BEGIN { exit a == "" || b == "" || a + 0 != b + 0 }' || { echo "$1: $2 in the drive file, $3 in the bench"; exit 1; }
}

# flawed FILE EXPRESSION: a copy of it with that flaw
flawed() {
  sed "$2" "$1" >"$work/$(basename "$1")"
  cmp -s "$1" "$work/$(basename "$1")" && { echo "${0##*/}: the flaw found no place" >&2; exit 2; }
  echo "$work/$(basename "$1")"
}
