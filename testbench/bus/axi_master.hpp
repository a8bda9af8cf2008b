// AXI4-Lite master for tests and co-simulation: one transfer after the other, any top behind it.
//
// `Clock` gives the top one clock: AxiAnswers operator()(const AxiLite::In&).  It shows valid
// until ready, as the protocol asks, and gives up (Response::stuck) after kPatience clocks.
//
// Test: tests/hls/six_step_axi_test.cpp
#pragma once

#include <cstdint>

#include "hls/bus/axi_lite.hpp"

namespace steplock {

template <class Clock>
class AxiMaster {
 public:
  struct Response {
    bool okay = false;
    bool stuck = false;
    std::uint32_t data = 0;
  };

  explicit AxiMaster(Clock clock) : clock_(clock) {}

  Response write(std::uint32_t address, std::uint32_t data, int strobes = 15) {
    AxiLite::In pins{.awvalid = true, .awaddr = UInt<12>::of(address), .wvalid = true,
                     .wdata = data, .wstrb = strobes, .bready = true};
    for (int i = 0; i < kPatience; ++i) {
      const AxiAnswers axi = clock_(pins);
      if (axi.awready) pins.awvalid = false;
      if (axi.wready) pins.wvalid = false;
      if (axi.bvalid) return {.okay = axi.bresp == UInt<2>(0)};
    }
    return {.stuck = true};
  }
  Response read(std::uint32_t address) {
    AxiLite::In pins{.arvalid = true, .araddr = UInt<12>::of(address), .rready = true};
    for (int i = 0; i < kPatience; ++i) {
      const AxiAnswers axi = clock_(pins);
      if (axi.arready) pins.arvalid = false;
      if (axi.rvalid) {
        return {.okay = axi.rresp == UInt<2>(0), .data = std::uint32_t(axi.rdata.raw())};
      }
    }
    return {.stuck = true};
  }

 private:
  static constexpr int kPatience = 100;  // clocks

  Clock clock_;
};

}  // namespace steplock
