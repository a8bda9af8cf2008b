// The six-step drive: wires between the blocks, and nothing else.
//
//     pins -> Synchroniser -> BemfComparator -> PhaseDetector -> LoopFilter -> VcoCounter -.
//                         \-> HallDecoder ---/                                             |
//                                                          Commutation <-- DivideByN <-----'
//     SpeedControl -> PwmGenerator -> CurrentLimit -------------^  \-> GateGuard -> gates
//     StartSequence says who is closed when; Protection and Telemetry watch.
//
// The blocks stand in a ring (the VCO's step selects the comparator that moves the VCO).  It is cut
// behind the divider, whose outputs are a register here; a few strobes cross a clock as well.
//
// WITH_HALL_DECODER = 0, WITH_FOLLOWER = 0, WITH_RAMP = 0 and WITH_TELEMETRY = 0 leave blocks out.  Without the decoder a
// start does not look whether the rotor turns already; words of Hall sensors, or of a start that is left out, leave the
// drive idle, gates off.
//
//     fault pin to all six gates off    3 clocks: two of the synchroniser, one of the gate guard
//     comparator pin to its sample      2 clocks; limit pin to high side off 5 clocks
//     VCO's pulse to the new step       1 clock
//
// Doc: docs/blocks/six_step_top.md   Test: tests/hls/six_step_top_test.cpp

#pragma once

#include "hls/bridge/current_limit.hpp"
#include "hls/bridge/gate_guard.hpp"
#include "hls/bridge/pwm_generator.hpp"
#include "hls/bridge/synchroniser.hpp"
#include "hls/six_step/bemf_comparator.hpp"
#include "hls/six_step/commutation.hpp"
#include "hls/six_step/divide_by_n.hpp"
#include "hls/six_step/hall_decoder.hpp"
#include "hls/six_step/loop_filter.hpp"
#include "hls/six_step/phase_detector.hpp"
#include "hls/six_step/protection.hpp"
#include "hls/six_step/rotor_follower.hpp"
#include "hls/six_step/speed_control.hpp"
#include "hls/six_step/start_sequence.hpp"
#include "hls/six_step/telemetry.hpp"
#include "hls/six_step/vco_counter.hpp"
#include "hls/six_step/config.hpp"

namespace steplock {

class SixStepTop {
 public:
  struct In {
    Parts with;
    Synchroniser::Pins pins;  // asynchronous
    Command command;
    SixStepConfig config;
  };

  struct Out {
    Gates gates;
    State state = State::kIdle;
    Reason reason = Reason::kNone;
    bool locked = false;        // running under speed control
    bool reverse = false;       // direction of rotation
    Step step = 0;              // 0 to 5
    bool chop = false;          // PWM and current limit: on
    bool commutate = false;     // one clock, the first of a new step
    bool turn = false;          // the divided VCO signal
    Frequency frequency = 0;    // u0.32, VCO turns per clock
    Phase step_phase = 0;       // u0.16, turns of this step
    PhaseError phase_error = 0; // s0.16, turns of one step
    bool update = false;        // strobe: the phase error is new
    bool crossing = false;      // strobe: the back-EMF crossed zero
    bool missed = false;        // strobe: a step ended without a crossing
    Phase crossing_phase = 0;   // u0.16, where in the step
    Phase freewheel = 0;        // u0.16, where in the step freewheeling ended
    Duty duty = 0;              // u1.15
    Telemetry::Out counts;
    bool operator==(const Out&) const = default;
  };

  Out tick(const In& in) {
    Wires wires;
    return tick_with(in, wires);
  }

  bool operator==(const SixStepTop&) const = default;

 protected:  // testbench/drive/six_step/skipping_top.hpp counts with these, and in most clocks asks the quick blocks alone
  // What the blocks say in a clock.
  struct Wires {
    bool configured = false;  // for what this core has
    Synchroniser::Out pins;
    HallDecoder::Out sectors;
    RotorFollower::Out rotor;
    StartSequence::Out start;
    bool hold = false;        // the step waits for a sensor, or for the follower
    bool new_sector = false;  // strobe: which says it now
    Step hall_step = 0;       // with Hall sensors
    Step step = 0;
    DivideByN::Out divider;   // as it was
    BemfComparator::Out bemf;
    PhaseDetector::Out detector;
    LoopFilter::Out filter;
    Gates legs;               // of the next step
    SpeedControl::Out speed;
    PwmGenerator::Out pwm;
    CurrentLimit::Out limit;
    Gates gates;
  };

  Out tick_with(const In& in, Wires& w) {
    const SixStepConfig& config = in.config;
    sense(in, w);
    const bool hall = by_hall(in);
    Command command = in.command;
    const bool has_method = config.start.method == Method::kFollow ? bool(in.with.follower) : bool(in.with.ramp);
    command.configured = in.command.configured && (hall || (config.source != Source::kHall && has_method));
    // A method that is left out is none of which anything is asked.
    StartConfig start_config = config.start;
    if (!in.with.ramp) start_config.method = Method::kFollow;
    if (!in.with.follower) start_config.method = Method::kRamp;
    w.configured = command.configured;

    w.rotor = rotor_.tick({.follows = in.with.follower, .on = follow_, .u = w.pins.comparator_u,
                           .v = w.pins.comparator_v, .w = w.pins.comparator_w, .crossing = crossing_,
                           .elapsed = divided_.elapsed, .quarter = divided_.phase.bit(15) || divided_.phase.bit(14),
                           .update = update_, .good = good_, .fast = fast_, .slow = slow_, .steady = steady_,
                           .step = divided_.step, .reverse = reverse_, .sample_every = config.bemf.sample_every,
                           .look = config.start.look, .probe = config.start.probe, .still = config.start.still});
    const auto start = start_.tick({.detects_spin = in.with.hall_decoder, .tick = tick_, .command = command,
                                    .source = config.source, .config = start_config, .fast = fast_, .slow = slow_,
                                    .commutate = divided_.commutate, .update = update_, .good = good_, .lags = lags_,
                                    .turns_reverse = w.sectors.reverse, .sector = w.sectors.sector,
                                    // A rotor that may turn the other way drives its own current where no shunt sees it.
                                    .follower_drives = w.rotor.drive && (w.rotor.sure || chop_), .caught = w.rotor.caught,
                                    .sure = w.rotor.sure, .moves = w.rotor.moves, .blocked = w.rotor.blocked, .still = still_,
                                    .at = divided_.step, .lost = lost_, .fatal = fatal_, .cause = cause_});
    w.start = start;

    listen(in, w);
    w.detector = detector_.tick({.detector_source = start.detector_source, .crossing = w.bemf.crossing,
                                 .crossing_phase = w.bemf.crossing_phase, .before_seen = w.bemf.before_seen,
                                 .commutate = w.divider.commutate, .step = w.step, .reverse = start.reverse,
                                 .changed = follow_ ? w.rotor.changed : w.sectors.moved, .elapsed = w.divider.elapsed,
                                 .phase = w.divider.phase, .detector = config.loop.detector,
                                 .expected = config.loop.expected, .lead_error = config.loop.lead_error,
                                 .window = config.start.window});
    w.filter = filter_.tick({.loop = start.loop, .error = w.detector.error, .update = w.detector.update,
                             .tick = tick_, .ramp = config.start.ramp, .backoff = start.backoff,
                             .bandwidth = config.loop.bandwidth,
                             .delay = config.loop.delay >> int(config.loop.divide.raw()), .ki = config.loop.ki,
                             .kp = config.loop.kp, .alpha = config.loop.alpha, .scale = config.loop.scale,
                             .minimum = config.loop.minimum, .maximum = config.loop.maximum,
                             .hand_over = config.start.hand_over, .stall = config.protection.stall});
    turn(in, w);

    // While pulling in, a step without a good crossing says nothing of the speed: the duty rises on none.
    const bool unknown = update_ && !good_ && start.mode == SpeedMode::kControl && !start.running;
    w.speed = speed_.tick({.tick = tick_, .mode = start.mode, .fixed_duty = start.duty,
                           .frequency = w.filter.frequency,
                           .target = start.stop ? Frequency(0) : config.speed.target, .limited = limited_ || unknown,
                           .masked_lead = masked_lead_, .freewheels = freewheels_, .period = config.pwm.period,
                           .slip = config.protection.slip, .config = config.speed});
    drive(in, w);

    const auto protection = protection_.tick({.running = start.running, .tick = tick_,
                                              .commutate = w.divider.commutate || w.divider.elapsed,
                                              .update = w.detector.update, .good = w.detector.good,
                                              .missed = w.detector.missed, .lags = w.detector.error.negative(),
                                              .slow = w.filter.slow, .slips = w.speed.slips,
                                              .freewheel = hall ? Phase(0) : w.bemf.freewheel,
                                              .stuck = w.limit.stuck, .fault_pin = w.pins.fault, .hall = hall,
                                              .hall_illegal = !w.sectors.legal, .config = config.protection});
    const auto counts = telemetry_.tick({.counts = in.with.telemetry, .clear = start.began,
                                         .crossing = w.bemf.crossing, .missed = w.detector.missed,
                                         .freewheel_long = protection.freewheel_long, .limit_hit = w.limit.hit,
                                         .retry = start.failed});

    still_ = config.speed.target == 0;
    keep(w);
    fast_ = w.filter.fast;
    update_ = w.detector.update;
    good_ = w.detector.good;
    lags_ = w.detector.error.negative();
    slow_ = w.filter.slow;
    follow_ = start.follow;
    steady_ = start.steady;
    reverse_ = start.reverse;
    crossing_ = w.bemf.crossing;
    masked_lead_ = w.detector.masked_lead;
    // 15/32 of a step: more current would hide the crossing, or did.  Not while pulling in, which has its own way out.
    freewheels_ = !hall && start.running && w.bemf.freewheel.slice<15, 11>() >= 15;
    lost_ = protection.lost;
    fatal_ = protection.fatal;
    cause_ = protection.reason;

    return {.gates = w.gates,
            .state = start.state,
            .reason = start.reason,
            .locked = start.running,
            .reverse = start.reverse,
            .step = w.step,
            .chop = w.limit.on,
            .commutate = w.divider.commutate,
            .turn = DivideByN::turn(w.divider.step),
            .frequency = w.filter.frequency,
            .step_phase = w.divider.phase,
            .phase_error = w.detector.error,
            .update = w.detector.update,
            .crossing = w.bemf.crossing,
            .missed = w.detector.missed,
            .crossing_phase = w.bemf.crossing_phase,
            .freewheel = w.bemf.freewheel,
            .duty = w.speed.duty,
            .counts = counts};
  }

  // Hall sensors tell the step.
  static bool by_hall(const In& in) { return in.with.hall_decoder && in.config.source == Source::kHall; }

  // What the pins say.
  void sense(const In& in, Wires& w) {
    const auto pins = synchroniser_.tick(in.pins);
    const bool hall = by_hall(in);
    w.pins = pins;
    w.sectors = hall_.tick({.decodes = in.with.hall_decoder,
                            .u = hall ? pins.hall_u : pins.comparator_u,
                            .v = hall ? pins.hall_v : pins.comparator_v,
                            .w = hall ? pins.hall_w : pins.comparator_w,
                            .hold = in.config.bemf.blanking});
  }

  // The step that is driven, and what its floating terminal says.
  void listen(const In& in, Wires& w) {
    // With Hall sensors the sector is the step, in reverse with the current turned round.
    const bool hold = w.start.detector_source == DetectorSource::kSectors && (in.with.hall_decoder || in.with.follower);
    const bool new_sector = hold && (w.rotor.load || (!follow_ && w.sectors.changed));
    const Step hall_step = !w.start.reverse       ? w.sectors.sector
                           : w.sectors.sector < 3 ? wrap<Step>(w.sectors.sector + 3)
                                                  : wrap<Step>(w.sectors.sector - 3);
    const Step step = by_hall(in) ? hall_step : divided_.step;
    w.hold = hold;
    w.new_sector = new_sector;
    w.hall_step = hall_step;
    w.divider = divided_;
    w.step = step;
    w.bemf = bemf_.tick({.u = w.pins.comparator_u,
                         .v = w.pins.comparator_v,
                         .w = w.pins.comparator_w,
                         .step = step,
                         .reverse = w.start.reverse,
                         .commutate = w.divider.commutate || w.rotor.restart,
                         .chop = chop_,
                         .phase = w.divider.phase,
                         .config = in.config.bemf});
  }

  // The next step, by the VCO or by what a sensor or a start says.
  void turn(const In& in, Wires& w) {
    const bool load = w.start.load_step || w.new_sector;
    const auto vco = vco_.tick({.enable = w.start.turn_vco,
                                .load = load,
                                .half = w.start.load_step && in.config.loop.divide == 0,
                                .frequency = w.filter.frequency});
    divided_ = divide_.tick({.pulse = vco.pulse,
                             .phase = vco.phase,
                             .divide = in.config.loop.divide,
                             .reverse = w.start.reverse,
                             .hold = w.hold,
                             .load = load,
                             .step = w.start.load_step ? w.start.step : follow_ ? w.rotor.step : w.hall_step,
                             .half = w.start.load_step});

    // A step that follows the sectors drives no gate: they wait for the next one.
    const Gates legs = Commutation::legs(w.start.load_step ? w.start.step : divided_.turned);
    w.legs = legs;
  }

  // From a duty to six gates.
  void drive(const In& in, Wires& w) {
    const SixStepConfig& config = in.config;
    w.pwm = pwm_.tick({.on_clocks = w.speed.on_clocks,
                       .period = config.pwm.period,
                       .minimum = config.pwm.minimum,
                       .centred = config.pwm.centred,
                       .tick_periods = config.pwm.tick_periods});
    w.limit = limit_.tick({.on = w.pwm.on,
                           .comparator = w.pins.limit,
                           .fast = w.start.running || (follow_ && !w.rotor.sure),
                           .config = config.limit});
    // A cut of a rotor that runs turns all gates off.  With a low side on, the back-EMF would drive the current on, where no
    // shunt sees it, and nothing but that side's diode would take the outgoing winding's current down.
    const auto request = commutation_.tick({.pattern = w.start.pattern.when(!(w.limit.cut && w.start.running)),
                                            .legs = by_hall(in) ? Commutation::legs(w.hall_step) : legs_,
                                            .chop = w.limit.on,
                                            .complementary = config.pwm.complementary});
    w.gates = guard_.tick({.request = request,
                           .enable = w.start.enable && w.configured,
                           .fault = w.pins.fault,
                           .dead_time = config.pwm.dead_time,
                           .minimum = saturate<UInt<8>>(config.pwm.minimum)});
  }

  void keep(const Wires& w) {
    legs_ = w.legs;
    tick_ = w.pwm.tick;
    chop_ = w.limit.on;
    limited_ = w.limit.hit;
  }

  Synchroniser synchroniser_;
  HallDecoder hall_;
  RotorFollower rotor_;
  StartSequence start_;
  DivideByN divide_;
  BemfComparator bemf_;
  PhaseDetector detector_;
  LoopFilter filter_;
  VcoCounter vco_;
  SpeedControl speed_;
  PwmGenerator pwm_;
  CurrentLimit limit_;
  Commutation commutation_;
  GateGuard<> guard_;
  Protection protection_;
  Telemetry telemetry_;

  bool still_ = false;  // the set speed is 0
  bool tick_ = false;
  bool chop_ = false;
  bool limited_ = false;
  DivideByN::Out divided_;
  Gates legs_;  // of its step
  bool fast_ = false;
  bool update_ = false;
  bool good_ = false;
  bool lags_ = false;
  bool slow_ = false;
  bool follow_ = false;
  bool steady_ = false;
  bool reverse_ = false;
  bool crossing_ = false;
  bool masked_lead_ = false;
  bool freewheels_ = false;
  bool lost_ = false;
  bool fatal_ = false;
  Reason cause_ = Reason::kNone;
};

}  // namespace steplock
