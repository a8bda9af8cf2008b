// The generated SystemVerilog, compiled by Verilator, behind the engines' interface.
//
// What the module shows between two edges is the output of that clock.  tick() gives the edge that
// ends the last clock, with the pins of that clock, and then puts the new ones there; run() goes on
// with these.  Configuration and command pass the wrapper's registers (bench_wrapper.cmake), which take them
// at that same edge.
//
// Test: tests/testbench/engine_test.cpp
#pragma once

#include <cstdint>

#include "ports/six_step_top_ports.hpp"
#include "testbench/drive/six_step/fixed_engine.hpp"
#include "verilated/Vsix_step_bench.h"

namespace steplock {

class RtlEngine {
 public:
  static constexpr const char* kName = "rtl";

  RtlEngine(const SixStepConfig& config, double clock_hz) : config_(config), clock_hz_(clock_hz) {
    in_.config = config;
    show_command();
    top_.rst = 1;  // until the first edge, which ends the time before clock 0
    top_.eval();   // settles, before there is an edge to see
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
    in_.config.speed.target = target_of(c, config_, clock_hz_);
    shown_ = loaded_ = false;
  }

  void tick() { run(1); }
  // Clocks up to the first that changes watch(), at most `most`; returns how many.
  std::uint64_t run(std::uint64_t most) {
    if (!loaded_) show_command();
    top_.toggle ^= 1;
    const std::uint16_t before = top_.given;
    top_.until_given = static_cast<std::uint16_t>(before + (shown_ ? std::min(most, kMost) : 1));
    top_.eval();
    if (!shown_) show_pins();
    return static_cast<std::uint16_t>(top_.given - before);
  }

  Watch watch() const { return {top_.watch_o}; }
  DriveView view() {
    if (!looks_always_) {
      top_.look = 1;
      top_.eval();  // no edge
      top_.look = 0;
    }
    return {.steps_per_second = top_.frequency_o * clock_hz_ / 4294967296.0 /
                                (1 << top_.config_loop_divide_i),
            .duty = top_.duty_o / 32768.0,
            .phase_error_deg = 60.0 * static_cast<std::int16_t>(top_.phase_error_o) / 65536,
            .step_phase_deg = 60.0 * top_.step_phase_o / 65536,
            .crossings = top_.counts_crossings_o,
            .missed = top_.counts_missed_o,
            .freewheel_long = top_.counts_freewheel_long_o,
            .limit_hits = top_.counts_limit_hits_o,
            .retries = top_.counts_retries_o};
  }
  // From now on all outputs are shown on every clock, for differs().
  void look_always() { top_.look = looks_always_ = true; }
  // The name of the first output that differs from the block's, or null.
  const char* differs(const SixStepTop::Out& out) const {
    return ports::six_step_top::differs(top_, out);
  }

 private:
  static constexpr std::uint64_t kMost = 0xffff;  // clocks of one eval(): the port's width

  // Configuration and command are taken at the coming edge; the pins of the last clock stay until then.
  void show_command() {
    SixStepTop::In in = in_;
    in.pins = shown_pins_;
    ports::six_step_top::drive_ports(top_, in);
    top_.load = 1;
    loaded_ = true;
  }
  void show_pins() {
    const Synchroniser::Pins& p = in_.pins;
    top_.pins_comparator_u_i = p.comparator_u;
    top_.pins_comparator_v_i = p.comparator_v;
    top_.pins_comparator_w_i = p.comparator_w;
    top_.pins_limit_i = p.limit;
    top_.pins_fault_i = p.fault;
    top_.pins_hall_u_i = p.hall_u;
    top_.pins_hall_v_i = p.hall_v;
    top_.pins_hall_w_i = p.hall_w;
    top_.rst = top_.load = 0;
    shown_pins_ = p;
    shown_ = true;
  }

  SixStepConfig config_;
  Vsix_step_bench top_;
  SixStepTop::In in_;
  Synchroniser::Pins shown_pins_;
  double clock_hz_;
  bool shown_ = false, loaded_ = true, looks_always_ = false;
};

}  // namespace steplock
