// A motor that only pins run: the RTL of six_step_standalone, its words tied as `steplock design --verilog` ties
// them, with the plant's pins and gates on every clock.
#include <gtest/gtest.h>

#include "Vsix_step_standalone.h"
#include "hls/six_step/six_step_standalone.hpp"
#include "model/design/design.hpp"
#include "model/design/config.hpp"
#include "ports/six_step_standalone_ports.hpp"
#include "testbench/drive/six_step/fixed_engine.hpp"
#include "testbench/drive/six_step/config.hpp"
#include "testbench/run/check.hpp"
#include "tests/testbench/short_drive.hpp"

namespace steplock {
namespace {

class Bench {
 public:
  Bench()
      : settings_(short_drive()),
        clock_hz_(settings_.control.clock_hz),
        plant_(plant_parameters(settings_), initial_state(settings_, 70)) {
    in.config = hls_config(
        design::quantise(design::design_drive(settings_).parameters, clock_hz_).config);
    rtl_.rst = 1;
    rtl_.eval();
    rtl_.clk = 1;
    rtl_.eval();
    rtl_.rst = 0;
  }
  ~Bench() { rtl_.final(); }
  Bench(const Bench&) = delete;
  Bench& operator=(const Bench&) = delete;

  // Until `done` or for so long; true if it was done.
  template <class Done>
  bool wait(double seconds, Done done) {
    const auto end = clock_ + std::uint64_t(seconds * clock_hz_);
    while (clock_ < end && !done()) tick();
    return done();
  }
  void wait(double seconds) {
    wait(seconds, [] { return false; });
  }
  double rpm() {
    plant_.advance_to(double(clock_) / clock_hz_);
    return plant_.state().speed * 60 / (2 * 3.14159265358979);
  }
  bool gates_off() const { return gates_ == plant::Gates{}; }
  bool locked() { return rtl_.locked_o != 0; }
  bool fault() { return rtl_.fault_o != 0; }
  int turns() const { return turns_; }
  int pole_pairs() const { return settings_.motor.pole_pairs; }
  std::uint64_t shoot_throughs() const { return plant_.shoot_throughs(); }
  SixStepStandalone::In in;
  bool fault_pin = false;

 private:
  void tick() {
    auto& rtl = rtl_;
    const double now = double(clock_) / clock_hz_;
    if (now >= plant_.next_event()) plant_.advance_to(now);
    put_pins(in.pins, plant_.pins());
    in.pins.fault = fault_pin;
    ports::six_step_standalone::drive_ports(rtl, in);
    rtl.clk = 0;
    rtl.eval();
    const plant::Gates gates{.uh = rtl.gates_uh_o != 0, .ul = rtl.gates_ul_o != 0,
                             .vh = rtl.gates_vh_o != 0, .vl = rtl.gates_vl_o != 0,
                             .wh = rtl.gates_wh_o != 0, .wl = rtl.gates_wl_o != 0};
    if (!(gates == gates_)) {
      plant_.advance_to(now);
      plant_.set_gates(gates_ = gates);
    }
    const bool turn = rtl.turn_o != 0;
    turns_ += turn && !turn_;
    turn_ = turn;
    rtl.clk = 1;
    rtl.eval();
    ++clock_;
  }

  design::Settings settings_;
  double clock_hz_;
  plant::Plant plant_;
  plant::Gates gates_;
  Vsix_step_standalone rtl_;
  std::uint64_t clock_ = 0;
  bool turn_ = false;
  int turns_ = 0;
};

TEST(StandaloneDrive, StartsSlowsDownStopsAndForgivesByItsPins) {
  Bench bench;
  bench.wait(0.02);
  EXPECT_TRUE(bench.gates_off());

  bench.in.controls = {.run = true, .speed = 3};
  ASSERT_TRUE(bench.wait(0.5, [&] { return bench.locked(); }));
  bench.wait(0.3);
  EXPECT_NEAR(bench.rpm(), 3000, 60);  // 2 %, as in the runs' own verdict shortly after a step
  // The tachometer: one period per electrical turn.
  const int before = bench.turns();
  bench.wait(0.05);
  EXPECT_NEAR(bench.turns() - before, 0.05 * 3000 / 60 * bench.pole_pairs(), 1.1);

  bench.in.controls.speed = 1;
  bench.wait(0.35);
  EXPECT_NEAR(bench.rpm(), 1500, 30) << "half";
  EXPECT_TRUE(bench.locked());

  bench.fault_pin = true;
  bench.wait(1e-6);
  EXPECT_TRUE(bench.gates_off() && bench.fault());
  bench.fault_pin = false;
  bench.wait(0.03);
  EXPECT_TRUE(bench.gates_off() && bench.fault()) << "latched while run is held";
  bench.in.controls.run = false;
  bench.wait(0.02);
  EXPECT_TRUE(bench.gates_off() && !bench.fault()) << "re-armed";
  EXPECT_EQ(bench.shoot_throughs(), 0u);
}

}  // namespace
}  // namespace steplock
