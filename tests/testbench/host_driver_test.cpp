// The C driver of rtl/host turns a motor: every access goes through AXI4-Lite into the RTL of
// six_step_axi, whose pins are the plant's; the bus and the motor share every clock.
#include <gtest/gtest.h>

#include <functional>
#include <vector>

#include "Vsix_step_axi.h"
#include "hls/bus/six_step_axi.hpp"
#include "model/design/design.hpp"
#include "model/design/config.hpp"
#include "ports/six_step_axi_ports.hpp"
#include "testbench/bus/register_config.hpp"
#include "testbench/drive/six_step/fixed_engine.hpp"
#include "testbench/drive/six_step/config.hpp"
#include "testbench/run/check.hpp"
#include "testbench/run/units.hpp"
#include "tests/testbench/host_bus.hpp"
#include "tests/testbench/short_drive.hpp"

namespace steplock {
namespace {

// Motor, inverter, drive and bus, clock by clock.
class Bench {
 public:
  Bench()
      : settings_(short_drive()),
        clock_hz_(settings_.control.clock_hz),
        config_(hls_config(
            design::quantise(design::design_drive(settings_).parameters, clock_hz_).config)),
        plant_(plant_parameters(settings_), initial_state(settings_, 70)) {
    reset_rtl(rtl_);
  }
  ~Bench() { rtl_.final(); }
  Bench(const Bench&) = delete;
  Bench& operator=(const Bench&) = delete;

  steplock_bus bus() { return driver_bus(master_); }
  std::vector<steplock_word> config() const { return register_config(config_); }
  std::uint32_t speed(std::uint32_t erpm) const {
    return steplock_speed(erpm, std::uint32_t(clock_hz_), unsigned(config_.loop.divide.raw()));
  }
  void wait(double seconds) {
    const auto end = clock_ + std::uint64_t(seconds * clock_hz_);
    while (clock_ < end) tick({});
  }
  double rpm() {
    plant_.advance_to(double(clock_) / clock_hz_);
    return steplock::rpm(plant_.state().speed);
  }
  int pole_pairs() const { return settings_.motor.pole_pairs; }
  bool gates_off() const { return gates_ == plant::Gates{}; }
  bool interrupt() { return rtl_.interrupt_o != 0; }
  std::uint64_t shoot_throughs() const { return plant_.shoot_throughs(); }
  bool fault_pin = false;
  unsigned clock_khz = 0;

 private:
  AxiAnswers tick(const AxiLite::In& axi) {
    Vsix_step_axi& rtl = rtl_;
    const double now = double(clock_) / clock_hz_;
    if (now >= plant_.next_event()) plant_.advance_to(now);
    SixStepAxi::In in{.with = {}, .pins = {}, .clock_khz = clock_khz, .axi = axi};
    put_pins(in.pins, plant_.pins());
    in.pins.fault = fault_pin;
    ports::six_step_axi::drive_ports(rtl, in);
    rtl.clk = 0;
    rtl.eval();
    const plant::Gates gates = gates_at(rtl);
    if (!(gates == gates_)) {
      plant_.advance_to(now);
      plant_.set_gates(gates_ = gates);
    }
    const AxiAnswers out = answers_at(rtl);
    rtl.clk = 1;
    rtl.eval();
    ++clock_;
    return out;
  }

  design::Settings settings_;
  double clock_hz_;
  SixStepConfig config_;
  plant::Plant plant_;
  plant::Gates gates_;
  Vsix_step_axi rtl_;
  std::uint64_t clock_ = 0;
  std::function<AxiAnswers(const AxiLite::In&)> step_ = [this](const AxiLite::In& axi) {
    return tick(axi);
  };
  AxiMaster<decltype(step_)> master_{step_};
};

TEST(HostDriver, StartsReversesFaultsClearsAndStopsAMotorThroughTheRtl) {
  Bench bench;
  const steplock_bus bus = bench.bus();
  const auto config = bench.config();
  const auto erpm = std::uint32_t(3000 * bench.pole_pairs());
  steplock_status status;
  steplock_telemetry telemetry;
  std::uint32_t bits = 0;

  ASSERT_EQ(steplock_init(&bus, config.data(), config.size()), STEPLOCK_OK);
  ASSERT_EQ(steplock_set_watchdog(&bus, 200), STEPLOCK_OK);
  const std::uint32_t events = STEPLOCK_INTERRUPT_STARTED_MASK | STEPLOCK_INTERRUPT_FAULT_MASK;
  ASSERT_EQ(steplock_enable_interrupts(&bus, events), STEPLOCK_OK);
  ASSERT_EQ(steplock_set_speed(&bus, bench.speed(erpm)), STEPLOCK_OK);
  ASSERT_EQ(steplock_start(&bus, 0), STEPLOCK_OK);
  EXPECT_EQ(steplock_init(&bus, config.data(), config.size()), STEPLOCK_NOT_STOPPED);

  // As a main loop would: a heartbeat every 20 ms until `done` or 0.7 s.
  const auto beat_until = [&](auto done) {
    for (int i = 0; i < 35 && !done(); ++i) {
      bench.wait(0.02);
      ASSERT_EQ(steplock_heartbeat(&bus), STEPLOCK_OK);
      ASSERT_EQ(steplock_get_status(&bus, &status), STEPLOCK_OK);
    }
  };
  beat_until([&] { return bench.interrupt(); });
  ASSERT_EQ(steplock_take_interrupts(&bus, &bits), STEPLOCK_OK);
  EXPECT_EQ(bits, STEPLOCK_INTERRUPT_STARTED_MASK | STEPLOCK_INTERRUPT_LOCK_MASK);
  EXPECT_FALSE(bench.interrupt());
  beat_until([&] { return bench.rpm() > 2970; });
  for (int i = 0; i < 3; ++i) beat_until([i, n = 0]() mutable { return n++ == 1; });
  EXPECT_NEAR(bench.rpm(), 3000, 60);  // 2 %: the speed just arrived
  ASSERT_EQ(steplock_get_telemetry(&bus, &telemetry), STEPLOCK_OK);
  EXPECT_NEAR(telemetry.frequency, bench.speed(erpm), 0.02 * bench.speed(erpm));
  EXPECT_GT(telemetry.crossings, 100);
  EXPECT_GT(telemetry.duty, 0);

  ASSERT_EQ(steplock_reverse(&bus, 1), STEPLOCK_OK);
  beat_until([&] { return bench.rpm() < -2900; });
  EXPECT_NEAR(bench.rpm(), -3000, 120);
  EXPECT_TRUE(status.locked && status.reverse);

  ASSERT_EQ(steplock_stop(&bus, 1), STEPLOCK_OK);
  beat_until([&] { return status.stopped != 0; });
  EXPECT_NEAR(bench.rpm(), 0, 300) << "braked, not coasting";
  ASSERT_EQ(steplock_start(&bus, 1), STEPLOCK_OK);
  bench.wait(0.1);  // long enough to look, and to begin
  ASSERT_EQ(steplock_get_status(&bus, &status), STEPLOCK_OK);
  EXPECT_FALSE(status.stopped);

  bench.fault_pin = true;
  bench.wait(10e-6);
  EXPECT_TRUE(bench.gates_off() && bench.interrupt());
  EXPECT_EQ(steplock_clear_fault(&bus), STEPLOCK_FAULT_LATCHED) << "the pin is still up";
  EXPECT_EQ(steplock_start(&bus, 0), STEPLOCK_FAULT_LATCHED);
  ASSERT_EQ(steplock_get_status(&bus, &status), STEPLOCK_OK);
  EXPECT_EQ(status.reason, 1u) << "fault pin";
  bench.fault_pin = false;
  bench.wait(10e-6);
  EXPECT_EQ(steplock_clear_fault(&bus), STEPLOCK_OK);
  ASSERT_EQ(steplock_get_status(&bus, &status), STEPLOCK_OK);
  EXPECT_TRUE(status.stopped && !status.fault);
  EXPECT_EQ(bench.shoot_throughs(), 0u);
}

TEST(HostDriver, AHostThatStopsBeatingLosesTheBridge) {
  Bench bench;
  const steplock_bus bus = bench.bus();
  const auto config = bench.config();
  ASSERT_EQ(steplock_init(&bus, config.data(), config.size()), STEPLOCK_OK);
  ASSERT_EQ(steplock_set_watchdog(&bus, 10), STEPLOCK_OK);
  ASSERT_EQ(steplock_start(&bus, 0), STEPLOCK_OK);
  bench.wait(0.03);  // ticks are about a millisecond
  EXPECT_TRUE(bench.gates_off());
  steplock_status status;
  ASSERT_EQ(steplock_get_status(&bus, &status), STEPLOCK_OK);
  EXPECT_TRUE(status.watchdog && status.stopped);
  EXPECT_EQ(steplock_start(&bus, 0), STEPLOCK_FAULT_LATCHED);
  EXPECT_EQ(steplock_clear_fault(&bus), STEPLOCK_OK);
}

TEST(HostDriver, WordsWithoutAPeriodAreRefusedAndMoveNoGate) {
  Bench bench;
  const steplock_bus bus = bench.bus();
  auto config = bench.config();
  unsigned axes = 0;
  EXPECT_EQ(steplock_get_axes(&bus, &axes), STEPLOCK_OK);
  EXPECT_EQ(axes, 1u);
  for (auto& word : config) {
    if (word.offset == STEPLOCK_PWM) word.value &= ~STEPLOCK_PWM_PERIOD_MASK;
  }
  EXPECT_EQ(steplock_init(&bus, config.data(), config.size()), STEPLOCK_NO_PERIOD);
  EXPECT_EQ(bus.write(bus.context, STEPLOCK_CONTROL, 3), 0) << "a host that does it all the same";
  for (int i = 0; i < 20; ++i) {
    bench.wait(1e-4);
    EXPECT_TRUE(bench.gates_off());
  }
}

// Whoever rounds 33 1/3 MHz to the kHz may have taken 33.333 or 33.334: a kHz apart is the same clock.
TEST(HostDriver, WordsOfAnotherClockAreRefusedBeforeAnyIsWritten) {
  Bench bench;
  const steplock_bus bus = bench.bus();
  auto config = bench.config();
  config.insert(config.begin(), {STEPLOCK_CLOCK, 33'334});
  std::uint32_t clock_hz = 1, pwm = 1;
  EXPECT_EQ(steplock_get_clock(&bus, &clock_hz), STEPLOCK_OK);
  EXPECT_EQ(clock_hz, 0u) << "its pins are tied to 0";
  bench.clock_khz = 24'000;
  EXPECT_EQ(steplock_get_clock(&bus, &clock_hz), STEPLOCK_OK);
  EXPECT_EQ(clock_hz, 24'000'000u);
  EXPECT_EQ(steplock_get_clock(&bus, nullptr), STEPLOCK_REFUSED);
  EXPECT_EQ(steplock_init(&bus, config.data(), config.size()), STEPLOCK_WRONG_CLOCK);
  EXPECT_STREQ(steplock_result_name(STEPLOCK_WRONG_CLOCK), "wrong clock");
  EXPECT_EQ(bus.read(bus.context, STEPLOCK_PWM, &pwm), 0);
  EXPECT_EQ(pwm, STEPLOCK_PWM_RESET) << "nothing was written";
  for (const unsigned khz : {33'333u, 33'334u, 33'335u, 0u}) {
    bench.clock_khz = khz;
    EXPECT_EQ(steplock_init(&bus, config.data(), config.size()), STEPLOCK_OK) << khz;
  }
  for (const unsigned khz : {33'332u, 33'336u}) {
    bench.clock_khz = khz;
    EXPECT_EQ(steplock_init(&bus, config.data(), config.size()), STEPLOCK_WRONG_CLOCK) << khz;
  }
}

TEST(HostDriver, FindsNoDriveWhereNoneIs) {
  const steplock_bus nothing = {
      .write = [](void*, std::uint32_t, std::uint32_t) { return 0; },
      .read = [](void*, std::uint32_t, std::uint32_t* value) { return *value = 0, 0; },
      .context = nullptr};
  EXPECT_EQ(steplock_init(&nothing, nullptr, 0), STEPLOCK_NO_DRIVE);
}

// A word of 2^-32 turns per clock; truncated.
TEST(HostDriver, ASpeedIsTheWordOfItsFrequency) {
  EXPECT_EQ(steplock_speed(12000, 12'000'000, 0), 429496u);  // 1200 steps/s: 1e-4 turns per clock
  EXPECT_EQ(steplock_speed(12000, 12'000'000, 2), 4 * 429496u);
  EXPECT_EQ(steplock_speed(0xffffffff, 1'000'000, 0), 0x3ffffffu) << "stops at the largest";
}

}  // namespace
}  // namespace steplock
