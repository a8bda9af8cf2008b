// The C driver of rtl/host turns a motor with sinusoidal currents: every access goes through AXI4-Lite into the RTL of
// sinusoidal_axi, whose ADCs and pins are the plant's; the bus and the motor share every clock.
#include <gtest/gtest.h>

#include <functional>
#include <vector>

#include "Vsinusoidal_axi.h"
#include "hls/bus/sinusoidal_axi.hpp"
#include "hls/bus/sinusoidal_registers.hpp"
#include "model/plant/adc.hpp"
#include "ports/sinusoidal_axi_ports.hpp"
#include "rtl/host/steplock_sinusoidal.h"
#include "testbench/bus/register_config.hpp"
#include "testbench/run/check.hpp"
#include "testbench/run/units.hpp"
#include "testbench/drive/sinusoidal/config.hpp"
#include "tests/testbench/host_bus.hpp"

namespace steplock {
namespace {

constexpr int kConversion = 48;  // clocks from the strobe to the codes

// Motor, inverter, ADCs, drive and bus, clock by clock.
class Bench {
 public:
  Bench()
      : settings_(open_drive_file(STEPLOCK_DRIVES "/m2310p_sinusoidal.toml").settings),
        clock_hz_(settings_.control.clock_hz),
        config_(sinusoidal::config_of(settings_)),
        plant_(plant_parameters(settings_), initial_state(settings_, 70)),
        adc_(adc_parameters(settings_)) {
    reset_rtl(rtl_);
  }
  ~Bench() { rtl_.final(); }
  Bench(const Bench&) = delete;
  Bench& operator=(const Bench&) = delete;

  steplock_bus bus() { return driver_bus(master_); }
  std::vector<steplock_word> config() const { return register_config<Sinusoidal>(config_); }
  std::uint32_t clock_hz() const { return std::uint32_t(clock_hz_); }
  std::uint32_t period() const { return std::uint32_t(config_.bridge.period.raw()); }
  std::uint32_t speed(double rpm) const {
    return steplock_sinusoidal_speed(std::uint32_t(rpm * settings_.motor.pole_pairs), clock_hz(), period());
  }
  double rpm_of(std::int16_t speed) const {
    return double(steplock_sinusoidal_erpm(speed, clock_hz(), period())) / settings_.motor.pole_pairs;
  }
  void wait(double seconds) {
    const auto end = clock_ + std::uint64_t(seconds * clock_hz_);
    while (clock_ < end) tick({});
  }
  double rpm() {
    plant_.advance_to(double(clock_) / clock_hz_);
    return steplock::rpm(plant_.state().speed);
  }
  const design::Settings& settings() const { return settings_; }
  bool gates_off() const { return gates_ == plant::Gates{}; }
  bool interrupt() { return rtl_.interrupt_o != 0; }
  std::uint64_t shoot_throughs() const { return plant_.shoot_throughs(); }
  bool fault_pin = false;

 private:
  AxiAnswers tick(const AxiLite::In& axi) {
    Vsinusoidal_axi& rtl = rtl_;
    const double now = double(clock_) / clock_hz_;
    if (now >= plant_.next_event()) plant_.advance_to(now);
    SinusoidalAxi::In in{.fault = fault_pin, .codes = {}, .axi = axi};
    if (left_ > 0 && --left_ == 0) {
      in.codes = {.valid = true, .u = held_.current[0], .v = held_.current[1], .dc = held_.bus};
    }
    ports::sinusoidal_axi::drive_ports(rtl, in);
    rtl.clk = 0;
    rtl.eval();
    const plant::Gates gates = gates_at(rtl);
    if (!(gates == gates_)) {
      plant_.advance_to(now);
      plant_.set_gates(gates_ = gates);
    }
    if (rtl.sample_o != 0) {
      plant_.advance_to(now);
      held_ = adc_.sample(plant_.state(), samples_++);
      left_ = kConversion;
    }
    const AxiAnswers out = answers_at(rtl);
    rtl.clk = 1;
    rtl.eval();
    ++clock_;
    return out;
  }

  design::Settings settings_;
  double clock_hz_;
  SinusoidalConfig config_;
  plant::Plant plant_;
  plant::Adc adc_;
  plant::AdcCodes held_;
  plant::Gates gates_;
  Vsinusoidal_axi rtl_;
  std::uint64_t clock_ = 0;
  std::int64_t samples_ = 0;
  int left_ = 0;  // clocks to the codes
  std::function<AxiAnswers(const AxiLite::In&)> step_ = [this](const AxiLite::In& axi) { return tick(axi); };
  AxiMaster<decltype(step_)> master_{step_};
};

constexpr unsigned kIdle = unsigned(SinusoidalState::kIdle);

struct Host : Bench {
  steplock_bus drive = bus();
  steplock_status status{};

  Host() {
    const auto list = config();
    EXPECT_EQ(steplock_init(&drive, list.data(), list.size()), STEPLOCK_OK);
    EXPECT_EQ(steplock_set_watchdog(&drive, 50), STEPLOCK_OK);
    EXPECT_EQ(steplock_enable_interrupts(&drive, STEPLOCK_INTERRUPT_STARTED_MASK | STEPLOCK_INTERRUPT_FAULT_MASK),
              STEPLOCK_OK);
  }
  // As a main loop would: a heartbeat every 10 ms until `done`, or for so long.
  template <class Done>
  bool beat(double seconds, Done done) {
    for (int i = 0; i < int(seconds / 0.01) && !done(); ++i) {
      wait(0.01);
      EXPECT_EQ(steplock_heartbeat(&drive), STEPLOCK_OK);
      EXPECT_EQ(steplock_get_status(&drive, &status), STEPLOCK_OK);
    }
    return done();
  }
  void beat(double seconds) {
    beat(seconds, [] { return false; });
  }
  void start(int reverse, double rpm) {
    EXPECT_EQ(steplock_set_speed(&drive, speed(rpm)), STEPLOCK_OK);
    ASSERT_EQ(steplock_start(&drive, reverse), STEPLOCK_OK);
    ASSERT_TRUE(beat(0.5, [&] { return status.locked != 0; }));
  }
};

TEST(SinusoidalHost, StartsChangesSpeedFaultsClearsAndStopsAMotorThroughTheRtl) {
  Host host;
  unsigned kind = 0;
  std::uint32_t bits = 0;
  ASSERT_EQ(steplock_get_kind(&host.drive, &kind), STEPLOCK_OK);
  EXPECT_EQ(kind, 2u);

  host.start(0, 3000);
  EXPECT_TRUE(host.interrupt());
  ASSERT_EQ(steplock_take_interrupts(&host.drive, &bits), STEPLOCK_OK);
  EXPECT_EQ(bits, STEPLOCK_INTERRUPT_STARTED_MASK | STEPLOCK_INTERRUPT_LOCK_MASK);
  const auto list = host.config();
  EXPECT_EQ(steplock_init(&host.drive, list.data(), list.size()), STEPLOCK_NOT_STOPPED);
  host.beat(0.5);
  EXPECT_NEAR(host.rpm(), 3000, 15);  // 0.5 %, as in the runs' own verdict
  steplock_sinusoidal_telemetry telemetry;
  ASSERT_EQ(steplock_sinusoidal_get_telemetry(&host.drive, &telemetry), STEPLOCK_OK);
  EXPECT_NEAR(host.rpm_of(telemetry.speed), 3000, 30);
  EXPECT_NEAR(host.rpm_of(telemetry.reference), 3000, 3);
  EXPECT_GT(telemetry.i_delta, 0) << "it drives a load";
  EXPECT_LT(telemetry.on_u, host.period());
  EXPECT_GT(telemetry.v_dc, 0);
  EXPECT_EQ(telemetry.retries, 0);

  ASSERT_EQ(steplock_set_speed(&host.drive, host.speed(1500)), STEPLOCK_OK);
  host.beat(0.4);
  EXPECT_NEAR(host.rpm(), 1500, 7.5);
  EXPECT_TRUE(host.status.locked);

  host.fault_pin = true;
  host.wait(10e-6);
  EXPECT_TRUE(host.gates_off() && host.interrupt());
  EXPECT_EQ(steplock_clear_fault(&host.drive), STEPLOCK_FAULT_LATCHED) << "the pin is still up";
  EXPECT_EQ(steplock_start(&host.drive, 0), STEPLOCK_FAULT_LATCHED);
  ASSERT_EQ(steplock_get_status(&host.drive, &host.status), STEPLOCK_OK);
  EXPECT_EQ(host.status.reason, unsigned(SinusoidalReason::kFaultPin));
  host.fault_pin = false;
  host.wait(10e-6);
  EXPECT_EQ(steplock_clear_fault(&host.drive), STEPLOCK_OK);
  host.beat(0.01);
  EXPECT_TRUE(host.status.stopped && !host.status.fault && host.gates_off());
  EXPECT_EQ(host.shoot_throughs(), 0u);
}

TEST(SinusoidalHost, StopsByBrakingAndLosesTheBridgeWhenItsHostFallsSilentOnTheWay) {
  Host host;
  host.start(1, 3000);
  host.beat(0.2);
  EXPECT_LT(host.rpm(), -2000);
  EXPECT_TRUE(host.status.reverse);
  ASSERT_EQ(steplock_stop(&host.drive, 1), STEPLOCK_OK);
  ASSERT_TRUE(host.beat(1, [&] { return host.status.stopped != 0; }));
  EXPECT_NEAR(host.rpm(), 0, 300) << "braked, not coasting";

  host.start(0, 3000);
  host.beat(0.1);
  ASSERT_EQ(steplock_stop(&host.drive, 1), STEPLOCK_OK);
  host.wait(0.002);
  EXPECT_FALSE(host.gates_off()) << "it slows down";
  host.wait(0.05);  // 50 ticks of 16 PWM periods of 50 us are 40 ms
  EXPECT_TRUE(host.gates_off());
  ASSERT_EQ(steplock_get_status(&host.drive, &host.status), STEPLOCK_OK);
  EXPECT_TRUE(host.status.watchdog && host.status.stopped);
  EXPECT_EQ(host.status.state, kIdle);
  EXPECT_EQ(steplock_start(&host.drive, 0), STEPLOCK_FAULT_LATCHED);
  EXPECT_EQ(steplock_clear_fault(&host.drive), STEPLOCK_OK);
  host.wait(0.01);
  EXPECT_TRUE(host.gates_off()) << "nothing goes on by itself";
  EXPECT_EQ(host.shoot_throughs(), 0u);
}

TEST(SinusoidalHost, WordsWithTooShortAPeriodAreRefusedAndMoveNoGate) {
  Bench bench;
  const steplock_bus bus = bench.bus();
  auto config = bench.config();
  for (auto& word : config) {
    if (word.offset == STEPLOCK_SINUSOIDAL_PWM) word.value = (word.value & ~STEPLOCK_SINUSOIDAL_PWM_PERIOD_MASK) | (kShortestPeriod - 1);
  }
  EXPECT_EQ(steplock_init(&bus, config.data(), config.size()), STEPLOCK_NO_PERIOD);
  EXPECT_EQ(bus.write(bus.context, STEPLOCK_CONTROL, 3), 0) << "a host that does it all the same";
  for (int i = 0; i < 20; ++i) {
    bench.wait(1e-4);
    EXPECT_TRUE(bench.gates_off());
  }
}

// The word of a speed is the design library's, but for rounding; a speed of the telemetry is the other way round.
TEST(SinusoidalHost, ASpeedIsTheWordOfTheDesignLibrary) {
  Bench bench;
  for (const double rpm : {10.0, 300.0, 1500.0, 3000.0, 6000.0}) {
    const auto word = design::sinusoidal::target_word(bench.settings(), rpm);
    EXPECT_NEAR(double(bench.speed(rpm)), double(word), 1 + 1e-5 * double(word)) << rpm;
  }
  EXPECT_EQ(steplock_sinusoidal_speed(0xffffffffu, 1, 0x3fff), STEPLOCK_SINUSOIDAL_SPEED_TARGET_TARGET_MASK);
  EXPECT_EQ(steplock_sinusoidal_erpm(0x4000, 24'000'000, 1200), 20'000 * 60 / 32);
  EXPECT_EQ(steplock_sinusoidal_erpm(-0x4000, 24'000'000, 1200), -20'000 * 60 / 32);
}

}  // namespace
}  // namespace steplock
