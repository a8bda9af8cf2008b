// Comparators, current limit and Halls: what the controller's pins see of the plant.
//
//     comparator k   v_k - reference          high above offset + hysteresis / 2,
//     limit          shunt current - threshold     low below offset - hysteresis / 2
//     hall k         high while theta_e - 30 deg - 120 deg * k - error_k is in [0, 180) of a turn
//
// The inputs come as smooth arcs.  Each arc is searched once for crossings; a crossing reaches its
// pin after the signal's transport delay.  If the arc is left early, the crossings beyond that
// instant are forgotten, those before it stay on their way to the pin.
//
// Noise is held for noise_interval.  Over one such cell the input is taken from the parabola
// through the arc's begin, middle and end, whose error is far below any noise worth modelling.
//
// Doc: docs/plant.md   Test: tests/model/plant/sensors_test.cpp
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "model/plant/arc.hpp"
#include "model/plant/parameters.hpp"
#include "model/plant/plant.hpp"

namespace steplock::plant {

class Sensors {
 public:
  explicit Sensors(const Sensing&);

  void set_limit_threshold(double amps) { signal_[kLimit].offset = amps + limit_offset_; }

  // Pins as the first arc's begin says, without delay.
  void start(const Arc&);

  // Finds the crossings of a new arc that begins at `time`; sudden changes at its begin included.
  // Those of the arc before that lie after the time last reached are dropped.
  void search(const Arc&, double time);

  // Goes to `time`: pins take what has arrived by then.
  void reach(double time);

  // When the next pin change arrives; infinity if the present arc brings none.
  double next_change() const { return next_; }

  const Pins& pins() const { return pins_; }

  // Standard normal deviate number `cell` of noise source `source`.
  static double gaussian(std::uint64_t seed, int source, std::int64_t cell);

 private:
  enum { kLimit = 3, kHall = 4, kSignals = 7 };
  struct Change {
    double crossing, arrival;
    int signal;
    bool level;
  };

  double input(int signal, const Point&) const;
  static bool decide(double input, bool level, const Comparator&);
  bool hall_level(int hall, const Point&) const;
  void search_quiet(int signal, const Arc&, double time);
  void search_noisy(int signal, const Arc&, double time);
  void search_hall(int hall, const Arc&, double time);
  void add(int signal, double crossing, bool level);
  void apply(const Change&);

  Sensing::Reference reference_;
  std::uint64_t seed_;
  double limit_offset_;
  std::array<Comparator, 4> signal_;  // three comparators and the limit
  std::array<double, kSignals> delay_;
  std::array<double, 3> hall_edge_;        // rad, electrical angle at which the Hall rises
  std::array<bool, kSignals> level_ = {};  // before the delay, at the time last reached
  std::vector<Change> planned_;            // of the present arc, by crossing
  std::vector<Change> underway_;           // crossed, not yet arrived, by arrival
  double next_ = 0;
  Pins pins_;
};

}  // namespace steplock::plant
