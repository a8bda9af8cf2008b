// What the pins of a sinusoidal drive without a host do, and when its ADC's codes act; that it turns
// a motor is standalone_sinusoidal_test's claim.
#include "hls/sinusoidal/sinusoidal_standalone.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "tests/hls/spi_adc_model.hpp"

namespace steplock {
namespace {

constexpr int kPeriod = 700;
constexpr int kLook = 256 * kPeriod;  // clocks between two looks at the pins
const SpiAdcConfig kFast{.half = 1, .quiet = 8, .u = 0, .v = 1, .dc = 2};

// A pattern that lasts.
SinusoidalConfig lasting_config(int period = kPeriod) {
  SinusoidalConfig w;
  w.bridge = {.period = period, .minimum = 12, .dead_time = 12, .dead_time_loss = 192, .compensate = true,
              .reciprocal = (1 << 25) / (3 * period)};
  w.estimator = {.decay = 3113, .gain = 3686, .k_theta = 3277, .k_e = 541, .k_speed = 5894};
  w.speed = {.target = 1 << 22, .slew = 32767, .filter = 983, .k_p = 70, .k_i = 53, .limit = 12288,
             .lock = 500, .slow = 100, .stop = 1000, .emf_low = 3277, .emf_high = 20480};
  w.control = {.k_p = 109, .k_i = 83, .inductance = 89, .emf = 142, .limit = 18919};
  w.sequence = {.hold_voltage = 2000, .pattern = (1 << 20) - 1, .lock = 400,
                .give_up = (1 << 20) - 1, .brake = 10, .retry_delay = 10, .retries = 1};
  w.fault = {.over_current = 30000, .lost_samples = 3};
  return w;
}

class Bench {
 public:
  SinusoidalStandalone::In in{.pins = {}, .controls = {}, .adc = kFast, .config = lasting_config()};
  SinusoidalStandalone::Out out;
  SpiAdcModel adc;
  int u = 0;  // code of phase u's current
  long clock = 0;
  bool broken = false;  // the ADC's line

  Bench() {
    adc.input = [this](int channel, long) { return channel == 2 ? 2700 : 2048 + (channel == 0 ? u : 0); };
    adc.config = in.adc;
  }
  Bench(const Bench&) = delete;

  void tick() {
    out = dut_.tick(in);
    in.pins.miso = adc.clock({out.cs_n, out.sclk, out.mosi}) && !broken;
    ++clock;
    const Gates& g = out.gates;
    ASSERT_FALSE((g.uh && g.ul) || (g.vh && g.vl) || (g.wh && g.wl)) << clock;
  }
  void wait(int clocks) {
    for (int i = 0; i < clocks; ++i) tick();
  }
  bool off() const { return out.gates == Gates{}; }
  // Clocks until the first gate is on, or `most`.
  int until_gate(int most) {
    return until(most, [&] { return !off(); });
  }
  template <class Done>
  int until(int most, Done done) {
    for (int n = 1; n <= most; ++n) {
      tick();
      if (done()) return n;
    }
    return most;
  }
  void run() {
    in.controls.run = true;
    ASSERT_LT(until_gate(2 * kLook), 2 * kLook);
  }

 private:
  SinusoidalStandalone dut_;
};

TEST(SinusoidalStandalone, RunStartsAtTheNextLookAtThePins) {
  Bench bench;
  bench.wait(1000);
  bench.in.controls.run = true;
  const int clocks = bench.until_gate(2 * kLook);
  EXPECT_GT(clocks, kLook - 1000);
  EXPECT_LT(clocks, kLook + 20 * kPeriod) << "16 samples of the offsets, and a few";
}

TEST(SinusoidalStandalone, NothingStartsWithoutRun) {
  Bench bench;
  bench.in.controls = {.reverse = true, .speed = 3};
  EXPECT_EQ(bench.until_gate(3 * kLook), 3 * kLook);
}

TEST(SinusoidalStandalone, AClosingSwitchThatBouncesStartsOnce) {
  Bench bench;
  // Open between the bounces: whenever it is, the drive is idle.
  for (int i = 0; i < 200; ++i) {
    bench.in.controls.run = i % 2 == 0;
    bench.wait(500);
  }
  bench.in.controls.run = true;
  EXPECT_LT(bench.until_gate(2 * kLook), 2 * kLook);
}

// Two clocks of the synchroniser, one register, one clock of the gate guard.
TEST(SinusoidalStandalone, TheEndOfRunCountsAtOnce) {
  for (int start = 0; start < 8; ++start) {
    Bench bench;
    bench.run();
    bench.wait(start * 97);
    bench.in.controls.run = false;
    bench.wait(4);
    for (int i = 0; i < kLook + 1000; ++i) {
      bench.tick();
      ASSERT_TRUE(bench.off()) << start << " + " << i;
    }
  }
}

TEST(SinusoidalStandalone, AFaultStopsInThreeClocksAndStaysWhileRunIsHeld) {
  Bench bench;
  bench.run();
  bench.in.pins.fault = true;
  bench.wait(4);
  EXPECT_TRUE(bench.off());
  bench.wait(3);
  EXPECT_TRUE(bench.out.fault);
  bench.in.pins.fault = false;
  EXPECT_EQ(bench.until_gate(3 * kLook), 3 * kLook);
  EXPECT_TRUE(bench.out.fault);
}

TEST(SinusoidalStandalone, TakingRunAwayRearmsAsSoonAsTheCauseIsGone) {
  Bench bench;
  bench.run();
  bench.in.pins.fault = true;
  bench.wait(100);
  bench.in.controls.run = false;
  bench.wait(3 * kLook);
  EXPECT_TRUE(bench.out.fault) << "the pin is still up";
  bench.in.pins.fault = false;
  bench.wait(kLook + 10);
  EXPECT_FALSE(bench.out.fault);
  bench.run();
}

TEST(SinusoidalStandalone, AConverterThatFallsSilentIsAFaultWithinItsSamples) {
  Bench bench;
  bench.run();
  bench.broken = true;
  EXPECT_LT(bench.until(10 * kPeriod, [&] { return bench.out.fault; }), 5 * kPeriod);
  bench.wait(2);
  EXPECT_TRUE(bench.off());
}

// Pulses are centred, so that a period begins in the middle between two of them, where all low sides
// conduct.  The requests show in the gates that end: the others wait for the dead time.
TEST(SinusoidalStandalone, UIsHeldWhereThePeriodBeginsAndTheOthersFramesLater) {
  Bench bench;
  bench.run();
  bench.wait(4 * kPeriod);
  const auto fell = [&](bool Gates::*gate) {
    bool was = false;
    bench.until(2 * kPeriod, [&] {
      const bool ends = was && !(bench.out.gates.*gate);
      was = bench.out.gates.*gate;
      return ends;
    });
    return bench.clock;
  };
  const long off = fell(&Gates::wh), on = fell(&Gates::wl);  // leg w alone is pulsed
  EXPECT_LE(std::abs(bench.adc.held[0] - (off + on) / 2), 2);
  EXPECT_EQ(bench.adc.held[1] - bench.adc.held[0], 33 + 8);
  EXPECT_EQ(bench.adc.held[2] - bench.adc.held[1], 33 + 8);
  EXPECT_EQ(bench.adc.violations, 0);
}

// The drive and the ADC's front end by themselves, as a host would have them.
struct Wires {
  SpiAdc front;
  SinusoidalTop drive;
  SpiAdc::In spi;
  SinusoidalTop::In in;
  SinusoidalTop::Out out;
  SpiAdcModel adc;

  Wires(const SpiAdcConfig& adc_config, const SinusoidalConfig& config) {
    spi.config = adc.config = adc_config;
    in.config = config;
    in.command.configured = true;
    adc.input = [](int channel, long) { return channel == 2 ? 2700 : 2048; };
  }
  void tick() {
    spi.sample = out.sample;
    const auto pins = front.tick(spi);
    spi.miso = adc.clock({pins.cs_n, pins.sclk, pins.mosi});
    in.codes = pins.codes;
    out = drive.tick(in);
  }
  template <class Done>
  int until(Done done) {
    int n = 0;
    do {
      tick();
      ++n;
    } while (!done() && n < 100'000);
    return n;
  }
};

TEST(SinusoidalStandalone, CodesOnTimesAndTheEndOfASampleComeWhenTheHeaderSays) {
  for (const int half : {1, 2, 5}) {
    for (const int quiet : {4, 8, 30}) {
      Wires wires({.half = half, .quiet = quiet, .u = 0, .v = 1, .dc = 2}, lasting_config(1400));
      for (int n = 0; n < 2; ++n) wires.until([&] { return wires.out.sample; });  // it is awake
      const int codes = wires.until([&] { return wires.in.codes.valid; });
      EXPECT_EQ(codes, 98 * half + 2 * quiet + 5) << half << ' ' << quiet;
      const int on = wires.until([&] { return wires.out.on_u != 0; });
      EXPECT_EQ(on, 229);
      const int done = wires.until([&] { return wires.out.done; });
      EXPECT_EQ(codes + on + done, SinusoidalStandalone::clocks_of_a_sample(half, quiet));
    }
  }
  // At 24 MHz, as docs/blocks/sinusoidal_standalone.md has it.
  EXPECT_EQ(SinusoidalStandalone::clocks_of_a_sample(1, 8), 595);
}

// The 12 clocks that a leg loses by dead time are made up for by the sign of its current: what a current is in
// one period shows in the width of a pulse in one of the next.
int periods_until_it_acts(const SpiAdcConfig& adc_config, int period) {
  Bench bench;
  bench.in.config = lasting_config(period);
  bench.in.adc = bench.adc.config = adc_config;
  bench.in.controls.run = true;
  bench.until_gate(300 * period);
  std::vector<int> widths;  // clocks of the high side, by the period in whose begin u is held
  constexpr std::size_t kNew = 8;  // the period in which all three are new
  while (widths.size() < kNew + 5) {
    bench.tick();
    if (bench.adc.held[0] == bench.adc.now()) widths.push_back(0);
    if (widths.size() == kNew && bench.adc.held[2] == bench.adc.now()) {
      bench.adc.input = [](int channel, long) { return channel == 2 ? 2700 : 1548; };
    }
    if (!widths.empty()) widths.back() += bench.out.gates.wh;
  }
  for (std::size_t i = kNew; i < widths.size() - 1; ++i) {
    if (widths[i] != widths[kNew - 1]) return int(i - kNew);
  }
  return -1;
}

TEST(SinusoidalStandalone, CodesActInTheNextPeriodAndLateOnesInTheOneAfter) {
  EXPECT_EQ(periods_until_it_acts(kFast, kPeriod), 1);
  // 98 half: 1001 clocks of 1100 to the codes, and more than 99 to on-times.
  EXPECT_EQ(periods_until_it_acts({.half = 10, .quiet = 8, .u = 0, .v = 1, .dc = 2}, 1100), 2);
}

// Clocks in which the bare drive at `speed` and one whose host asks for `target` show other gates; after the
// second look `then` and half of `whole`, which the host says `late` clocks after it.
int differing(int speed, int whole, int target, bool reverse = false, int then = -1, int late = 0) {
  Bench bare;
  bare.in.config.sequence.arbitrary = true;
  bare.in.config.speed.target = whole;
  Wires host(kFast, bare.in.config);
  host.in.config.speed.target = target;
  host.in.command.reverse = reverse;
  int clocks = 0, differ = 0;
  const int look = 2 * kLook + 10;  // the first one is in clock 3
  for (int i = 0; i < (then < 0 ? kLook : 2 * kLook) + 200 * kPeriod; ++i) {
    if (i == kLook + 54'321 && then >= 0) bare.in.controls.speed = then;
    if (i == look + late && then >= 0) host.in.config.speed.target = whole / 2;
    if (i == 1000) bare.in.controls = {.run = true, .reverse = reverse, .speed = speed};
    bare.tick();
    host.in.command.run = i > kLook + 20;  // after the look, and before the codes of that period
    host.tick();
    clocks += !bare.off();
    differ += !(bare.out.gates == host.out.gates);
  }
  EXPECT_GT(clocks, 100 * kPeriod);
  return differ;
}

TEST(SinusoidalStandalone, IsTheDriveToldAQuarterToTheWholeOfItsSpeed) {
  const int whole = (1 << 22) + 3;
  EXPECT_EQ(differing(0, whole, whole / 4), 0);
  EXPECT_EQ(differing(1, whole, whole / 2), 0);
  EXPECT_EQ(differing(2, whole, whole / 2 + whole / 4, true), 0);
  EXPECT_EQ(differing(3, whole, whole), 0);
  EXPECT_GT(differing(3, whole, whole / 2), 0) << "the control";
}

// A sample reads the target more than once.
TEST(SinusoidalStandalone, ANewSpeedIsTakenWhereAPeriodBegins) {
  const int whole = 1 << 22;
  EXPECT_EQ(differing(3, whole, whole, false, 1), 0);
  EXPECT_GT(differing(3, whole, whole, false, 1, kPeriod), 0) << "the control";
}

TEST(SinusoidalStandalone, AsksForALittleMoreThanTheLockSpeedAtLeast) {
  const int lock = 500 << 10;
  EXPECT_EQ(differing(0, 2 * lock, lock + lock / 16 + lock / 32), 0);
}

}  // namespace
}  // namespace steplock
