// Hall decoder: a three-bit code with one change per 60 electrical degrees, to a sector.
//
//     code u v w   101  100  110  010  011  001      000, 111
//     sector        0    1    2    3    4    5       illegal
//
// Hall sensors speak this code, and so do the three BEMF comparators while all gates are off.  A code
// counts once it has stood for `hold` clocks longer than the first, so that chatter around an edge
// and the codes in passing between two edges are not seen; the delay is the same for every edge.
//
// A change to a neighbour is a `move`: it tells direction and, by the time since the last one, speed.
// Any other change, the first legal code after reset or after an illegal one too, is a `jump`: it
// tells the sector and nothing else.  An edge of a slow rotor chatters for longer than any hold: a
// step back to the last sector and the return from there are no moves; a second step back is one.
//
// Left out by DECODES it says nothing: sector 0, not legal, no moves.
//
//     latency      hold + 2 clocks from the pins' synchronisers to the outputs
//     registers    27 bits     multipliers  none
//
// Doc: docs/blocks/hall_decoder.md   Test: tests/hls/hall_decoder_test.cpp

#pragma once

#include "hls/numeric/bits.hpp"
#include "hls/six_step/config.hpp"

namespace steplock {

class HallDecoder {
 public:
  struct In {
    Parameter<true> decodes;
    bool u = false;     // synchronised
    bool v = false;     // synchronised
    bool w = false;     // synchronised
    UInt<10> hold = 0;  // clocks
  };

  struct Out {
    UInt<3> sector = 0;    // 0 to 5: of the last legal code
    bool legal = false;    // the code that stands is legal
    bool moved = false;    // one clock: the sector is new, and the rotor went on to it
    bool reverse = false;  // the last move went down
    bool jumped = false;   // one clock: the sector is new, and says nothing about speed
    bool changed = false;  // one clock: either
    bool operator==(const Out&) const = default;
  };

  Out tick(const In& in) {
    const Out out{.sector = sector_,
                  .legal = legal_,
                  .moved = moved_,
                  .reverse = reverse_,
                  .jumped = jumped_,
                  .changed = changed_};
    const Decoded decoded = decode(code_);
    const bool accept = stood_;
    // Codes of neighbours differ in one pin; that one and a second tell the direction.
    const bool u = code_.bit(2), v = code_.bit(1), w = code_.bit(0);
    const UInt<3> other = code_ ^ last_;
    const bool down = other == 0b100 ? u == v : other == 0b010 ? v != u : w == u;
    const bool changed = accept && decoded.legal && (!legal_ || other != 0);
    const bool neighbour = changed && legal_ && (other == 0b100 || other == 0b010 || other == 0b001);
    const bool turns = sure_ && down != reverse_;
    moved_ = neighbour && turns == back_;
    jumped_ = changed && !neighbour;
    changed_ = changed && (!neighbour || turns == back_);
    if (changed) {
      back_ = neighbour && turns && !back_;
      sure_ = neighbour;
    }
    if (moved_) reverse_ = down;
    if (changed) {
      sector_ = decoded.sector;
      last_ = code_;
    }
    if (accept) legal_ = decoded.legal;

    const UInt<3> code = (UInt<3>(in.u) << 2) | (UInt<3>(in.v) << 1) | UInt<3>(in.w);
    if (code != code_) {
      left_ = in.hold;
      stood_ = in.hold == 0;
    } else if (!stood_) {
      stood_ = left_ == 1;
      left_ = wrap<UInt<10>>(left_ - 1);
    }
    code_ = code;
    if (!in.decodes) *this = HallDecoder{};
    return out;
  }

  // Quiet clocks (docs/theory.md) with that code at the pins: until this block does more than count, and that many at once.
  std::uint64_t quiet(UInt<3> code) const {
    if (code != code_ || moved_ || changed_) return 0;
    if (left_ != 0) return left_.raw();
    const bool legal = decode(code_).legal;
    return legal != legal_ || (legal && code_ != last_) ? 0 : ~std::uint64_t{0};
  }
  void skip(std::uint64_t clocks) {
    if (left_ != 0) left_ = UInt<10>::of(left_.raw() - clocks);
    stood_ = left_ == 0;
  }
  bool operator==(const HallDecoder&) const = default;

 private:
  struct Decoded {
    UInt<3> sector = 0;  // 0 to 5
    bool legal = false;  // neither 000 nor 111
  };

  static constexpr Decoded decode(UInt<3> code) {
    switch (int(code.raw())) {
      case 0b101: return {.sector = 0, .legal = true};
      case 0b100: return {.sector = 1, .legal = true};
      case 0b110: return {.sector = 2, .legal = true};
      case 0b010: return {.sector = 3, .legal = true};
      case 0b011: return {.sector = 4, .legal = true};
      case 0b001: return {.sector = 5, .legal = true};
      default: return {};
    }
  }

  UInt<3> code_ = 0;      // u v w, one clock ago
  UInt<10> left_ = 0;     // clocks until the code counts
  bool stood_ = true;     // none: it counts
  UInt<3> last_ = 0;      // the last legal one that counted
  UInt<3> sector_ = 0;    // 0 to 5: its sector
  bool legal_ = false;    // of the last code that counted
  bool moved_ = false;    // one clock: to a neighbour, in earnest
  bool reverse_ = false;  // the last move went down
  bool sure_ = false;     // there was a move since the last jump
  bool back_ = false;     // the sector is the one before the last move's
  bool jumped_ = false;   // one clock: to no neighbour
  bool changed_ = false;  // one clock: either
};

}  // namespace steplock
