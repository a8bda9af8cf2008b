#!/usr/bin/env bash
# walk_flaws.sh WORK: walk_links.sh refuses a page that nothing links to, a link to no file and one to no heading, and
# has nothing else to say.
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
root=$(cd "$here/../.." && pwd)
work=$1
"$(dirname "$0")/../empty_folder" "$work"
for entry in "$root"/*; do
  case $(basename "$entry") in build | out | docs) ;; *) ln -s "$entry" "$work/" ;; esac
done
cp -r "$root/docs" "$work/docs"
last=$(wc -l <"$work/docs/index.md")
printf '%s\n' "[x](no_such.md)" "[x](theory.md#no-such-heading)" >>"$work/docs/index.md"
echo "# Alone" >"$work/docs/blocks/alone.md"
wanted="docs/index.md:$((last + 1)): dead link 'no_such.md'; no file docs/no_such.md
docs/index.md:$((last + 2)): dead link 'theory.md#no-such-heading'; docs/theory.md has no such heading
docs/blocks/alone.md: not reached from docs/index.md; link to it"
if said=$("$here/walk_links.sh" "$work" 2>&1); then echo "nothing was noticed"; exit 1; fi
[ "$said" = "$wanted" ] || { printf 'wanted:\n%s\nbut it said:\n%s\n' "$wanted" "$said"; exit 1; }
