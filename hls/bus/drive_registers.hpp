// Drive registers: control, status, faults, interrupts, heartbeat watchdog and telemetry of a drive,
// and the answer to every read; what words and constants say comes from ConfigRegisters.
//
//     fault      sticky with its reason; a one re-arms the drive: `run` down, the cause gone
//     watchdog   `period` ticks without a heartbeat while configured: all gates off, `run` cleared,
//                latched until a one is written
//     control    a write replaces its bits; one to its set or clear register changes those that are one
//     snapshot   the telemetry registers are copies, all taken in the clock of one write, in a
//                memory each: all are written at once, and only the one that is read shows its copy
//     interrupts set by the edge of their event, which wins over a clear in the same clock
//
//     latency      1 clock from request to answer, kept until the next one of its kind
//     registers    about 100 bits     multipliers  none
//     memory       5 of 32 bits, two block RAMs each on iCE40
//
// Doc: docs/blocks/drive_registers.md   Test: tests/hls/drive_registers_test.cpp

#pragma once

#include <array>

#include "hls/bridge/bridge.hpp"
#include "hls/bus/bus.hpp"
#include "hls/bus/register_map.hpp"
#include "hls/numeric/memory.hpp"

namespace steplock {

// One telemetry register.  Word 0 is never written: it is what the others show while one is read,
// and what is read before the first snapshot.  Word 1 is the copy.  More are there because synthesis
// would make flip-flops of so small a memory.
struct TelemetryCopy {
  using Word = UInt<32>;
  static constexpr int kLanes = 1;
  static constexpr std::array<Word, 8> kWords{};
};

template <class Map = SixStep>
class DriveRegisters {
  using Drive = typename Map::Shown;  // what the drive shows
  using State = typename Map::State;
  using Reason = typename Map::Reason;

 public:
  struct In {
    BusRequest request;
    UInt<32> word = 0;      // of the last read, if it was of a word or a constant, else 0
    bool hole = false;
    bool refused = false;   // a write here changes nothing
    bool unlocked = false;
    bool no_period = false;  // the bridge has to stay off
    bool tick = false;      // the slow time base
    Kilohertz clock_khz = 0;  // constant: what CLOCK shows
    Drive drive;
  };

  struct Out {
    Command command;
    bool stopped = true;        // idle or in fault, and not told to run
    UInt<32> data = 0;          // of the last read
    bool read_error = false;    // it was of a hole
    bool write_error = false;   // the last write was refused
    bool interrupt = false;
  };

  Out tick(const In& in) {
    const UInt<32> telemetry = snapshot(in);
    const Out out{.command = {.configured = configured_ && !watchdog_fault_ && !in.no_period,
                              .run = run_,
                              .reverse = reverse_,
                              .brake_to_stop = brake_to_stop_,
                              .clear_fault = clear_},
                  .stopped = stopped(in.drive),
                  .data = data_ | telemetry | in.word,
                  .read_error = read_error_,
                  .write_error = write_error_,
                  .interrupt = (interrupts_ & enabled_) != UInt<kEvents>(0)};
    if (in.request.read) {
      data_ = in.hole ? UInt<32>(0) : status(in);
      read_error_ = in.hole;
    }
    if (in.request.write) write_error_ = in.refused;

    // The bits that a write names; none without one.
    const BusRequest& request = in.request;
    const bool writes = request.write && !in.refused;
    const UInt<32> ones = request.data & byte_mask(request.strobes);
    const bool beats = writes && (request.index == kHeartbeat || request.index == kWatchdog);
    const bool expires = watch(in.tick, beats);
    const bool clears = writes && request.index == kFault;
    if (clears && ones.bit(kWatchdogFault)) watchdog_fault_ = false;
    drive_fault_ = faulted(in.drive);
    clear_ = clears && ones.bit(kDriveFault);
    if (in.drive.state != State::kFault || was_faulted_) {
      cleared_ = cleared_ || clear_;
    } else {
      cleared_ = false;
    }

    const UInt<kEvents> events = look(in.drive, expires);
    const bool acknowledges = writes && request.index == kInterrupt;
    const auto kept = acknowledges ? ~wrap<UInt<kEvents>>(ones) : UInt<kEvents>::max();
    interrupts_ = (interrupts_ & kept) | events;

    if (writes && request.strobes.bit(0)) {
      configured_ = control<field<Map>("CONTROL", "configured").lsb>(configured_, request);
      run_ = control<field<Map>("CONTROL", "run").lsb>(run_, request);
      reverse_ = control<field<Map>("CONTROL", "reverse").lsb>(reverse_, request);
      brake_to_stop_ = control<field<Map>("CONTROL", "brake_to_stop").lsb>(brake_to_stop_, request);
      if (request.index == kEnable) enabled_ = wrap<UInt<kEvents>>(request.data);
    }
    if (writes && request.index == kWatchdog) {
      const UInt<32> old = UInt<32>(period_) & ~byte_mask(request.strobes);
      left_ = period_ = wrap<WatchdogTicks>(ones | old);
    }
    if (expires) {
      watchdog_fault_ = true;
      run_ = false;
    }
    return out;
  }

 private:
  static constexpr int kControl = index_of<Map>("CONTROL");
  static constexpr int kSet = index_of<Map>("CONTROL_SET");
  static constexpr int kClear = index_of<Map>("CONTROL_CLEAR");
  static constexpr int kFault = index_of<Map>("FAULT");
  static constexpr int kInterrupt = index_of<Map>("INTERRUPT");
  static constexpr int kEnable = index_of<Map>("INTERRUPT_ENABLE");
  static constexpr int kWatchdog = index_of<Map>("WATCHDOG");
  static constexpr int kHeartbeat = index_of<Map>("HEARTBEAT");
  static constexpr int kSnapshot = index_of<Map>("SNAPSHOT");
  static constexpr int kCopies = Map::kCopies;
  static constexpr int kTelemetry = index_of<Map>("TELEMETRY_SPEED");  // the first of so many in a row
  static_assert(kCopies == index_of<Map>("TELEMETRY_RETRIES") - kTelemetry + 1);
  static constexpr int kDriveFault = field<Map>("FAULT", "drive").lsb;
  static constexpr int kWatchdogFault = field<Map>("FAULT", "watchdog").lsb;
  static constexpr int kEvents = field<Map>("INTERRUPT_ENABLE", "enable").width;

  bool stopped(const Drive& drive) const {
    return !run_ && (drive.state == State::kIdle || drive.state == State::kFault);
  }

  // A drive that was re-armed shows it some clocks after the write: until then the fault stays.
  bool faulted(const Drive& drive) const {
    return drive.state == State::kFault || (drive_fault_ && !cleared_);
  }

  // True in the clock in which the time for a heartbeat is over.
  bool watch(bool tick, bool beats) {
    const bool watches = period_ != WatchdogTicks(0) && configured_ && !watchdog_fault_;
    const bool expires = watches && tick && left_ == WatchdogTicks(0) && !beats;
    if (beats || !watches) {
      left_ = period_;
    } else if (tick && !expires) {
      left_ = wrap<WatchdogTicks>(left_ - 1);
    }
    return expires;
  }

  // What happened since the clock before, each at its place in INTERRUPT.
  UInt<kEvents> look(const Drive& drive, bool expires) {
    const bool faulted = drive.state == State::kFault;
    const bool locks = drive.locked && !was_locked_;
    const bool loses = !drive.locked && was_locked_ && (faulted || drive.state == State::kRetryDelay);
    const UInt<kEvents> events = flag<field<Map>("INTERRUPT", "fault").lsb>(faulted && !was_faulted_) |
                                 flag<field<Map>("INTERRUPT", "watchdog").lsb>(expires) |
                                 flag<field<Map>("INTERRUPT", "lock").lsb>(locks) |
                                 flag<field<Map>("INTERRUPT", "lost").lsb>(loses) |
                                 flag<field<Map>("INTERRUPT", "started").lsb>(locks && starting_);
    if (faulted && !was_faulted_) fault_reason_ = drive.reason;
    starting_ = !run_ || (starting_ && !locks);
    was_faulted_ = faulted;
    was_locked_ = drive.locked;
    return events;
  }
  template <int Bit>
  static UInt<kEvents> flag(bool on) {
    return on ? UInt<kEvents>(1 << Bit) : UInt<kEvents>(0);
  }

  // A bit of CONTROL after a write to one of its three registers.
  template <int Bit>
  static bool control(bool was, const BusRequest& request) {
    const bool one = request.data.bit(Bit);
    if (request.index == kControl) return one;
    return (was || (one && request.index == kSet)) && !(one && request.index == kClear);
  }

  // A field's value at its place.
  template <int Lsb, class T>
  static UInt<32> at(const T& value) {
    return bits_of(value) << Lsb;
  }
  UInt<32> status(const In& in) const {
    const WordIndex index = in.request.index;
    switch (index.slice<5, 0>().raw()) {
      case kControl:
        return at<field<Map>("CONTROL", "configured").lsb>(configured_) |
               at<field<Map>("CONTROL", "run").lsb>(run_) |
               at<field<Map>("CONTROL", "reverse").lsb>(reverse_) |
               at<field<Map>("CONTROL", "brake_to_stop").lsb>(brake_to_stop_);
      case index_of<Map>("STATUS"):
        return at<field<Map>("STATUS", "state").lsb>(in.drive.state) |
               at<field<Map>("STATUS", "reason").lsb>(in.drive.reason) |
               at<field<Map>("STATUS", "locked").lsb>(in.drive.locked) |
               at<field<Map>("STATUS", "reverse").lsb>(in.drive.reverse) |
               at<field<Map>("STATUS", "unlocked").lsb>(in.unlocked) |
               at<field<Map>("STATUS", "stopped").lsb>(stopped(in.drive)) |
               at<field<Map>("STATUS", "no_period").lsb>(in.no_period);
      case kFault:
        return at<kDriveFault>(faulted(in.drive)) | at<kWatchdogFault>(watchdog_fault_) |
               at<field<Map>("FAULT", "reason").lsb>(fault_reason_);
      case kInterrupt: return interrupts_;
      case kEnable: return enabled_;
      case kWatchdog: return period_;
      case index_of<Map>("CLOCK"): return in.clock_khz;
      default: return 0;
    }
  }

  // Takes and reads the copies: those of the last snapshot, 0 before the first.
  UInt<32> snapshot(const In& in) {
    const std::array<UInt<32>, kCopies> now = Map::telemetry(in.drive);
    const bool takes = in.request.write && !in.refused && in.request.index == kSnapshot;
    UInt<32> shown = 0;
    for (int i = 0; i < kCopies; ++i) {
      const bool here = !in.hole && in.request.index == UInt<10>(kTelemetry + i);
      const auto copy = copies_[i].tick({.read = in.request.read,
                                         .address = here && taken_ ? UInt<3>(1) : UInt<3>(0),
                                         .write = takes ? UInt<1>(1) : UInt<1>(0),
                                         .write_address = 1,
                                         .write_data = now[i]});
      shown = shown | copy.data;
    }
    const UInt<32> data = read_ ? shown : UInt<32>(0);
    if (in.request.read) read_ = true;
    if (takes) taken_ = true;
    return data;
  }

  bool configured_ = false;
  bool run_ = false;
  bool reverse_ = false;
  bool brake_to_stop_ = false;
  bool clear_ = false;    // to the drive, one clock
  bool cleared_ = false;  // a one was written since the drive's fault
  bool drive_fault_ = false;
  bool watchdog_fault_ = false;
  Reason fault_reason_ = Reason::kNone;
  UInt<kEvents> interrupts_ = 0;
  UInt<kEvents> enabled_ = 0;
  WatchdogTicks period_ = 0;  // ticks
  WatchdogTicks left_ = 0;    // ticks to the next heartbeat
  bool starting_ = true;      // no lock since `run` rose
  bool was_faulted_ = false;
  bool was_locked_ = false;
  std::array<Memory<TelemetryCopy>, kCopies> copies_;
  bool taken_ = false;        // a snapshot since the reset
  bool read_ = false;         // a read since the reset
  UInt<32> data_ = 0;         // the answer to the last read, of what stands here
  bool read_error_ = false;
  bool write_error_ = false;
};

}  // namespace steplock
