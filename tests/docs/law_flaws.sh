#!/usr/bin/env bash
# law_flaws.sh ROOT OUT: tools/laws --check must find a law that was changed in the header alone, or on the page alone.
set -euo pipefail
root=$1 out=$2
for flaw in 's/x += ki p/x += kp p/ hls/six_step/loop_filter_law.hpp' 's/lags ? 4 : 1/lags ? 3 : 1/ docs/blocks/protection.md' \
            '/^<!-- end of law -->$/d docs/blocks/speed_control.md' 's/forth = peak/back = peak/ docs/sinusoidal.md'; do
  "$root/tests/empty_folder" "$out"
  mkdir -p "$out/hls" "$out/docs" "$out/tools"
  cp -r "$root/hls/six_step" "$root/hls/sinusoidal" "$out/hls/"
  cp -r "$root/docs/blocks" "$root/docs/theory.md" "$root/docs/sinusoidal.md" "$out/docs/"
  cp "$root/tools/laws" "$out/tools/"
  "$out/tools/laws" --check || { echo "law_flaws: refused without a flaw"; exit 1; }
  file=${flaw##* }
  cp "$out/$file" "$out/before"
  sed -i "${flaw% *}" "$out/$file"
  ! cmp -s "$out/$file" "$out/before" || { echo "law_flaws: '$flaw' changes nothing"; exit 1; }
  ! "$out/tools/laws" --check 2>"$out/said" || { echo "law_flaws: '$flaw' was not found"; exit 1; }
  page=docs/blocks/$(basename "$file" _law.hpp).md
  case "$file" in docs/*) page=$file ;; esac
  grep -q "$page" "$out/said" || { cat "$out/said"; echo "law_flaws: the page is not named"; exit 1; }
done
