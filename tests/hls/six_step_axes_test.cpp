// One to four drives on one bus, each held against a drive of its own in every clock: whatever the others are
// told, and whatever happens to them.
#include "hls/bus/six_step_axes.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <random>

#include "hls/bus/six_step_axi.hpp"
#include "tests/hls/map_model.hpp"

namespace steplock {
namespace {

struct Response {
  bool error = false;
  std::uint32_t data = 0;
};

// The axes on their bus, and lone drives that see what is meant for them and nothing else.
template <int Axes>
class Bench {
 public:
  // One clock, with `axi` meant for axis `axis`, or none of them.
  void clock(int axis = -1, const AxiLite::In& axi = {}) {
    in.axi = axi;
    in.clock_khz = kClockKhz;
    out = axes_.tick(in);
    for (int k = 0; k < Axes; ++k) {
      const std::size_t n = std::size_t(k);
      SixStepAxi::In own{.pins = in.pins[n], .clock_khz = kClockKhz, .axi = {}};
      if (k == axis || (sabotage && axis >= 0)) {
        own.axi = axi;
        own.axi.awaddr = wrap<UInt<8>>(axi.awaddr);
        own.axi.araddr = wrap<UInt<8>>(axi.araddr);
      }
      const auto alone = alone_[n].tick(own);
      const auto& here = out.axis[n];
      differences += !(here.gates == alone.gates) || here.interrupt != alone.interrupt ||
                     here.locked != alone.locked || here.fault != alone.fault;
      if (k == axis) answer_ = alone.axi;
      moves[n] += !(alone.gates == Gates{});
      faults[n] += alone.fault;
    }
  }

  Response write(int address, std::uint32_t data) {
    AxiLite::In axi{.awvalid = true, .awaddr = address, .wvalid = true, .wdata = data, .wstrb = 15};
    Response r;
    for (bool ready = false; !ready;) clock(address >> 8, axi), ready = out.axi.awready;
    axi = {.bready = true};
    for (bool valid = false; !valid;) clock(address >> 8, axi), valid = out.axi.bvalid;
    r.error = out.axi.bresp != 0;
    if (address >> 8 < Axes) differences += out.axi.bresp != answer_.bresp;
    return r;
  }
  Response read(int address) {
    AxiLite::In axi{.arvalid = true, .araddr = address};
    for (bool ready = false; !ready;) clock(address >> 8, axi), ready = out.axi.arready;
    axi = {.rready = true};
    for (bool valid = false; !valid;) clock(address >> 8, axi), valid = out.axi.rvalid;
    const auto data = std::uint32_t(out.axi.rdata.raw());
    if (address >> 8 < Axes) {
      // A lone drive says that it is the only one.
      constexpr Field kAxes = field("CAPABILITY", "axes");
      const bool counts = (address & 0xff) == kAxes.address;
      const std::uint32_t more = counts ? std::uint32_t(Axes - 1) << kAxes.lsb : 0;
      differences += out.axi.rresp != answer_.rresp || data != answer_.rdata.raw() + more;
    }
    return {out.axi.rresp != 0, data};
  }

  // A reset pattern that lasts, half of the time on; `period` differs, so that no two move alike.
  void start(int axis, int period) {
    const int base = 0x100 * axis;
    write(base + kPwm, 1u << 24 | unsigned(period));
    write(base + address_of(index_of("START_ALIGN")), 4095u << 16);
    write(base + address_of(index_of("START_DUTY")), 0x4000);
    write(base + address_of(index_of("SPEED_TARGET")), 0x1000);
    write(base + address_of(index_of("SPEED_DUTY")), 0x8000u << 16);
    write(base + address_of(index_of("SPEED_DUTY_SLEW")), 0xfff);
    write(base + kControl, 3);
  }

  typename SixStepAxes<Axes>::In in;
  typename SixStepAxes<Axes>::Out out;
  bool sabotage = false;
  int differences = 0;
  std::array<int, Axes> moves{}, faults{};

 private:
  SixStepAxes<Axes> axes_;
  std::array<SixStepAxi, Axes> alone_;
  AxiAnswers answer_;
};

template <int Axes>
Bench<Axes> random_life(std::uint64_t seed, bool sabotage = false) {
  std::mt19937_64 random(seed);
  const auto chance = [&](int percent) { return int(random() % 100) < percent; };
  Bench<Axes> b;
  for (int k = 0; k < Axes; ++k) b.start(k, 150 + 40 * k);
  b.sabotage = sabotage;
  for (int i = 0; i < 4000; ++i) {
    for (auto& pins : b.in.pins) {
      if (chance(20)) pins.comparator_u = !pins.comparator_u;
      if (chance(20)) pins.comparator_v = !pins.comparator_v;
      if (chance(5)) pins.limit = !pins.limit;
      pins.fault = chance(1);
    }
    const int address = 0x100 * int(random() % Axes) + 4 * int(random() % 64);
    if (chance(40)) {
      b.read(address);
    } else if (chance(30)) {
      const int base = address & ~0xff;
      b.write(base + kFault, 3);
      b.write(base + kControl, chance(50) ? 3 : 1);
    } else if (chance(50)) {
      b.write(address, std::uint32_t(random()));
    }
    if (i % 400 == 399) {
      const int axis = int(random() % Axes);
      for (auto& pins : b.in.pins) pins.fault = false;
      b.write(0x100 * axis + kControl, 1);
      b.write(0x100 * axis + kFault, 3);
      b.start(axis, 100 + int(random() % 100));
    }
    for (int idle = int(random() % 20); idle > 0; --idle) b.clock();
  }
  return b;
}

template <int Axes>
void lives_undisturbed() {
  const auto b = random_life<Axes>(Axes);
  EXPECT_EQ(b.differences, 0) << Axes;
  for (const int moves : b.moves) EXPECT_GT(moves, 500);
  for (const int faults : b.faults) EXPECT_GT(faults, 500);
}
TEST(SixStepAxes, EachAxisIsALoneDriveInEveryClockWhateverTheOthersDo) {
  lives_undisturbed<1>();
  lives_undisturbed<2>();
  lives_undisturbed<3>();
  lives_undisturbed<4>();
}

TEST(SixStepAxes, AWriteThatReachedTwoAxesWouldBeNoticed) {
  EXPECT_GT(random_life<2>(2, true).differences, 100);
}

TEST(SixStepAxes, AFaultPinAndASilentHostStopOneAxisAlone) {
  Bench<2> b;
  EXPECT_FALSE(b.write(0x100 + kLock, kLockKey).error);
  EXPECT_FALSE(b.write(0x100 + address_of(index_of("WATCHDOG")), 100).error);
  for (int k = 0; k < 2; ++k) {
    EXPECT_FALSE(b.write(0x100 * k + address_of(index_of("INTERRUPT_ENABLE")), 3).error);
    b.start(k, 200);
  }
  b.moves = {};
  for (int i = 0; i < 5000; ++i) b.clock();
  EXPECT_GT(b.moves[0] * b.moves[1], 0);
  for (int i = 0; i < 20'000; ++i) b.clock();  // 100 ticks of 200 clocks
  EXPECT_TRUE(b.out.axis[1].interrupt) << "its watchdog";
  EXPECT_FALSE(b.out.axis[0].interrupt);
  b.moves = {};
  for (int i = 0; i < 2000; ++i) b.clock();
  EXPECT_GT(b.moves[0], 0);
  EXPECT_EQ(b.moves[1], 0);

  b.in.pins[0].fault = true;
  for (int i = 0; i < 10; ++i) b.clock();
  EXPECT_TRUE(b.out.axis[0].fault && b.out.axis[0].interrupt);
  EXPECT_FALSE(b.out.axis[1].fault);
  EXPECT_EQ(b.read(kFault).data, 0x11u) << "fault pin";
  EXPECT_EQ(b.read(0x100 + kFault).data, 0x2u) << "watchdog";
  EXPECT_EQ(b.differences, 0);
}

TEST(SixStepAxes, EachAxisSaysHowManyThereAre) {
  constexpr Field kAxes = field("CAPABILITY", "axes");
  Bench<3> b;
  for (int k = 0; k < 3; ++k) {
    const auto capability = b.read(0x100 * k + kAxes.address).data;
    EXPECT_EQ(capability >> kAxes.lsb & 7, 3u) << k;
    EXPECT_EQ(capability & 0xffff, reset_of("CAPABILITY") & 0xffff) << k;
    EXPECT_EQ(b.read(0x100 * k).data, kMapId) << "nothing of it in other registers";
  }
  EXPECT_EQ(b.differences, 0);
}

TEST(SixStepAxes, BehindTheLastAxisAreHoles) {
  Bench<3> b;
  for (int page = 0; page < 16; ++page) {
    const auto id = b.read(0x100 * page);
    EXPECT_EQ(id.error, page >= 3) << page;
    EXPECT_EQ(id.data, page < 3 ? kMapId : 0) << page;
    EXPECT_EQ(b.write(0x100 * page + kControl, 1).error, page >= 3) << page;
  }
  EXPECT_FALSE(b.read(0).error) << "a hole before does not stay";
  EXPECT_EQ(b.differences, 0);
}

}  // namespace
}  // namespace steplock
