#!/usr/bin/env bash
# decades_page.sh STEPLOCK ROOT WORK [FLAW]: the first motors of docs/decades.md again, with its seed: they do what the page says.
# The page's totals are those of its table by speed. With a flaw, another row, seed or total as if typed, that is noticed.
set -euo pipefail
shopt -s inherit_errexit
steplock=$1 root=$2 work=$3 flaw=${4:-none}
"$(dirname "$0")/../empty_folder" "$work"
page=$work/page.md
case $flaw in
  none) cp "$root/docs/decades.md" "$page" ;;
  row) sed '/^| decades_0003 /s/[0-9] | yes/7 | yes/; /^| decades_0003 /s/\.\([0-9]*\)[0-68-9] | yes/.\17 | yes/' "$root/docs/decades.md" >"$page" ;;
  total) sed 's/^| \([0-9]*\) | [0-9.]* % |/| \1 | 99.99 % |/' "$root/docs/decades.md" >"$page" ;;
  seed) sed 's/--seed \([0-9]*\)/--seed 1\1/' "$root/docs/decades.md" >"$page" ;;
esac
[ "$flaw" = none ] || ! cmp -s "$page" "$root/docs/decades.md"
first() { sed -n '/^## The first ones/,$p' "$1"; }
totals() { awk -F' *[|] *' '/^\| [0-9.e+]+ to /{ n += $3; held += $4 } END { printf "%d %.2f %%\n", n, 100 * held / n }' "$1"; }
seed=$(sed -n 's/.*--seed \([0-9]*\)`.*/\1/p' "$page" | head -n 1)
# What needs no run first: the seed is the one that the published starts follow, the totals are those of the table by speed.
told() {
  [ "$seed" = "$(jq .seed "$root/docs/starts.json")" ] || { echo "the seed is not that of docs/starts.md"; return; }
  diff <(totals "$page") <(sed -n 's/^| \([0-9]*\) | \([0-9.]* %\) |.*/\1 \2/p' "$page") || return 0
  local rows
  rows=$(first "$page" | grep -c '^| decades_')
  "$steplock" motors --decades --count "$rows" --seed "$seed" --out "$work/motors" >/dev/null
  "$steplock" hold "$work"/motors/*.toml --jobs 1 --page "$work/again.md" --printed-by again --seed "$seed" >/dev/null || [ $? = 1 ]
  diff <(first "$page") <(first "$work/again.md") || true
}
differs=$(told)
if [ -n "$differs" ]; then
  printf '%s\n' "$differs" "docs/decades.md is stale; print it again with the command in its first line" >&2
  [ "$flaw" != none ]
else
  [ "$flaw" = none ]
fi
