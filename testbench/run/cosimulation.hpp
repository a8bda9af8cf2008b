// Drive and plant together, clock by clock.
//
//     clock n:   pins as they are at n T  ->  engine.tick()  ->  gates, on from n T
//
// So a pin is seen one clock after it changed, as a flip-flop would.  The plant is asked only when it
// has something to say: when gates change, when one of its pins does, and at sample times; all that
// is decided by comparing whole clock numbers, and between two such clocks the loop is the engine's
// own.  An engine is a class with
//
//     void set_pins(const plant::Pins&);  void set_command(const HostCommand&);
//     void tick();                        Watch watch() const;     DriveView view() const;
//     void set_reading(const plant::State&);    with ADCs only: at the clock of a sample strobe
//
// and may be able to take many clocks at once (run/advance.hpp).  What it is watched by is its own
// (watch.hpp of drive/six_step/ and drive/sinusoidal/).
//
// Doc: docs/report.md   Test: tests/testbench/engine_test.cpp
#pragma once

#include <algorithm>
#include <cmath>
#include <utility>

#include "testbench/run/advance.hpp"
#include "testbench/run/timeline.hpp"

namespace steplock {

// `Recording` is a RecorderOf (recorder_of.hpp), or has its calls.
template <class Engine, class Recording>
class Cosimulation {
  using Watch = decltype(std::declval<const Engine&>().watch());

 public:
  Cosimulation(Engine& engine, plant::Plant& plant, const Timeline& timeline, Recording& recorder,
               double clock_hz)
      : engine_(engine), plant_(plant), timeline_(timeline), recorder_(recorder),
        clock_hz_(clock_hz) {
    for (const PinFault& fault : timeline.faults) faults_.add(fault);
  }

  std::uint64_t clock() const { return clock_; }

  // The timeline may grow while the simulation stands, by events later than clock().
  void add(const PinFault& fault) { faults_.add(fault); }

  // Runs clocks up to `end`, exclusive.
  void run_until(std::uint64_t end) {
    plan_visit(clock_);
    while (clock_ < end) {
      if (clock_ >= visit_) visit();
      std::uint64_t stop = std::min(end, visit_);
      while (clock_ < stop) {
        clock_ += advance(engine_, stop - clock_) - 1;
        if (const Watch now = engine_.watch(); now != watch_) {
          changed(now);
          stop = std::min(end, visit_);
        }
        ++clock_;
      }
    }
  }

 private:
  double time() const { return static_cast<double>(clock_) / clock_hz_; }
  std::uint64_t clock_at(double t) const {
    return t < kFar ? static_cast<std::uint64_t>(std::ceil(t * clock_hz_)) : kNever;
  }

  // The clock has come at which something outside the drive happens.
  void visit() {
    plant_.advance_to(time());
    while (next_event_ < timeline_.events.size() &&
           timeline_.events[next_event_].clock <= clock_) {
      const Event& event = timeline_.events[next_event_++];
      command_ = event.command;
      load_nm_ = event.load_nm;
      engine_.set_command(command_);
      plant_.set_load_torque(load_nm_);
      plant_.set_coupled_inertia(event.inertia_kgm2);
      if (event.source_v > 0) plant_.set_bus_voltage(event.source_v);
      for (int k = 0; k < 3; ++k) plant_.set_open(k, event.open[static_cast<std::size_t>(k)]);
    }
    if (clock_ >= sample_) {
      recorder_.sample(plant_.state(), watch_, engine_.view(), load_nm_);
      sample_ = std::max(clock_at(recorder_.next_sample()), clock_ + 1);
    }
    show_pins(clock_);
  }

  void changed(Watch now) {
    plant_.advance_to(time());
    const bool new_gates = now.gate_bits() != watch_.gate_bits();
    const bool strobe_only = ((now.bits ^ watch_.bits) & ~Watch::kStrobeMask) == 0;
    if (!strobe_only || recorder_.tracing()) {
      recorder_.changed(plant_.state(), watch_, now, engine_.view(), load_nm_);
      sample_ = std::max(clock_at(recorder_.next_sample()), clock_ + 1);
    }
    if constexpr (requires { engine_.set_reading(plant_.state()); }) {
      if (now.sample() && !watch_.sample()) engine_.set_reading(plant_.state());
    }
    if (new_gates) plant_.set_gates(now.gates());
    if (now.step() != watch_.step()) faults_.commutated(clock_ + 1, now.step());
    watch_ = now;
    show_pins(clock_ + 1);
  }

  // What the drive sees in clock `first` and after it.
  void show_pins(std::uint64_t first) {
    if (const plant::Pins seen = faults_.seen(first, plant_.pins()); seen != pins_) {
      pins_ = seen;
      engine_.set_pins(pins_);
      recorder_.pins_changed(time(), pins_);
    }
    plan_visit(clock_ + 1);
  }

  void plan_visit(std::uint64_t earliest) {
    visit_ = std::min(clock_at(plant_.next_event()), sample_);
    if (next_event_ < timeline_.events.size()) {
      visit_ = std::min(visit_, timeline_.events[next_event_].clock);
    }
    visit_ = std::max(std::min(visit_, faults_.next(clock_)), earliest);
  }

  static constexpr double kFar = 1e9;  // s
  static constexpr std::uint64_t kNever = ~std::uint64_t{0};

  Engine& engine_;
  plant::Plant& plant_;
  const Timeline& timeline_;
  Recording& recorder_;
  double clock_hz_;
  std::uint64_t clock_ = 0, visit_ = 0, sample_ = 0;
  std::size_t next_event_ = 0;
  HostCommand command_;
  double load_nm_ = 0;
  PinFaults faults_;
  plant::Pins pins_;
  Watch watch_;
};

}  // namespace steplock
