// Sector of the rotor from a three-bit code: Halls, or the comparators while the motor coasts.
//
//     code u v w   101 -> 0   100 -> 1   110 -> 2   010 -> 3   011 -> 4   001 -> 5
//
// A code counts once it has held still for `hold` seconds (comparators chatter near a crossing).
// Chatter may outlast it, so a change has a direction only where the rotor went on: not when it steps
// back once, and not when it returns from there.
//
// Doc: docs/theory.md   Test: tests/model/reference/reference_sector_test.cpp
#pragma once

#include "model/reference/pwm.hpp"
#include "model/reference/signals.hpp"

namespace steplock::reference {

class SectorDecoder {
 public:
  explicit SectorDecoder(double hold) : hold_(hold) {}

  static int sector_of(const std::array<bool, 3>& code) {  // -1: no rotor shows this code
    constexpr std::array<int, 8> kSector = {-1, 5, 3, 4, 1, 0, 2, -1};
    return kSector[4 * code[0] + 2 * code[1] + code[2]];
  }

  void restart() { sector_ = -1, way_ = 0, pending_ = back_ = false; }
  void update(double t, const std::array<bool, 3>& code) {
    direction_ = 0;
    settled_ = false;
    if (code != code_) {
      code_ = code;
      due_ = t + hold_;
      pending_ = true;
    }
    if (!pending_ || t < due_) return;
    pending_ = false;
    const int now = sector_of(code_);
    if (now < 0 || now == sector_) return;
    const int moved = sector_ < 0 ? 0 : (now - sector_ + 6) % 6;
    const int step = moved == 1 ? 1 : moved == 5 ? -1 : 0;
    const bool turns = step == -way_ && step != 0;
    if (turns == back_) direction_ = step;
    if (step == 0 || direction_ != 0) way_ = step;
    back_ = turns && !back_;
    settled_ = step == 0 || direction_ != 0;
    sector_ = now;
  }
  double next() const { return pending_ ? due_ : kNever; }

  int sector() const { return sector_; }        // -1 before the first legal code
  bool settled() const { return settled_; }     // a new sector in this update, in earnest
  int direction() const { return direction_; }  // of a change to a neighbour in this update, else 0
  bool illegal() const { return sector_of(code_) < 0; }

 private:
  double hold_, due_ = 0;
  std::array<bool, 3> code_ = {};
  int sector_ = -1, direction_ = 0;
  int way_ = 0;  // of the last change with a direction
  bool pending_ = true, settled_ = false, back_ = false;
};

}  // namespace steplock::reference
