#!/usr/bin/env bash
# version.sh BUILD VERSION: both programs tell the project's version, and so do CITATION.cff and rtl/steplock.core;
# CHANGELOG.md has a section of it, and who finds the package asks for its minor version.
set -euo pipefail
cd "$(dirname "$0")/../.."
build=$1 version=$2 failed=0
wants() { [ "$1" = "$2" ] || { echo "wanted '$2', found '$1'"; failed=1; }; }
wants "$("$build/bin/hlsgen" --version)" "hlsgen $version"
wants "$("$build/bin/steplock" --version)" "steplock $version"
wants "$(sed -n 's/^version: *//p' CITATION.cff)" "$version"
wants "$(sed -n 's/^name: .*://p' rtl/steplock.core)" "$version"
wants "$(grep -cE "^## \[$version\]" CHANGELOG.md)" 1
# The package is found by its minor version.
for file in docs/integration.md tests/package/consumer/CMakeLists.txt; do
  wants "$(sed -n 's/^find_package(steplock \([0-9.]*\).*/\1/p' $file)" "${version%.*}"
done
exit $failed
