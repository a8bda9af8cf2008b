// Protection: when a lock is no longer one (ends the attempt), and what ends the drive at once.
//
//     step-out     score + 4 per step that ended before its crossing, + 1 per one whose crossing
//                  freewheeling hid or came far from its place, - 1 per good one, at `misses`
//     stall        six steps in a row slower than `stall`
//     wrong lock   duty - back-EMF's duty > slip, or freewheeling beyond `freewheel` of a step: of
//                  `wrong_lock` such a tick takes two, any other gives one back
//     over-current the limit did not release in `over_current` hits in a row; fault pin: at once
//
// Doc: docs/theory.md   Test: tests/model/reference/reference_protection_test.cpp
#pragma once

#include <algorithm>
#include <cmath>

#include "model/design/parameters.hpp"
#include "model/reference/signals.hpp"

namespace steplock::reference {

class Protection {
 public:
  Protection(const design::ProtectionParameters& p, double tick)
      : p_(p), wrong_ticks_(std::lround(p.wrong_lock / tick)) {}

  struct In {
    bool running = false, tick = false, commutated = false;
    bool updated = false, good = false, missed = false, lags = false;  // the phase detector
    bool hall = false, hall_illegal = false, fault_pin = false;
    double frequency = 0, slip = 0, freewheel = 0;
    int stuck = 0;
  };
  void update(const In& in) {
    if (!in.running) {
      wrong_ = score_ = slow_ = illegal_ = 0;
    } else {
      if (in.missed) score_ += in.lags ? 4 : 1;
      if (in.updated && !in.good && !in.missed && !in.hall) ++score_;
      if (in.good && score_ > 0) --score_;
      if (in.commutated) slow_ = in.frequency < p_.stall ? slow_ + 1 : 0;
      if (in.tick) {
        const bool wrong = in.slip > p_.slip || in.freewheel > p_.freewheel;
        wrong_ = std::max(0L, wrong_ + (wrong ? 2 : -1));
        illegal_ = in.hall && in.hall_illegal ? illegal_ + 1 : 0;
      }
    }
    fatal_ = lost_ = Reason::kNone;
    if (p_.over_current > 0 && in.stuck >= p_.over_current) fatal_ = Reason::kOverCurrent;
    if (in.fault_pin) fatal_ = Reason::kFaultPin;
    if (illegal_ >= 2) lost_ = Reason::kHallCode;
    if (wrong_ticks_ > 0 && wrong_ >= wrong_ticks_) lost_ = Reason::kWrongLock;
    if (slow_ >= 6) lost_ = Reason::kStall;
    if (p_.misses > 0 && score_ >= p_.misses) lost_ = Reason::kStepOut;
  }

  Reason lost() const { return lost_; }    // give up this attempt
  Reason fatal() const { return fatal_; }  // latch a fault

 private:
  design::ProtectionParameters p_;
  long wrong_ticks_;
  long wrong_ = 0;
  int score_ = 0, slow_ = 0, illegal_ = 0;
  Reason lost_ = Reason::kNone, fatal_ = Reason::kNone;
};

}  // namespace steplock::reference
