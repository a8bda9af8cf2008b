// One smooth arc of the plant's trajectory: a regime, one integration step under it, and its end,
// which is the step's own end or the first instant at which the regime stops being true.
//
// Guards are the functions that stay non-negative while the regime holds:
//
//     diode current in its direction         floating terminal within its clamps
//     angle within the piece of the BEMF     speed in the direction that friction assumes
//     current in a contact that opens at its zero
//     pull below breakaway, while at rest    bus on the side of the source that conduction assumes
//
// They are looked at in the middle and at the end of the step, the crossing is then found on the
// dense output to kEventTolerance.  A dip shorter than half a step is not seen; the step is kept
// below 20 electrical degrees for that reason.
//
// Doc: docs/plant.md   Test: tests/model/plant/arc_test.cpp
#pragma once

#include <array>
#include <tuple>

#include "model/plant/dormand_prince.hpp"
#include "model/plant/dynamics.hpp"

namespace steplock::plant {

inline constexpr double kEventTolerance = 1e-12;  // s

struct Point {
  double elapsed;  // s since the arc's start
  Variables y;
  Outputs out;
};

class Arc {
 public:
  // Plans from `start` on; `step` is the length to try first and becomes the one to try next.
  // Returns the number of integration steps it took, rejected ones included.
  int plan(const Dynamics&, const Regime&, const Variables& start, const Accuracy&, double& step);

  double length() const { return points_[2].elapsed; }
  const Regime& regime() const { return regime_; }
  const std::array<Point, 3>& points() const { return points_; }  // begin, middle, end

  Variables at(double elapsed) const;
  Point point(double elapsed) const;
  Powers energies(double elapsed) const { return step_.integrals(elapsed); }

  // The state at `elapsed` with what the regime's end makes exact made so: a diode's current that
  // has reached zero is zero, a speed that has is zero.
  Variables settled(double elapsed) const;

 private:
  enum class Kind {
    kCurrent, kContact, kLowClamp, kHighClamp, kCorner, kReversal, kBreakaway, kSource
  };
  struct Guard {
    Kind kind;
    int leg;
  };

  void watch();
  void find_end();
  double value(Guard, const Point&) const;

  const Dynamics* dynamics_ = nullptr;
  Regime regime_;
  DormandPrinceStep<std::tuple_size_v<Variables>, std::tuple_size_v<Powers>> step_;
  std::array<Point, 3> points_ = {};
  std::array<Guard, 12> guards_ = {};
  int guard_count_ = 0;
  int hit_ = -1;  // the guard that ended the arc, or none
};

}  // namespace steplock::plant
