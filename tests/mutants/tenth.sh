#!/usr/bin/env bash
# tenth.sh ROOT BUILD: a tenth of the mutants, drawn by what blocks and plant are now.
set -euo pipefail
cd "$1"
STEPLOCK_BUILD=$2 STEPLOCK_MUTANTS=$2/mutants tools/mutants --tenth "$(cat hls/*/*.hpp model/plant/*.cpp | sha256sum | cut -c 1-16)"
