// AXI4-Lite slave: two handshakes to one request per clock, and nothing of the registers behind.
//
//     write   awready = wready = 1 in the clock after both were valid; then bvalid until bready
//     read    arready = 1 in the clock after arvalid; then rvalid until rready
//
// Address and data of a write may come in any order: neither is taken before both are there (a host
// may not wait for the one before it shows the other, AXI A3.3.1).  A response that waits for its
// host holds up its own channel only.  When both want the registers they take turns.  Every output
// is a register, but for the request, which is of the same clock.
//
//     latency      write 2 clocks from valid to bvalid, read the same; one of each per 3 clocks
//     registers    5 bits     multipliers  none
//
// Doc: docs/blocks/axi_lite.md   Test: tests/hls/axi_lite_test.cpp
// Proof: tests/proofs/axi_lite.sv

#pragma once

#include "hls/bus/bus.hpp"

namespace steplock {

class AxiLite {
 public:
  struct In {
    bool awvalid = false;
    UInt<12> awaddr = 0;  // bytes; the lowest two bits do not count
    bool wvalid = false;
    UInt<32> wdata = 0;
    UInt<4> wstrb = 0;
    bool bready = false;
    bool arvalid = false;
    UInt<12> araddr = 0;  // bytes
    bool rready = false;
  };

  struct Out {
    bool awready = false;
    bool wready = false;
    bool bvalid = false;
    bool arready = false;
    bool rvalid = false;
    BusRequest request;  // answered in the next clock
  };

  Out tick(const In& in) {
    const bool write = write_ready_ && in.awvalid && in.wvalid;
    const bool read = read_ready_ && in.arvalid;
    const Out out{.awready = write_ready_,
                  .wready = write_ready_,
                  .bvalid = write_done_,
                  .arready = read_ready_,
                  .rvalid = read_done_,
                  .request = {.write = write,
                              .read = read,
                              .index = (write_ready_ ? in.awaddr : in.araddr).slice<11, 2>(),
                              .data = in.wdata,
                              .strobes = in.wstrb}};

    const bool wants_write = in.awvalid && in.wvalid && !write_ready_ && !write_done_;
    const bool wants_read = in.arvalid && !read_ready_ && !read_done_;
    write_done_ = write || (write_done_ && !in.bready);
    read_done_ = read || (read_done_ && !in.rready);
    write_ready_ = wants_write && !(wants_read && wrote_);
    read_ready_ = wants_read && !(wants_write && !wrote_);
    if (write_ready_ || read_ready_) wrote_ = write_ready_;
    return out;
  }

  bool operator==(const AxiLite&) const = default;

 private:
  bool write_ready_ = false;  // takes a write in this clock
  bool read_ready_ = false;   // never both
  bool write_done_ = false;   // its response waits
  bool read_done_ = false;
  bool wrote_ = false;        // the last one taken was a write
};

// What a top shows of the bus: the slave's handshakes with its registers' answers.
struct AxiAnswers {
  bool awready = false;
  bool wready = false;
  bool bvalid = false;
  UInt<2> bresp = 0;  // 0 okay, 2 SLVERR
  bool arready = false;
  bool rvalid = false;
  UInt<32> rdata = 0;
  UInt<2> rresp = 0;
};
template <class Csr>
AxiAnswers axi_answers(const AxiLite::Out& bus, const Csr& drive) {
  return {.awready = bus.awready,
          .wready = bus.wready,
          .bvalid = bus.bvalid,
          .bresp = drive.write_error ? UInt<2>(2) : UInt<2>(0),
          .arready = bus.arready,
          .rvalid = bus.rvalid,
          .rdata = drive.data,
          .rresp = drive.read_error ? UInt<2>(2) : UInt<2>(0)};
}

}  // namespace steplock
