#!/usr/bin/env bash
# How hlsgen's time grows with a block: an array of eight times as many registers takes at most BOUND times as long.
#   growth.sh HLSGEN ROOT WORK BOUND
# CPU time, the least of three, side by side.  What grows with the square would take 64 times as long.
set -euo pipefail
hlsgen=$1 root=$2 work=$3 bound=$4
mkdir -p "$work"
block() {  # SIZE
  cat >"$work/array_$1.cpp" <<CPP
#include <array>

#include "hls/numeric/bits.hpp"
#include "hls/numeric/block.hpp"
namespace steplock {
class Array {
 public:
  struct In { UInt<10> at = 0; UInt<8> x = 0; bool write = false; };
  struct Out { UInt<8> y = 0; };
  Out tick(const In& in) {
    if (in.write) kept_[in.at.raw() % $1] = in.x;
    return {.y = kept_[in.at.raw() % $1]};
  }
 private:
  std::array<UInt<8>, $1> kept_ = {};
};
template struct Synthesize<Array>;
}  // namespace steplock
CPP
}
seconds() {  # SIZE: CPU seconds
  local TIMEFORMAT='%U'
  { time "$hlsgen" "$work/array_$1.cpp" -I "$root" -o "$work/rtl_$1" >"$work/log" 2>&1; } 2>&1 || { cat "$work/log" >&2; return 1; }
}
sizes=(128 1024)
for size in "${sizes[@]}"; do block "$size"; done
for _ in 1 2 3; do for size in "${sizes[@]}"; do echo "$size $(seconds "$size")"; done; done |
  awk -v bound="$bound" '
    !($1 in least) || $2 < least[$1] { least[$1] = $2 }
    END {
      ratio = least[1024] / least[128]
      printf "1024 registers took %.2f s, 128 took %.2f s: %.1f times as long, at most %g\n", least[1024], least[128], ratio, bound
      exit ratio > bound
    }'
