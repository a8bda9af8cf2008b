// The sinusoidal drive behind each bus, generated, against its C++: every output of every clock of a life with a
// host that writes, reads, starts and stops at random, ADCs that show anything, and faults.
//
// The stimulus of rtl_test.cpp would not do: a sample takes its words over many clocks, and they have to stand
// still.  While the drive runs the registers see to that; while it is stopped the host does, and writes words
// between two samples alone.  The set-point may be written at any clock.
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <random>

#include "Vsinusoidal_apb.h"
#include "Vsinusoidal_axi.h"
#include "Vsinusoidal_spi.h"
#include "Vsinusoidal_wb.h"
#include "hls/bus/sinusoidal_apb.hpp"
#include "hls/bus/sinusoidal_axi.hpp"
#include "hls/bus/sinusoidal_spi.hpp"
#include "hls/bus/sinusoidal_wb.hpp"
#include "ports/sinusoidal_apb_ports.hpp"
#include "ports/sinusoidal_axi_ports.hpp"
#include "ports/sinusoidal_spi_ports.hpp"
#include "ports/sinusoidal_wb_ports.hpp"
#include "testbench/lockstep.hpp"
#include "tests/hls/bus_hosts.hpp"
#include "tests/hls/spi_host.hpp"

namespace steplock {
namespace {

// A transfer: `tick` gives the drive a clock.  `kLands`: clocks until a write is in its word, at most.
template <class Host>
struct Parallel : Host {
  static constexpr int kLands = 20;
  template <class In, class Out, class Tick>
  static Answer ask(const Transfer& t, In& in, const Out& out, const Tick& tick, int) {
    Answer answer;
    for (int clock = 0; clock < 100 && !answer.done; ++clock) {
      Host::show(in, t, std::min(clock, Host::kPhases - 1));
      tick();
      answer = Host::answer(out);
    }
    Host::idle(in);
    return answer;
  }
};

struct AxiRtl : Parallel<AxiHost<SinusoidalAxi, Sinusoidal>> {
  using Rtl = Vsinusoidal_axi;
  static void drive(Rtl& rtl, const Top::In& in) { ports::sinusoidal_axi::drive_ports(rtl, in); }
  static const char* differs(const Rtl& rtl, const Top::Out& out) { return ports::sinusoidal_axi::differs(rtl, out); }
};
struct WishboneRtl : Parallel<WishboneHost<SinusoidalWb, Sinusoidal>> {
  using Rtl = Vsinusoidal_wb;
  static void drive(Rtl& rtl, const Top::In& in) { ports::sinusoidal_wb::drive_ports(rtl, in); }
  static const char* differs(const Rtl& rtl, const Top::Out& out) { return ports::sinusoidal_wb::differs(rtl, out); }
};
struct ApbRtl : Parallel<ApbHost<SinusoidalApb, Sinusoidal>> {
  using Rtl = Vsinusoidal_apb;
  static void drive(Rtl& rtl, const Top::In& in) { ports::sinusoidal_apb::drive_ports(rtl, in); }
  static const char* differs(const Rtl& rtl, const Top::Out& out) { return ports::sinusoidal_apb::differs(rtl, out); }
};
struct SpiRtl {
  using Top = SinusoidalSpi;
  using Rtl = Vsinusoidal_spi;
  static constexpr int kLands = 450;  // its last data bit is the 48th
  static void drive(Rtl& rtl, const Top::In& in) { ports::sinusoidal_spi::drive_ports(rtl, in); }
  static const char* differs(const Rtl& rtl, const Top::Out& out) { return ports::sinusoidal_spi::differs(rtl, out); }
  // `draw`, below 100: the ratio of the clocks is anything between 8 and 9.
  template <class Tick>
  static Answer ask(const Transfer& t, Top::In& in, const Top::Out& out, const Tick& tick, int draw) {
    const auto line = [&](const Spi::Pins& pins) {
      in.spi = pins;
      tick();
      return out.spi.miso;
    };
    const double half = 4 + 0.005 * draw;
    const SpiAnswer answer = t.write ? spi_write(line, half, t.address, t.data) : spi_read(line, half, t.address);
    return {.done = answer.status == 0x5a || answer.status == 0x5e, .error = answer.status == 0x5e, .data = answer.data};
  }
};

constexpr int kPeriod = 1200, kSample = SinusoidalLoop::kClocks + 10;  // clocks; of a sample at most

// A configuration under which it starts at once, regulates and locks on anything.
SinusoidalConfig lenient_config() {
  SinusoidalConfig w;
  w.bridge = {.period = kPeriod, .minimum = 12, .dead_time = 12, .dead_time_loss = 192, .compensate = true, .reciprocal = 9321};
  w.estimator = {.decay = 3113, .gain = 3686, .k_theta = 3277, .k_e = 541, .k_speed = 5894};
  w.speed = {.target = 1 << 20, .slew = 30000, .filter = 983, .k_p = 700, .k_i = 530, .limit = 12288, .emf_high = 32767};
  w.control = {.set_gamma = -300, .k_p = 1092, .k_i = 831, .inductance = 892, .emf = 1425, .limit = 18919};
  w.sequence = {.arbitrary = true, .hold_voltage = 2000, .pattern = 3, .lock = 3, .give_up = 100, .brake = 2, .retry_delay = 2,
                .retries = 3};
  w.fault = {.over_current = 30000};
  return w;
}

// `sabotage`: from that clock on the RTL sees another current.
template <class Bus>
class Life {
 public:
  explicit Life(std::uint64_t seed, std::int64_t sabotage = -1) : random_(seed), sabotage_(sabotage) {}

  void live(std::int64_t clocks) {
    ask({.write = true, .address = kPwm, .data = healthy().at(kPwm)});
    while (since_sample_ >= kNever && differs == nullptr) tick();
    write_healthy_config();
    ask({.write = true, .address = kControl, .data = 3});
    while (clock_ < clocks && differs == nullptr) act();
  }
  const char* differs = nullptr;
  int moves = 0, faults = 0, locks = 0, targets = 0, telemetry = 0, lost = 0;

 private:
  static constexpr int kNever = 1 << 20;  // clocks since what has not been yet

  bool chance(int percent) { return int(random_() % 100) < percent; }
  std::uint32_t draw() { return std::uint32_t(random_()); }

  void act() {
    if (chance(60)) {
      for (int idle = int(draw() % 400); idle > 0; --idle) tick();
    }
    const bool runs = !(out_.gates == Gates{});
    switch (draw() % 10) {
      case 0:
      case 1:
      case 2:
        targets += runs;
        return ask({.write = true, .address = address_of(index_of("SPEED_TARGET")), .data = draw() >> draw() % 12,
                    .strobes = chance(80) ? 15 : int(draw() % 16)});
      case 3: return ask({.write = true, .address = address_of(index_of("SNAPSHOT")), .data = 0});
      case 4: {  // a register of the telemetry
        ask({.address = address_of(index_of("TELEMETRY_SPEED") + int(draw() % Sinusoidal::kCopies))});
        telemetry += answer_.data != 0;
        return;
      }
      case 5: return ask({.address = int(draw() % 256)});
      case 6:  // now and then a stop, by braking or not, or another direction; where there is nothing to stop, a start
        if (!chance(runs ? 4 : 100)) return;
        if (!runs && clock_ - started_ < 30 * kPeriod) return;  // it calibrates
        if (runs) return ask({.write = true, .address = kControl, .data = (chance(80) ? 1u : 0u) | (draw() & 14)});
        ask({.write = true, .address = kControl, .data = 1});
        ask({.write = true, .address = kFault, .data = 3});
        started_ = clock_;
        return ask({.write = true, .address = kControl, .data = 3 | (draw() & 12)});
      case 7: return ask({.write = true, .address = address_of(0x05 + int(draw() % 4)), .data = draw()});  // FAULT and on
      case 8: {
        constexpr int beside[] = {0x20, 0x24, 0x28, 0x28};  // lock, watchdog, heartbeat
        return ask({.write = true, .address = beside[draw() % 4], .data = chance(70) ? kLockKey : draw()});
      }
      default: {  // a word, between two samples; its first register would take its period away
        if (!chance(2)) return;
        started_ = clock_;
        const int address = 0x84 + 4 * int(draw() % 31);
        if (chance(60)) ask({.write = true, .address = kControl, .data = 1});  // else it is refused
        ask_between_samples({.write = true, .address = address, .data = draw()});
        if (chance(30)) return;
        write_healthy_config();
        return ask({.write = true, .address = kControl, .data = 3});
      }
    }
  }
  static std::map<int, std::uint32_t> healthy() {
    std::map<int, std::uint32_t> values;
    const SinusoidalConfig config = lenient_config();
    const auto place = [&](const auto& row) {
      using Word = typename std::remove_cvref_t<decltype(row)>::Word;
      values[row.address] |= std::uint32_t(bits_of(Word::of(config)).raw()) << row.lsb;
    };
    std::apply([&](const auto&... row) { (place(row), ...); }, kSinusoidalWordRows);
    return values;
  }

  void ask(const Transfer& t) {
    answer_ = Bus::ask(t, in_, out_, [this] { tick(); }, int(draw() % 100));
    lost += !answer_.done;
  }
  // A word of a stopped drive lands between two samples.
  void ask_between_samples(const Transfer& t) {
    while (since_codes_ < kSample || since_sample_ > kPeriod - Bus::kLands) tick();
    ask(t);
  }
  void write_healthy_config() {
    ask({.write = true, .address = kLock, .data = kLockKey});
    for (const auto& [at, value] : healthy()) ask_between_samples({.write = true, .address = at, .data = value});
  }

  void tick() {
    if (out_.sample) since_sample_ = 0, late_ = 1 + int(draw() % 100);
    const bool due = since_sample_ == late_;
    if (due) since_codes_ = 0;
    const bool early = since_codes_ > 0 && since_codes_ < SinusoidalLoop::kClocks && draw() % 256 == 0;  // counts for nothing
    in_.codes = {.valid = due || early,
                 .u = int(draw() % 801) - 400, .v = int(draw() % 801) - 400, .dc = 2500 + int(draw() % 400)};
    in_.fault = in_.fault ? draw() % 64 != 0 : draw() % 65536 == 0;

    auto beside = in_;
    if (sabotage_ >= 0 && clock_ >= sabotage_) beside.codes.u = beside.codes.u ^ Int<12>(256);
    Bus::drive(rtl_.ports(), beside);
    rtl_.settle();
    const bool locked = out_.locked, fault = out_.fault;
    const Gates gates = out_.gates;
    out_ = cpp_.tick(in_);
    if (differs == nullptr) differs = Bus::differs(rtl_.ports(), out_);
    rtl_.edge();
    moves += !(out_.gates == gates);
    locks += out_.locked && !locked;
    faults += out_.fault && !fault;
    ++clock_, ++since_sample_, ++since_codes_;
  }

  std::mt19937_64 random_;
  std::int64_t sabotage_, clock_ = 0, started_ = 0;
  Lockstep<typename Bus::Rtl> rtl_;
  typename Bus::Top cpp_;
  typename Bus::Top::In in_;
  typename Bus::Top::Out out_;
  Answer answer_;
  int since_sample_ = kNever, since_codes_ = kNever, late_ = 1;
};

template <class Bus>
struct SinusoidalBusRtl : testing::Test {};
using Buses = testing::Types<AxiRtl, WishboneRtl, ApbRtl, SpiRtl>;
TYPED_TEST_SUITE(SinusoidalBusRtl, Buses);

TYPED_TEST(SinusoidalBusRtl, EqualsItsCppForTwoMillionClocks) {
  int moves = 0, locks = 0, faults = 0, targets = 0, telemetry = 0;
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    Life<TypeParam> life(seed);
    life.live(500'000);
    EXPECT_EQ(life.differs, nullptr) << life.differs << ", seed " << seed;
    EXPECT_EQ(life.lost, 0) << "answers, seed " << seed;
    moves += life.moves, locks += life.locks, faults += life.faults, targets += life.targets, telemetry += life.telemetry;
  }
  // It has been a life.
  EXPECT_GT(moves, 2000);
  EXPECT_GE(locks, 4);
  EXPECT_GT(faults, 5);
  EXPECT_GT(targets, 100);
  EXPECT_GT(telemetry, 100);
}

TYPED_TEST(SinusoidalBusRtl, AWrongBitOfACurrentIsNoticed) {
  Life<TypeParam> life(1, 60'000);
  life.live(500'000);
  EXPECT_NE(life.differs, nullptr);
}

}  // namespace
}  // namespace steplock
