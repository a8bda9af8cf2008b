// Phase detector: the back-EMF against the divided VCO.
//
//     crossing        error = expected - crossing_phase   positive: rotor leads, VCO must hurry
//     none, before    error = expected - 1                step ended on the level before: it lags
//     none, after     error = 0 or lead_error             that level never showed: freewheeling hid
//                                                         the crossing; it leads if the step before
//                                                         was hidden, too, or led by 1/8
//     following       error = 1 - turns since the last change of sector, within +-1/2
//
// `masked_lead` marks a hidden crossing after one that was hidden or led by 1/16: current that grows the
// freewheeling makes the rotor faster than the loop can follow.  Hidden ones of a steady rotor do not.
//
// Two forms: every crossing, each 60 electrical degrees; or only phase U's rising one, once per
// turn, as in Amano 2003.  `Following` serves a rotor that is not driven by the VCO's steps: one
// that is being caught, or one with Hall sensors.  Each legal change of sector measures an
// interval; two turns without a change count as a miss, with the VCO too fast.
//
//     error        s0.16 of a step, held until the next update
//     latency      1 clock: outputs are registers, but for `error`'s bounds and `good`'s comparison behind one
//     registers    26 bits     multipliers  none
//
// Doc: docs/blocks/phase_detector.md   Test: tests/hls/phase_detector_test.cpp

#pragma once

#include "hls/numeric/bits.hpp"
#include "hls/six_step/config.hpp"

namespace steplock {

enum class DetectorSource : std::uint8_t { kNone, kCrossings, kSectors };

class PhaseDetector {
 public:
  struct In {
    DetectorSource detector_source = DetectorSource::kNone;  // what the error is made of
    bool crossing = false;          // strobe: the back-EMF crossed zero
    Phase crossing_phase = 0;       // u0.16, where in the step
    bool before_seen = false;       // the level before the crossing showed in this step
    bool commutate = false;         // first clock of a new step
    UInt<3> step = 0;               // 0 to 5
    bool reverse = false;           // the step counts down
    bool changed = false;           // strobe: the sector moved by one
    bool elapsed = false;           // strobe: a step's worth of VCO turns is over
    Phase phase = 0;                // u0.16, turns of this step
    Detector detector = Detector::kEveryStep;
    Phase expected = 0x8000;        // u0.16, the crossing's place in the step
    Phase lead_error = 0;           // u0.16, error when the level before never showed
    Phase window = 0;               // u0.16, errors below are good
  };

  struct Out {
    PhaseError error = 0;  // s0.16, turns of one step
    bool update = false;   // strobe: the error is new
    bool good = false;     // strobe: it is within the window (following: within 1/8)
    bool missed = false;   // strobe: it stands for a crossing that was not found
    bool masked_lead = false;  // until the next one: freewheeling hid it, and the rotor led before
  };

  Out tick(const In& in) {
    const UInt<17> magnitude = wrap<UInt<17>>(error_.negative() ? ~error_ : error_);
    const Out out{.error = saturate<PhaseError>(error_),
                  .update = update_,
                  .good = update_ && !missed_ && (follows_ ? magnitude < kSectorWindow : magnitude < in.window),
                  .missed = missed_,
                  .masked_lead = masked_lead_};

    const bool crossings = in.detector_source == DetectorSource::kCrossings;
    const bool sectors = in.detector_source == DetectorSource::kSectors;
    missed_ = (crossings && in.commutate && !answered_) ||
              (sectors && in.elapsed && turned_);
    update_ = missed_ || (crossings && in.crossing && !answered_) || (sectors && in.changed);
    if (update_) {
      const bool hid = crossings && missed_ && !before_;
      masked_lead_ = hid && (hid_ || error_ >= kLead);
      error_ = wrap<Int<18>>(place(in) - found(in));
      hid_ = hid;
    }

    if (in.commutate || !sectors) {
      turned_ = false;
    } else if (in.elapsed) {
      turned_ = !turned_;
    }
    if (!crossings) {
      answered_ = true;  // no miss for a step that began unwatched
    } else if (in.commutate) {
      // U floats and rises in step 5, or 2 when the rotor turns backwards.
      answered_ = in.detector == Detector::kOncePerTurn && in.step != (in.reverse ? 2 : 5);
    } else if (in.crossing) {
      answered_ = true;
    }
    before_ = in.before_seen;
    follows_ = sectors;
    return out;
  }

  bool operator==(const PhaseDetector&) const = default;

 private:
  // Error = place - found; both are turns of one step.  An update in the clock of a commutation is a miss, and
  // asking for no more than that leaves the adder its time.
  UInt<17> place(const In& in) const {
    // A change in the very clock in which the turn ends, as often happens in lock, comes after it.
    const bool turned = turned_ || in.elapsed;
    if (in.detector_source == DetectorSource::kSectors) return turned ? UInt<17>(0) : UInt<17>(0x10000);
    return !in.commutate || before_ ? in.expected : hid_ || far_lead() ? in.lead_error : Phase(0);
  }
  Phase found(const In& in) const {
    if (in.detector_source == DetectorSource::kSectors) return in.elapsed && turned_ ? Phase(0x8000) : in.phase;
    return !in.commutate ? in.crossing_phase : before_ ? Phase::max() : Phase(0);
  }
  bool far_lead() const { return error_ >= kFarLead; }

  static constexpr Phase kSectorWindow = 0x2000;  // u0.16: following, errors below are good
  static constexpr PhaseError kLead = 0x1000;     // s0.16: as under hard acceleration
  static constexpr PhaseError kFarLead = 0x2000;  // so far that the next crossing can be gone

  Int<18> error_ = 0;     // s2.16: what is shown stops at its limits
  bool update_ = false;
  bool missed_ = false;
  bool answered_ = true;  // this step has had its crossing, or needs none
  bool before_ = false;   // before_seen, from the step that a commutation ends
  bool hid_ = false;      // the last update was of a step on the level after
  bool masked_lead_ = false;  // and the rotor led before it; until the next update
  bool follows_ = false;  // the error is that of a sector
  bool turned_ = false;   // following: a whole turn since the last change or miss
};

}  // namespace steplock
