// What the C driver answers to arguments that cannot be, before it writes anything; and its names.
#include <gtest/gtest.h>

#include <functional>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "hls/sinusoidal/config.hpp"
#include "hls/six_step/config.hpp"
#include "rtl/host/steplock.h"
#include "rtl/host/steplock_sinusoidal.h"
#include "rtl/host/steplock_spi.h"

namespace steplock {
namespace {

// Registers that keep what is written, of a drive that is stopped.
class Registers {
 public:
  explicit Registers(unsigned kind) {
    values_[STEPLOCK_ID] = STEPLOCK_ID_RESET;
    values_[STEPLOCK_VERSION] = STEPLOCK_VERSION_RESET;
    values_[STEPLOCK_CAPABILITY] = kind << STEPLOCK_CAPABILITY_KIND_LSB;
    values_[STEPLOCK_STATUS] = STEPLOCK_STATUS_STOPPED_MASK;
  }
  steplock_bus bus() {
    return {.write = [](void* self, std::uint32_t offset, std::uint32_t value) {
              static_cast<Registers*>(self)->write(offset, value);
              return 0;
            },
            .read = [](void* self, std::uint32_t offset, std::uint32_t* value) {
              auto& registers = *static_cast<Registers*>(self);
              registers.interrupted();
              return *value = offset == STEPLOCK_FAULT ? registers.fault : registers.values_[offset], 0;
            },
            .context = this};
  }
  // Before that many accesses more, once, something else has the bus.
  void interrupt(int accesses, std::function<void()> what) {
    left_ = accesses;
    what_ = std::move(what);
  }
  std::uint32_t at(std::uint32_t offset) { return values_[offset]; }
  int writes = 0;
  std::uint32_t fault = 0;  // what FAULT reads

 private:
  void interrupted() {
    if (what_ && left_-- == 0) std::exchange(what_, nullptr)();
  }
  void write(std::uint32_t offset, std::uint32_t value) {
    interrupted();
    ++writes;
    if (offset == STEPLOCK_CONTROL_SET) {
      values_[STEPLOCK_CONTROL] |= value;
    } else if (offset == STEPLOCK_CONTROL_CLEAR) {
      values_[STEPLOCK_CONTROL] &= ~value;
    } else {
      values_[offset] = value;
    }
  }

  std::map<std::uint32_t, std::uint32_t> values_;
  int left_ = 0;
  std::function<void()> what_;
};

// Wherever the interrupt comes.
TEST(HostAnswers, AStopFromAnInterruptIsNotUndoneByAReversal) {
  for (const int reverse : {0, 1}) {
    for (int access = 0; access < 4; ++access) {
      Registers registers(STEPLOCK_SIX_STEP);
      const steplock_bus bus = registers.bus();
      ASSERT_EQ(steplock_start(&bus, 1 - reverse), STEPLOCK_OK);
      ASSERT_TRUE(registers.at(STEPLOCK_CONTROL) & STEPLOCK_CONTROL_RUN_MASK);
      bool stopped = false;
      registers.interrupt(access, [&] { stopped = steplock_stop(&bus, 1) == STEPLOCK_OK; });
      EXPECT_EQ(steplock_reverse(&bus, reverse), STEPLOCK_OK);
      EXPECT_TRUE(stopped || access > 0);
      EXPECT_NE((registers.at(STEPLOCK_CONTROL) & STEPLOCK_CONTROL_RUN_MASK) != 0, stopped) << access;
      EXPECT_EQ((registers.at(STEPLOCK_CONTROL) & STEPLOCK_CONTROL_REVERSE_MASK) != 0, reverse == 1);
      registers.interrupt(0, nullptr);
      EXPECT_EQ(steplock_stop(&bus, 0), STEPLOCK_OK);
      EXPECT_EQ(registers.at(STEPLOCK_CONTROL), reverse ? STEPLOCK_CONTROL_REVERSE_MASK : 0u) << "coasts";
    }
  }
}

// A fault that stays: an over-current is gone soon, what else there is lasts.  The number is the same one of both drives.
TEST(HostAnswers, AFaultThatStaysIsToTryAgainAfterAnOverCurrentAlone) {
  static_assert(int(STEPLOCK_REASON_OVER_CURRENT) == int(STEPLOCK_SINUSOIDAL_REASON_OVER_CURRENT));
  for (const unsigned kind : {unsigned(STEPLOCK_SIX_STEP), unsigned(STEPLOCK_SINUSOIDAL)}) {
    for (unsigned reason = 0; reason < 10; ++reason) {
      Registers registers(kind);
      registers.fault = STEPLOCK_FAULT_DRIVE_MASK | reason << STEPLOCK_FAULT_REASON_LSB;
      const steplock_bus bus = registers.bus();
      EXPECT_EQ(steplock_clear_fault(&bus),
                reason == STEPLOCK_REASON_OVER_CURRENT ? STEPLOCK_TRY_AGAIN : STEPLOCK_FAULT_LATCHED) << reason;
      registers.fault &= ~STEPLOCK_FAULT_DRIVE_MASK;
      EXPECT_EQ(steplock_clear_fault(&bus), STEPLOCK_OK);
    }
  }
}

TEST(HostAnswers, ACoreWithoutARegisterThatTheDriverWritesIsNoDrive) {
  Registers registers(STEPLOCK_SIX_STEP);
  const steplock_bus bus = registers.bus();
  bus.write(bus.context, STEPLOCK_VERSION, STEPLOCK_VERSION_RESET - (1u << STEPLOCK_VERSION_MINOR_LSB));
  EXPECT_EQ(steplock_init(&bus, nullptr, 0), STEPLOCK_NO_DRIVE);
  bus.write(bus.context, STEPLOCK_VERSION, STEPLOCK_VERSION_RESET + (1u << STEPLOCK_VERSION_MINOR_LSB));
  EXPECT_EQ(steplock_init(&bus, nullptr, 0), STEPLOCK_OK) << "a newer one has more";
}

TEST(HostAnswers, AWatchdogThatItsRegisterDoesNotHoldLeavesTheOldOne) {
  Registers registers(STEPLOCK_SIX_STEP);
  const steplock_bus bus = registers.bus();
  ASSERT_EQ(steplock_set_watchdog(&bus, 4095), STEPLOCK_OK);
  registers.writes = 0;
  EXPECT_EQ(steplock_set_watchdog(&bus, 4096), STEPLOCK_REFUSED);
  EXPECT_EQ(steplock_set_watchdog(&bus, 0xffffffff), STEPLOCK_REFUSED);
  EXPECT_EQ(registers.writes, 0);
  EXPECT_EQ(registers.at(STEPLOCK_WATCHDOG), 4095u);
}

// Each drive's SPEED_TARGET has its own width.
TEST(HostAnswers, ASpeedThatTheDriveDoesNotHoldIsRefusedAndNotCutToAnother) {
  const std::pair<unsigned, std::uint32_t> drives[] = {
      {STEPLOCK_SIX_STEP, STEPLOCK_SPEED_TARGET_TARGET_MASK},
      {STEPLOCK_SINUSOIDAL, STEPLOCK_SINUSOIDAL_SPEED_TARGET_TARGET_MASK}};
  for (const auto& [kind, most] : drives) {
    Registers registers(kind);
    const steplock_bus bus = registers.bus();
    EXPECT_EQ(steplock_set_speed(&bus, most), STEPLOCK_OK) << kind;
    registers.writes = 0;
    EXPECT_EQ(steplock_set_speed(&bus, most + 1), STEPLOCK_REFUSED) << kind;
    EXPECT_EQ(steplock_set_speed(&bus, STEPLOCK_NO_SPEED), STEPLOCK_REFUSED) << kind;
    EXPECT_EQ(registers.writes, 0) << kind;
    EXPECT_EQ(registers.at(STEPLOCK_SPEED_TARGET), most) << kind;
  }
}

TEST(HostAnswers, NoSpeedFollowsFromNoClock) {
  EXPECT_EQ(steplock_speed(12000, 0, 0), STEPLOCK_NO_SPEED);
  EXPECT_EQ(steplock_speed(12000, 12'000'000, 4), STEPLOCK_NO_SPEED) << "LOOP.divide has two bits";
  EXPECT_EQ(steplock_speed(12000, 12'000'000, 64), STEPLOCK_NO_SPEED);
  EXPECT_NE(steplock_speed(12000, 12'000'000, 3), STEPLOCK_NO_SPEED);
  EXPECT_EQ(steplock_sinusoidal_speed(12000, 0, 1200), STEPLOCK_NO_SPEED);
  EXPECT_EQ(steplock_sinusoidal_speed(12000, 24'000'000, 0), STEPLOCK_NO_SPEED);
  EXPECT_EQ(steplock_sinusoidal_erpm(100, 24'000'000, 0), 0);
}

TEST(HostAnswers, InterruptsThatTheMapDoesNotHaveAreRefused) {
  Registers registers(STEPLOCK_SIX_STEP);
  const steplock_bus bus = registers.bus();
  EXPECT_EQ(steplock_enable_interrupts(&bus, STEPLOCK_INTERRUPT_ENABLE_ENABLE_MASK), STEPLOCK_OK);
  registers.writes = 0;
  EXPECT_EQ(steplock_enable_interrupts(&bus, STEPLOCK_INTERRUPT_ENABLE_ENABLE_MASK + 1), STEPLOCK_REFUSED);
  EXPECT_EQ(registers.writes, 0);
}

// Without a bus, with half a bus, and with one over an SPI that is none.
TEST(HostAnswers, WithoutABusEverythingIsRefused) {
  const steplock_bus halves[] = {{}, {.write = Registers(1).bus().write, .read = nullptr, .context = nullptr},
                                 {.write = nullptr, .read = Registers(1).bus().read, .context = nullptr},
                                 steplock_over_spi(nullptr)};
  std::vector<const steplock_bus*> none = {nullptr};
  for (const auto& bus : halves) none.push_back(&bus);
  const steplock_word word = {STEPLOCK_PWM, 1};
  unsigned count = 0;
  std::uint32_t bits = 0;
  steplock_status status;
  steplock_telemetry telemetry;
  steplock_sinusoidal_telemetry sinusoidal;
  for (const steplock_bus* bus : none) {
    const steplock_result answers[] = {
        steplock_init(bus, &word, 1), steplock_get_kind(bus, &count), steplock_get_axes(bus, &count),
        steplock_start(bus, 0), steplock_stop(bus, 0), steplock_reverse(bus, 1), steplock_set_speed(bus, 1),
        steplock_get_status(bus, &status), steplock_get_telemetry(bus, &telemetry), steplock_clear_fault(bus),
        steplock_set_watchdog(bus, 1), steplock_heartbeat(bus), steplock_enable_interrupts(bus, 1),
        steplock_take_interrupts(bus, &bits), steplock_sinusoidal_get_telemetry(bus, &sinusoidal)};
    for (std::size_t k = 0; k < std::size(answers); ++k) EXPECT_EQ(answers[k], STEPLOCK_REFUSED) << k;
  }
  steplock_spi unfilled{};
  const steplock_bus bus = steplock_over_spi(&unfilled);
  EXPECT_EQ(steplock_heartbeat(&bus), STEPLOCK_BUS_ERROR);
  EXPECT_EQ(steplock_get_kind(&bus, &count), STEPLOCK_BUS_ERROR);
}

TEST(HostAnswers, WithoutAPlaceForTheAnswerNothingIsWritten) {
  Registers registers(STEPLOCK_SIX_STEP);
  const steplock_bus bus = registers.bus();
  const steplock_result answers[] = {
      steplock_init(&bus, nullptr, 1), steplock_get_kind(&bus, nullptr), steplock_get_axes(&bus, nullptr),
      steplock_get_status(&bus, nullptr), steplock_get_telemetry(&bus, nullptr),
      steplock_take_interrupts(&bus, nullptr), steplock_sinusoidal_get_telemetry(&bus, nullptr)};
  for (std::size_t k = 0; k < std::size(answers); ++k) EXPECT_EQ(answers[k], STEPLOCK_REFUSED) << k;
  EXPECT_EQ(registers.writes, 0);
}

// The names follow from the map's text, the numbers of the blocks from their enums.
TEST(HostAnswers, StatesAndReasonsAreThoseOfTheBlocks) {
  EXPECT_EQ(int(STEPLOCK_STATE_IDLE), int(State::kIdle));
  EXPECT_EQ(int(STEPLOCK_STATE_PULL_IN), int(State::kPullIn));
  EXPECT_EQ(int(STEPLOCK_STATE_RUN), int(State::kRun));
  EXPECT_EQ(int(STEPLOCK_STATE_FAULT), int(State::kFault));
  EXPECT_EQ(int(STEPLOCK_REASON_STEP_OUT), int(Reason::kStepOut));
  EXPECT_EQ(int(STEPLOCK_REASON_HALL_CODE), int(Reason::kHallCode));
  EXPECT_EQ(int(STEPLOCK_REASON_BLOCKED), int(Reason::kBlocked));
  EXPECT_EQ(int(STEPLOCK_SINUSOIDAL_STATE_PILOT_PULSES), int(SinusoidalState::kPilot));
  EXPECT_EQ(int(STEPLOCK_SINUSOIDAL_STATE_FAULT), int(SinusoidalState::kFault));
  EXPECT_EQ(int(STEPLOCK_SINUSOIDAL_REASON_EMF), int(SinusoidalReason::kEmf));
  EXPECT_EQ(int(STEPLOCK_SINUSOIDAL_REASON_NO_POLARITY), int(SinusoidalReason::kNoPolarity));
}

// Every number up to the last has a name of its own, and the next has none.
void all_have_names(const char* (*name)(unsigned), unsigned last) {
  std::map<std::string, unsigned> seen;
  for (unsigned k = 0; k <= last; ++k) {
    EXPECT_STRNE(name(k), "unknown") << k;
    EXPECT_TRUE(seen.emplace(name(k), k).second) << name(k);
  }
  EXPECT_STREQ(name(last + 1), "unknown");
  EXPECT_STREQ(name(0xffffffff), "unknown");
}

TEST(HostAnswers, EveryStateReasonAndResultHasAName) {
  all_have_names(steplock_state_name, STEPLOCK_STATE_FAULT);
  all_have_names(steplock_reason_name, STEPLOCK_REASON_BLOCKED);
  all_have_names(steplock_sinusoidal_state_name, STEPLOCK_SINUSOIDAL_STATE_FAULT);
  all_have_names(steplock_sinusoidal_reason_name, STEPLOCK_SINUSOIDAL_REASON_NO_POLARITY);
  all_have_names([](unsigned k) { return steplock_result_name(steplock_result(k)); }, STEPLOCK_WRONG_CLOCK);
  EXPECT_STREQ(steplock_state_name(STEPLOCK_STATE_PULL_IN), "pull in");
  EXPECT_STREQ(steplock_reason_name(STEPLOCK_REASON_OVER_CURRENT), "over-current");
  EXPECT_STREQ(steplock_sinusoidal_reason_name(STEPLOCK_SINUSOIDAL_REASON_NO_POLARITY), "no polarity");
  EXPECT_STREQ(steplock_result_name(STEPLOCK_NOT_KEPT), "not kept");
}

}  // namespace
}  // namespace steplock
