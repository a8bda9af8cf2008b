// The generated SystemVerilog, compiled by Verilator, behind the engines' interface.
//
// What the module shows between two edges is the output of that clock.  tick() gives the edge that
// ends the last clock, with the inputs of that clock, and then shows the new ones.  Words and command
// pass the wrapper's flip-flops (bench_wrapper.cmake) and pins end in flip-flops, so an output changes
// only at an edge or with the command.
//
// Test: tests/testbench/engine_test.cpp
#pragma once

#include <cstdint>

#include "ports/six_step_top_ports.hpp"
#include "testbench/engine/fixed.hpp"
#include "verilated/Vsix_step_bench.h"

namespace steplock {

class RtlEngine {
 public:
  static constexpr const char* kName = "rtl";

  RtlEngine(const Words& words, double clock_hz) : clock_hz_(clock_hz) {
    in_.words = words;
    show_inputs();
    top_.rst = 1;  // through the first edge, which ends the time before clock 0
    shown_ = false;
  }
  ~RtlEngine() { top_.final(); }
  RtlEngine(const RtlEngine&) = delete;
  RtlEngine& operator=(const RtlEngine&) = delete;

  void set_pins(const plant::Pins& pins) {
    put_pins(in_.pins, pins);
    shown_ = false;
  }
  void set_command(const HostCommand& c) {
    in_.command = command_of(c);
    in_.pins.fault = c.fault_pin;
    shown_ = false;
  }

  void tick() {
    edge();
    if (!shown_) show_inputs();
  }
  std::uint64_t quiet() const { return 0; }
  void skip(std::uint64_t) {}

  Watch watch() const { return {top_.watch_o}; }
  DriveView view() const {
    return {.steps_per_second = top_.frequency_o * clock_hz_ / 4294967296.0 /
                                (1 << top_.words_loop_divide_i),
            .duty = top_.duty_o / 32768.0,
            .phase_error_deg = 60.0 * static_cast<std::int16_t>(top_.phase_error_o) / 65536,
            .step_phase_deg = 60.0 * top_.step_phase_o / 65536,
            .crossings = top_.counts_crossings_o,
            .missed = top_.counts_missed_o,
            .freewheel_long = top_.counts_freewheel_long_o,
            .limit_hits = top_.counts_limit_hits_o,
            .retries = top_.counts_retries_o};
  }
  // The name of the first output that differs from the block's, or null.
  const char* differs(const SixStepTop::Out& out) const {
    return ports::six_step_top::differs(top_, out);
  }

 private:
  void show_inputs() {
    ports::six_step_top::drive_ports(top_, in_);
    top_.rst = 0;
    top_.load = 1;
    top_.eval();
    top_.load = 0;
    top_.eval();
    shown_ = true;
  }
  void edge() {
    top_.clk = 1;
    top_.eval();
    top_.clk = 0;
    top_.eval();
  }

  Vsix_step_bench top_;
  SixStepTop::In in_;
  double clock_hz_;
  bool shown_ = true;
};

}  // namespace steplock
