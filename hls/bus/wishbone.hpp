// Wishbone B4 slave: a cycle to one request, and nothing of the registers behind.
//
//     standard cycle    the request in the first clock of cyc and stb, ack in the second
//     pipelined cycle   the same, with stall high in the first: connect it; standard hosts leave it open
//
// A host holds cyc and stb, with address, data and we, until the answer.  Block transfers are single
// cycles one after the other.  After an answer the slave rests for a clock: what a write does to the drive
// is then seen by the next read, as on the other buses.
//
//     latency      ack in the clock after the request; one transfer per 3 clocks
//     registers    2 bits     multipliers  none
//
// Doc: docs/blocks/wishbone.md   Test: tests/hls/wishbone_test.cpp
// Proof: tests/proofs/wishbone.sv

#pragma once

#include "hls/bus/bus.hpp"

namespace steplock {

class Wishbone {
 public:
  struct In {
    bool cyc = false;
    bool stb = false;
    bool we = false;
    UInt<12> adr = 0;  // bytes; the lowest two bits do not count
    UInt<32> dat = 0;
    UInt<4> sel = 0;
  };

  struct Out {
    bool ack = false;  // the answer is there; the top makes err of it if the registers refused
    bool stall = false;
    BusRequest request;  // answered in the next clock
  };

  Out tick(const In& in) {
    const bool active = in.cyc && in.stb;
    const bool asks = active && !asked_ && !rests_;
    const Out out{.ack = active && asked_,
                  .stall = in.cyc && !asked_,
                  .request = {.write = asks && in.we,
                              .read = asks && !in.we,
                              .index = in.adr.slice<11, 2>(),
                              .data = in.dat,
                              .strobes = in.sel}};
    asked_ = asks;
    rests_ = out.ack;
    return out;
  }

  bool operator==(const Wishbone&) const = default;

 private:
  bool asked_ = false;  // in the clock before: this one has the answer
  bool rests_ = false;  // after an answer
};

// What a top shows of the bus: an answer of the registers is an ack, or an err.
struct WishboneAnswers {
  bool ack = false;
  bool err = false;
  bool stall = false;  // for pipelined hosts
  UInt<32> dat = 0;
};
template <class Csr>
WishboneAnswers wishbone_answers(const Wishbone::Out& bus, bool we, const Csr& drive) {
  const bool error = we ? drive.write_error : drive.read_error;
  return {.ack = bus.ack && !error, .err = bus.ack && error, .stall = bus.stall, .dat = drive.data};
}

}  // namespace steplock
