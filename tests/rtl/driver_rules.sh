#!/usr/bin/env bash
# The C driver under the MISRA C:2012 rules that cppcheck's addon knows, but for those that driver_rules.txt leaves, with the reason.
#   driver_rules.sh none WORK
#   driver_rules.sh brace | sign | truth | idle WORK      with a flaw, or with a rule left that nothing breaks: it has to be noticed
set -euo pipefail
work=$2
cd "$(dirname "$0")/../.."
mkdir -p "$work"
cp rtl/host/*.[ch] "$work"
left=$(sed -n 's/^\([0-9][0-9.]*\) .*/\1/p' tests/rtl/driver_rules.txt)
flaw() { sed -i "$1" "$work/steplock.c"; cmp -s rtl/host/steplock.c "$work/steplock.c" && { echo "driver_rules.sh: the flaw found no place"; exit 2; }; true; }
case $1 in
  none) ;;
  brace) flaw 's|{ \(result = get(bus, words\[i\].offset, &kept);\) }|\1|' ;;
  sign) flaw 's|offset / 4u|offset / 4|' ;;
  truth) flaw 's/if (clear != 0u)/if (clear)/' ;;
  idle) left="$left 17.7" ;;
esac
for file in "$work"/*.c; do
  cppcheck --std=c99 --suppress=missingIncludeSystem --addon=misra -q --template='{file}:{line}: {id}' "$file" 2>&1
done | grep misra >"$work/said" || true
[ -s "$work/said" ] || { echo "cppcheck's addon said nothing at all, not even of the rules that are left"; exit 1; }
status=0
for rule in $(sed 's/.*misra-c2012-//' "$work/said" | sort -uV); do
  grep -q -x -F -e "$rule" <<<"$(tr ' ' '\n' <<<"$left")" && continue
  grep "misra-c2012-$rule\$" "$work/said" | head -n 3 | sed "s,$work,rtl/host,; s/misra-c2012-/breaks rule /"
  status=1
done
for rule in $left; do
  grep -q "misra-c2012-$rule\$" "$work/said" || { echo "driver_rules.txt leaves rule $rule, which nothing breaks"; status=1; }
done
[ $status = 0 ] && echo "$(wc -w <<<"$left") rules are left, no other is broken"
exit $status
