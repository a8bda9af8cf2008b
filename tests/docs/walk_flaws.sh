#!/usr/bin/env bash
# walk_flaws.sh WORK: walk_links.sh refuses a page that nothing links to, a link to no file and one to no heading, and
# has nothing else to say.
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
root=$(cd "$here/../.." && pwd)
work=$1
refused() {  # WHAT: of the copy with its flaw
  local said
  if said=$("$here/walk_links.sh" "$work" 2>&1); then echo "not noticed: $1"; exit 1; fi
  [ "$said" = "$1" ] || { echo "wanted '$1', but it said: $said"; exit 1; }
}
copy() {
  rm -rf "$work"
  mkdir -p "$work"
  for entry in "$root"/*; do
    case $(basename "$entry") in build | out | docs) ;; *) ln -s "$entry" "$work/" ;; esac
  done
  cp -r "$root/docs" "$work/docs"
}
copy
"$here/walk_links.sh" "$work"
last=$(wc -l <"$work/docs/index.md")
echo "[x](no_such.md)" >>"$work/docs/index.md"
refused "docs/index.md:$((last + 1)): dead link 'no_such.md'; no file docs/no_such.md"
copy
echo "[x](theory.md#no-such-heading)" >>"$work/docs/index.md"
refused "docs/index.md:$((last + 1)): dead link 'theory.md#no-such-heading'; docs/theory.md has no such heading"
copy
echo "# Alone" >"$work/docs/blocks/alone.md"
refused "docs/blocks/alone.md: not reached from docs/index.md; link to it"
