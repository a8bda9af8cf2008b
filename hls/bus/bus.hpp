// What a bus slave asks of the registers, whatever the bus.
//
// At most one of `write` and `read` is up in a clock.  The registers answer in the next one and
// keep the answer until the next request of the same kind, so that a slave may show it for long.
//
// Doc: docs/six_step_registers.md

#pragma once

#include "hls/numeric/bits.hpp"

namespace steplock {

using WordIndex = UInt<10>;  // word address within 4 KiB

struct BusRequest {
  bool write = false;
  bool read = false;
  WordIndex index = 0;
  UInt<32> data = 0;
  UInt<4> strobes = 0;  // bytes of `data` that count
  bool operator==(const BusRequest&) const = default;
};

// The bits that the strobes let through.
constexpr UInt<32> byte_mask(UInt<4> strobes) {
  return UInt<32>::of((strobes.bit(0) ? 0x000000ffU : 0U) | (strobes.bit(1) ? 0x0000ff00U : 0U) |
                      (strobes.bit(2) ? 0x00ff0000U : 0U) | (strobes.bit(3) ? 0xff000000U : 0U));
}

}  // namespace steplock
