#!/usr/bin/env bash
# run_page.sh PAGE BUILD OUT: runs the `sh` blocks of a page, in its order, in a folder that looks like a clone; and
# compares what stands between `begin: steplock ...` and `end` with what that command prints.
#   run_page.sh --print PAGE BUILD      writes the printed parts into the page
set -euo pipefail
root=$(cd "$(dirname "$0")/../.." && pwd)
print=false
[ "${1-}" != --print ] || { print=true; shift; }
page=$1 build=$2 out=${3-}
cd "$root"
fresh=$(mktemp)
trap 'rm -f "$fresh"' EXIT
while IFS= read -r line; do
  if [[ $line =~ ^'<!-- begin: '(steplock .*)' -->'$ ]]; then
    printf '%s\n' "$line"
    # shellcheck disable=SC2086  # a command and its words
    "$build/bin/"${BASH_REMATCH[1]}
    inside=true
  elif [[ $line == '<!-- end -->' ]]; then
    inside=false
    printf '%s\n' "$line"
  elif [[ ${inside-false} == false ]]; then
    printf '%s\n' "$line"
  fi
done <"$page" >"$fresh"
if $print; then cp "$fresh" "$page"; exit 0; fi
diff "$page" "$fresh" || { echo "run_page: $page is stale: tests/docs/run_page.sh --print $page $build"; exit 1; }

tests/empty_folder "$out"
for entry in "$root"/*; do
  case $(basename "$entry") in build | out) ;; *) ln -s "$entry" "$out/" ;; esac
done
ln -s "$build" "$out/build"
awk '/^```sh$/ { on = 1; next } /^```$/ { on = 0 } on' "$page" >"$out/commands"
[ -s "$out/commands" ] || { echo "run_page: $page has no commands"; exit 1; }
cd "$out"
# Configured and built it is already, by whoever runs the tests; a build within a build would wait for it.
sed -i '/^cmake -S \. -B build/d; /^cmake --build build/d' commands
# As a reader's shell would run them, so that a here-document may span lines; each is printed before it runs.
bash -euo pipefail -v commands || { echo "run_page: $page: failed: the last command above"; exit 1; }
