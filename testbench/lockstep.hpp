// Lockstep: a Verilated module, with the clock and reset of a block.
//
// What the module shows before an edge is the output of that clock, tick(in) of the block; then comes
// the edge.  A module without registers has no clock, and none is given.
//
// Test: every test in tests/rtl/

#pragma once

#include <memory>

namespace steplock {

template <class Rtl>
class Lockstep {
 public:
  Lockstep() : rtl_(std::make_unique<Rtl>()) {
    if constexpr (requires { rtl_->rst; }) {
      rtl_->rst = 1;
      edge();
      rtl_->rst = 0;
    }
  }
  ~Lockstep() { rtl_->final(); }
  Lockstep(const Lockstep&) = delete;
  Lockstep& operator=(const Lockstep&) = delete;

  Rtl& ports() { return *rtl_; }
  void settle() { rtl_->eval(); }
  void edge() {
    if constexpr (requires { rtl_->clk; }) {
      rtl_->clk = 0;
      rtl_->eval();
      rtl_->clk = 1;
      rtl_->eval();
    }
  }

 private:
  std::unique_ptr<Rtl> rtl_;
};

}  // namespace steplock
