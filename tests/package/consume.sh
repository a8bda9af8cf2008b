#!/usr/bin/env bash
# consume.sh CMAKE BUILD DRIVE OUT: installs the package, and builds and runs a project that finds it.
set -euo pipefail
cmake=$1 build=$2 drive=$3 out=$4
here=$(cd "$(dirname "$0")" && pwd)
"$(dirname "$0")/../empty_folder" "$out"
quietly() { "$@" >"$out/log" 2>&1 || { tail -n 20 "$out/log"; echo "consume: failed: $*"; exit 1; }; }
quietly "$cmake" --install "$build" --component model --prefix "$out/installed"
cp -r "$here/consumer" "$out/consumer"  # nothing of this tree may be found by a relative path
quietly "$cmake" -S "$out/consumer" -B "$out/build" -D CMAKE_PREFIX_PATH="$out/installed" -D CMAKE_BUILD_TYPE=Release
quietly "$cmake" --build "$out/build"
"$out/build/turn" "$drive"
