// A start that follows the rotor, in doubles: drive a step, look with all gates off, and judge.
//
//     turns = (seen - step) mod 6, the wanted way; seen is the step whose crossing ends the sector looked at,
//     for a rotor that is believed to turn the other way that of the inverted code
//
// Written from the table in docs/blocks/rotor_follower.md; the belief here is a direction, +1 or -1, and
// a number of edges.  Times are seconds; the interval between two edges is measured by the caller.
//
// Doc: docs/theory.md   Test: tests/model/reference/reference_rotor_follower_test.cpp
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "model/design/parameters.hpp"
#include "model/reference/pwm.hpp"
#include "model/reference/signals.hpp"

namespace steplock::reference {

class RotorFollower {
 public:
  RotorFollower(const design::StartParameters& p, double sample_every) : p_(p), every_(sample_every) {}

  void begin(double t) {
    *this = RotorFollower(p_, every_);
    look_from(t, p_.look);
  }
  void end() { stage_ = Stage::kOff; }

  struct In {
    std::array<bool, 3> comparator = {};
    bool crossing = false;  // of the driven step
    bool overdue = false;   // the expected interval is over by a quarter
    bool update = false;    // an interval was measured
    bool ready = false;     // fast enough, and steady
    int step = 0;
    bool reverse = false;
  };
  void update(double t, const In& in) {
    loaded_.reset();
    changed_ = caught_ = blocked_ = false;
    timed_ = sure() && (timed_ || in.update);
    if (stage_ == Stage::kDrive) {
      const bool crossed = in.crossing && t >= believes_ && real_ && belief_ > 0;
      caught_ = crossed && sure() && in.ready;
      const bool over = !timed_ && t >= until_;
      if (!caught_ && (crossed || over || (sure() && in.overdue))) look_from(t, p_.look);
    } else if (stage_ == Stage::kLook && t >= until_) {
      for (int k = 0; k < 3; ++k) high_[std::size_t(k)] += in.comparator[std::size_t(k)];
      until_ = t + every_;
      if (++samples_ == kSamples) {
        judge(in);
        if (coasts_ > 0) {
          look_from(t, light() ? p_.probe : p_.look);
        } else {
          stage_ = Stage::kDrive;
          believes_ = t + kSamples * every_;
          until_ = believes_ + p_.probe;
        }
      }
    }
  }

  bool drives() const { return stage_ == Stage::kDrive; }
  std::optional<int> loaded() const { return loaded_; }  // in this update: the step to drive
  bool changed() const { return changed_; }  // in this update: a rotor that is followed passed an edge
  bool caught() const { return caught_; }    // in this update: hand over, in the middle of the step
  bool blocked() const { return blocked_; }  // three steps in a row moved nothing
  bool sure() const { return edges_ >= 2; }
  bool moves() const { return moved_; }      // it passed an edge, the way that is believed
  double next() const {
    if (stage_ == Stage::kLook) return until_;
    return stage_ == Stage::kDrive && !timed_ ? until_ : kNever;
  }

 private:
  static constexpr int kSamples = 15;
  static constexpr int kCoast = 3;   // looks in a row at a rotor that may turn either way
  static constexpr int kLasts = 4;   // looks that a belief has lasted
  enum class Stage { kOff, kLook, kDrive };

  // Its first edge came after few drives: a sector more may carry it past its set speed.
  bool light() const { return edges_ == 1 && idle_ < kLasts; }

  void look_from(double t, double off) {
    stage_ = Stage::kLook;
    until_ = t + off;
    samples_ = 0;
    high_ = {};
  }

  // The sector, 0 to 5, or -1: no more than the signs of three back-EMFs 120 degrees apart.
  static int sector_of(const std::array<bool, 3>& c) {
    const std::array<bool, 3> signs[] = {{1, 0, 1}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 1, 1}, {0, 0, 1}};
    const auto* at = std::find(std::begin(signs), std::end(signs), c);
    return at == std::end(signs) ? -1 : int(at - std::begin(signs));
  }

  void judge(const In& in) {
    std::array<bool, 3> code;
    for (std::size_t k = 0; k < 3; ++k) code[k] = 2 * high_[k] > kSamples;
    const bool clear = std::all_of(high_.begin(), high_.end(), [](int n) { return n < 4 || n > kSamples - 4; });
    const int sector = clear || edges_ > 0 ? sector_of(code) : -1, way = in.reverse ? -1 : 1;
    const std::array<bool, 3> now_at_rest = clear ? code : std::array<bool, 3>{};
    // The step of a rotor that turns the wanted way, or opposite it.
    const auto step_for = [&](int belief) {
      return (sector + (in.reverse ? 5 : 0) + (belief < 0 ? 3 : 0)) % 6;
    };
    const auto go = [&](int step) { loaded_ = (step + 6) % 6; };
    const auto doubt = [&](int belief) {
      belief_ = belief;
      moved_ = false;
      edges_ = 0;
    };
    const int believed = belief_;
    const bool coasted = coasts_ > 0;
    bool news = false;
    if (!real_) {
      const bool first = !rest_;
      const bool other = !first && code != *rest_;
      if (first) rest_ = now_at_rest;
      doubt(+1);
      real_ = sector >= 0 && other;
      news = sector >= 0 && (first || other);
      if (news) go(step_for(+1));
    } else if (sector >= 0 && !(coasted && code == *rest_)) {
      const int turns = ((step_for(belief_) - in.step) * way % 6 + 6) % 6;
      const bool on = turns == (belief_ > 0 ? 1 : 5);
      const bool far = turns == 4, again = far && far_;
      const bool skipped = belief_ > 0 ? turns == 2 && moved_ : again;
      const bool contrary = turns == (belief_ > 0 ? 5 : 1);
      // The edge just passed may be seen once more; of one the wanted way for as long as the rotor coasts.
      const bool chatters = moved_ && (sure() || belief_ < 0 || coasted);
      if (turns != 0) far_ = far;
      if (on || skipped) {
        changed_ = on && belief_ > 0 && edges_ >= 1;
        news = belief_ < 0 || edges_ >= 1;
        moved_ = true;
        if (belief_ > 0) ++edges_;
        go(step_for(belief_));
      } else if (again || (contrary && !chatters)) {
        doubt(-belief_);
        go(step_for(belief_));
      } else if (turns == 3) {
        doubt(-belief_);
      } else if (turns != 0 && !contrary) {
        doubt(+1);
        go(step_for(+1));
      }
    }
    // A belief that had lasted and turns gives a heavy rotor time to do so; once, since codes that quiver turn it for ever.
    const bool turns = belief_ != believed, waits = turns && !turned_ && idle_ >= kLasts;
    turned_ = !news && (turned_ || waits);
    coasts_ = loaded_ && real_ && belief_ > 0 && !turns && !sure() ? kCoast : turns ? 0 : std::max(0, coasts_ - 1);
    if (news || waits) idle_ = 0;
    else if (!coasted) ++idle_;
    if (news) stood_ = 0;
    if (idle_ >= p_.still && !coasted) {
      blocked_ = ++stood_ == 3;
      doubt(+1);
      real_ = far_ = turned_ = false;
      coasts_ = 0;
      rest_ = now_at_rest;
      idle_ = 0;
      onward_ = !onward_;
      // For a second time in a row: the other neighbour of the step that moved nothing first.
      go(in.step + (onward_ ? way : -way) * (stood_ == 2 ? 2 : 1));
    }
  }

  design::StartParameters p_;
  double every_;
  Stage stage_ = Stage::kOff;
  double until_ = kNever, believes_ = kNever;  // of this stage; a crossing from then on
  int samples_ = 0;
  std::array<int, 3> high_ = {};
  std::optional<std::array<bool, 3>> rest_;  // code of a rotor at rest
  bool real_ = false, moved_ = false, far_ = false;
  int belief_ = +1, edges_ = 0, idle_ = 0, stood_ = 0;
  bool turned_ = false;  // a belief that had lasted, since the last news
  int coasts_ = 0;       // looks to come before a drive
  bool onward_ = false;  // the last time that nothing moved the way was onward, not back
  std::optional<int> loaded_;
  bool changed_ = false, caught_ = false, blocked_ = false, timed_ = false;
};

}  // namespace steplock::reference
