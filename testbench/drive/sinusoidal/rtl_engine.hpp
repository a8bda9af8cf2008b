// The generated SystemVerilog of the sinusoidal drive, compiled by Verilator, behind the engines'
// interface, with its ADCs.
//
// What the module shows between two edges is the output of that clock.  tick() gives the edge that ends
// the last clock, with the inputs of that clock, and then puts the new ones there.
//
// Test: tests/testbench/sinusoidal_engines_test.cpp
#pragma once

#include "ports/sinusoidal_top_ports.hpp"
#include "testbench/drive/sinusoidal/fixed_engine.hpp"
#include "verilated_sinusoidal/Vsinusoidal_top.h"

namespace steplock::sinusoidal {

class RtlEngine {
 public:
  static constexpr const char* kName = "rtl";

  RtlEngine(const design::Settings& s, const plant::AdcParameters& adc)
      : inputs_(s, adc), showing_(s) {
    top_.rst = 1;  // until the first edge, which ends the time before clock 0
    top_.clk = 0;
    show();
    top_.eval();
  }
  ~RtlEngine() { top_.final(); }
  RtlEngine(const RtlEngine&) = delete;
  RtlEngine& operator=(const RtlEngine&) = delete;

  void set_pins(const plant::Pins&) {}  // comparators and Halls serve the six-step drive
  void set_command(const HostCommand& c) { inputs_.command(c), shown_ = false; }
  void set_target_rpm(double rpm) { inputs_.target_rpm(rpm), shown_ = false; }
  void lose_samples(bool lose) { inputs_.lose(lose); }
  void set_reading(const plant::State& s) { inputs_.reading(s), shown_ = false; }

  void tick() {
    top_.clk = 1;
    top_.eval();
    top_.rst = 0;
    if (!shown_) show();
    top_.clk = 0;
    top_.eval();
  }

  Watch watch() const {
    const auto bit = [](auto port, int place) { return std::uint32_t{port} << place; };
    return {bit(top_.gates_uh_o, 0) | bit(top_.gates_ul_o, 1) | bit(top_.gates_vh_o, 2) |
            bit(top_.gates_vl_o, 3) | bit(top_.gates_wh_o, 4) | bit(top_.gates_wl_o, 5) |
            bit(top_.state_o, Watch::kState) | bit(top_.reason_o, Watch::kReason) |
            bit(top_.sample_o, Watch::kSample) | bit(top_.locked_o, Watch::kLocked)};
  }
  View view() const {
    SinusoidalTop::Out o;
    o.estimating = top_.estimating_o != 0;
    o.angle = Angle::of(top_.angle_o);
    o.initial = Angle::of(top_.initial_o);
    o.speed = Int<16>::of(top_.speed_o);
    o.reference = Int<16>::of(top_.reference_o);
    o.i_gamma = Int<16>::of(top_.i_gamma_o);
    o.i_delta = Int<16>::of(top_.i_delta_o);
    o.wanted = Int<16>::of(top_.wanted_o);
    return showing_.view(o, inputs_.in.command.reverse);
  }
  // The name of the first output that differs from the block's, or null.
  const char* differs(const SinusoidalTop::Out& out) const {
    return ports::sinusoidal_top::differs(top_, out);
  }

 private:
  // Codes stand for one clock; without them the ports change again in the next.
  void show() {
    ports::sinusoidal_top::drive_ports(top_, inputs_.in);
    shown_ = !inputs_.in.codes.valid;
    inputs_.in.codes.valid = false;
  }

  Inputs inputs_;
  Showing showing_;
  Vsinusoidal_top top_;
  bool shown_ = true;
};

}  // namespace steplock::sinusoidal
