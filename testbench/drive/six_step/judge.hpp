// Judges the drive from outside: the true electrical angle at each commutation.
//
// Pattern p is ideal while theta lies in [30 + 60 k, 90 + 60 k) degrees, k = p forward and p + 3 in
// reverse.  The commutation error is how late the pattern began, in electrical degrees:
//
//     forward   theta - (30 + 60 k)        reverse   (90 + 60 k) - theta        (+ phase advance)
//
// It is followed without wrapping from lock on.  Each time it has moved by more than a whole step
// (60 degrees) from where it belongs, a step was slipped: the field and the rotor no longer turn
// together, whatever the drive believes.  A lock that begins a step or more away counts as well.
//
// Doc: docs/report.md   Test: tests/testbench/judge_test.cpp
#pragma once

#include <cstdint>

namespace steplock {

class Judge {
 public:
  explicit Judge(double advance_deg = 0) : advance_deg_(advance_deg) {}

  // The drive, claiming a lock, went from one pattern to another at this angle.  Only neighbours
  // tell a direction; after any other change, and in another direction, the judge begins afresh.  The
  // first one counts once a second in its direction confirms it: a drive that catches a spinning rotor
  // goes to its step from anywhere, then turns with it.
  void commutated(double electrical_rad, int from, int to);
  // The drive no longer claims a lock; the next one is judged afresh.
  void released() { following_ = false; }

  std::uint64_t step_outs() const { return step_outs_; }
  std::uint64_t commutations() const { return count_; }  // judged ones
  double sum() const { return sum_; }                    // of errors, degrees
  double sum_of_squares() const { return squares_; }
  double last_deg() const { return error_deg_; }

 private:
  void take();

  bool following_ = false, confirmed_ = false, reverse_ = false;
  double advance_deg_;
  double error_deg_ = 0;  // unwrapped
  long slot_ = 0;         // whole steps slipped so far in this lock
  std::uint64_t step_outs_ = 0, count_ = 0;
  double sum_ = 0, squares_ = 0;
};

}  // namespace steplock
