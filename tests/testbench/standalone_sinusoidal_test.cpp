// A motor that only pins run, its currents seen over SPI: the block sinusoidal_standalone in closed loop, its words
// those of `steplock design --verilog`; and its RTL beside it in every clock.
#include <gtest/gtest.h>

#include <memory>

#include "Vsinusoidal_standalone.h"
#include "hls/sinusoidal/sinusoidal_standalone.hpp"
#include "model/plant/adc.hpp"
#include "ports/sinusoidal_standalone_ports.hpp"
#include "testbench/run/check.hpp"
#include "testbench/run/units.hpp"
#include "testbench/drive/sinusoidal/config.hpp"
#include "tests/hls/spi_adc_model.hpp"

namespace steplock {
namespace {

// The RTL beside the block: the same inputs in every clock, and the first output that differs.
class Beside {
 public:
  ~Beside() { rtl_.final(); }
  void tick(bool reset, const SinusoidalStandalone::In& in, const SinusoidalStandalone::Out& out) {
    rtl_.rst = reset;
    ports::sinusoidal_standalone::drive_ports(rtl_, in);
    rtl_.clk = 0;
    rtl_.eval();
    if (!reset && differs == nullptr) differs = ports::sinusoidal_standalone::differs(rtl_, out);
    rtl_.clk = 1;
    rtl_.eval();
  }
  const char* differs = nullptr;

 private:
  Vsinusoidal_standalone rtl_;
};

class Bench {
 public:
  explicit Bench(bool with_rtl = false)
      : settings_(open_drive_file(STEPLOCK_DRIVES "/m2310p_sinusoidal.toml").settings),
        clock_hz_(settings_.control.clock_hz),
        plant_(plant_parameters(settings_), initial_state(settings_, 70)),
        adc_(adc_parameters(settings_)) {
    in.config = sinusoidal::config_of(settings_);
    in.adc = model_.config = sinusoidal::adc_config_of(settings_);
    model_.input = [this](int channel, long) { return held(channel); };
    if (with_rtl) rtl_ = std::make_unique<Beside>();
    reset();
  }
  Bench(const Bench&) = delete;

  void reset() {
    resets_ = true;
    tick();
    resets_ = false;
  }
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
    return steplock::rpm(plant_.state().speed);
  }
  bool gates_off() const { return out.gates == Gates{}; }
  int turns() const { return turns_; }
  int pole_pairs() const { return settings_.motor.pole_pairs; }
  std::uint64_t shoot_throughs() const { return plant_.shoot_throughs(); }
  int violations() const { return model_.violations; }
  const char* differs() const { return rtl_->differs; }

  SinusoidalStandalone::In in;
  SinusoidalStandalone::Out out;
  bool spoil = false;  // the RTL alone sees another bit from the ADC

 private:
  int held(int channel) {
    plant_.advance_to(double(clock_) / clock_hz_);
    samples_ += channel == 0;
    const plant::AdcCodes codes = adc_.sample(plant_.state(), samples_);
    return channel == 2 ? codes.bus : codes.current[std::size_t(channel)] + 2048;
  }

  void tick() {
    const SinusoidalStandalone::In now = in;
    out = dut_.tick(now);
    if (rtl_) {
      SinusoidalStandalone::In beside = now;
      beside.pins.miso = now.pins.miso != spoil;
      rtl_->tick(resets_, beside, out);
    }
    if (resets_) dut_ = {};
    in.pins.miso = model_.clock({out.cs_n, out.sclk, out.mosi});
    const plant::Gates gates{.uh = out.gates.uh, .ul = out.gates.ul, .vh = out.gates.vh,
                             .vl = out.gates.vl, .wh = out.gates.wh, .wl = out.gates.wl};
    if (!(gates == gates_)) {
      plant_.advance_to(double(clock_) / clock_hz_);
      plant_.set_gates(gates_ = gates);
    }
    turns_ += out.turn && !turn_;
    turn_ = out.turn;
    ++clock_;
  }

  design::Settings settings_;
  double clock_hz_;
  plant::Plant plant_;
  plant::Adc adc_;
  plant::Gates gates_;
  SinusoidalStandalone dut_;
  SpiAdcModel model_;
  std::unique_ptr<Beside> rtl_;
  std::uint64_t clock_ = 0;
  std::int64_t samples_ = 0;
  bool resets_ = false, turn_ = false;
  int turns_ = 0;
};

TEST(StandaloneSinusoidal, StartsSlowsDownStopsAndForgivesByItsPins) {
  Bench bench;
  bench.wait(0.015);
  EXPECT_TRUE(bench.gates_off());

  bench.in.controls = {.run = true, .speed = 3};
  ASSERT_TRUE(bench.wait(0.5, [&] { return bench.out.locked; }));
  bench.wait(0.3);
  EXPECT_NEAR(bench.rpm(), 3000, 15);  // 0.5 %, as in the runs' own verdict
  // The tachometer: one period per electrical turn.
  const int before = bench.turns();
  bench.wait(0.05);
  EXPECT_NEAR(bench.turns() - before, 0.05 * 3000 / 60 * bench.pole_pairs(), 1.1);

  bench.in.controls.speed = 1;
  bench.wait(0.25);
  EXPECT_NEAR(bench.rpm(), 1500, 7.5) << "half";
  EXPECT_TRUE(bench.out.locked);

  bench.in.pins.fault = true;
  bench.wait(1e-6);
  EXPECT_TRUE(bench.gates_off() && bench.out.fault);
  bench.in.pins.fault = false;
  bench.wait(0.03);
  EXPECT_TRUE(bench.gates_off() && bench.out.fault) << "latched while run is held";
  bench.in.controls.run = false;
  bench.wait(0.02);
  EXPECT_TRUE(bench.gates_off() && !bench.out.fault) << "re-armed";
  EXPECT_EQ(bench.shoot_throughs(), 0u);
  EXPECT_EQ(bench.violations(), 0) << "of the ADC's rules";
}

// From reset to the lock, backward, and over a reset in the middle of the run.
TEST(StandaloneSinusoidal, TheRtlIsItsSourceInEveryClockOfAStart) {
  Bench bench(true);
  bench.in.controls = {.run = true, .reverse = true, .speed = 3};
  ASSERT_TRUE(bench.wait(0.5, [&] { return bench.out.locked; }));
  EXPECT_LT(bench.rpm(), -100);
  EXPECT_EQ(bench.differs(), nullptr) << bench.differs();
  bench.wait(0.0101234);
  EXPECT_FALSE(bench.gates_off());
  bench.reset();
  bench.wait(1 / 12e6);
  EXPECT_TRUE(bench.gates_off());
  EXPECT_TRUE(bench.wait(0.03, [&] { return !bench.gates_off(); })) << "run is still held";
  bench.wait(0.002);
  EXPECT_EQ(bench.differs(), nullptr) << bench.differs();
  EXPECT_EQ(bench.shoot_throughs(), 0u);
}

TEST(StandaloneSinusoidal, OneWrongBitFromTheConverterIsNoticed) {
  Bench bench(true);
  bench.in.controls = {.run = true, .speed = 3};
  bench.wait(0.02, [&] { return !bench.gates_off(); });
  ASSERT_EQ(bench.differs(), nullptr);
  ASSERT_TRUE(bench.wait(1e-4, [&] { return bench.out.cs_n; }));
  ASSERT_TRUE(bench.wait(1e-4, [&] { return !bench.out.cs_n; }));
  bench.spoil = true;
  bench.wait(5e-7);  // some bits of u's channel and code
  bench.spoil = false;
  bench.wait(1e-3);
  EXPECT_NE(bench.differs(), nullptr);
}

}  // namespace
}  // namespace steplock
