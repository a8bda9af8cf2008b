// APB4 slave: a transfer to one request, and nothing of the registers behind.
//
//     setup    psel alone: nothing happens
//     access   psel and penable: the request in its first clock, pready in its second
//
// The registers are asked in the access phase, not during setup, so that a psel that comes without
// penable leaves no trace.
//
//     latency      one wait state: a transfer takes 3 clocks with its setup
//     registers    1 bit     multipliers  none
//
// Doc: docs/blocks/apb.md   Test: tests/hls/apb_test.cpp   Proof: tests/proofs/apb.sv

#pragma once

#include "hls/bus/bus.hpp"

namespace steplock {

class Apb {
 public:
  struct In {
    bool psel = false;
    bool penable = false;
    bool pwrite = false;
    UInt<12> paddr = 0;  // bytes; the lowest two bits do not count
    UInt<32> pwdata = 0;
    UInt<4> pstrb = 0;
  };

  struct Out {
    bool pready = false;  // low outside of a transfer
    BusRequest request;   // answered in the next clock
  };

  Out tick(const In& in) {
    const bool active = in.psel && in.penable;
    const bool asks = active && !asked_;
    const Out out{.pready = active && asked_,
                  .request = {.write = asks && in.pwrite,
                              .read = asks && !in.pwrite,
                              .index = in.paddr.slice<11, 2>(),
                              .data = in.pwdata,
                              .strobes = in.pstrb}};
    asked_ = asks;
    return out;
  }

  bool operator==(const Apb&) const = default;

 private:
  bool asked_ = false;  // in the clock before: this one has the answer
};

// What a top shows of the bus: an answer of the registers, with pslverr if they refused.
struct ApbAnswers {
  bool pready = false;
  bool pslverr = false;
  UInt<32> prdata = 0;
};
template <class Csr>
ApbAnswers apb_answers(const Apb::Out& bus, bool pwrite, const Csr& drive) {
  const bool error = pwrite ? drive.write_error : drive.read_error;
  return {.pready = bus.pready, .pslverr = bus.pready && error, .prdata = drive.data};
}

}  // namespace steplock
