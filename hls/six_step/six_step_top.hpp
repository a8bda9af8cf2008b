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
#include "hls/six_step/words.hpp"

namespace steplock {

class SixStepTop {
 public:
  struct In {
    Parts with;
    Synchroniser::Pins pins;  // asynchronous
    Command command;
    Words words;
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
    const Words& words = in.words;
    const auto pins = synchroniser_.tick(in.pins);
    const bool hall = in.with.hall_decoder && words.source == Source::kHall;
    Command command = in.command;
    const bool has_method = words.start.method == Method::kFollow ? bool(in.with.follower) : bool(in.with.ramp);
    command.configured = in.command.configured && (hall || (words.source != Source::kHall && has_method));
    // A method that is left out is none of which anything is asked.
    StartWords start_words = words.start;
    if (!in.with.ramp) start_words.method = Method::kFollow;
    if (!in.with.follower) start_words.method = Method::kRamp;
    const auto sectors = hall_.tick({.decodes = in.with.hall_decoder,
                                     .u = hall ? pins.hall_u : pins.comparator_u,
                                     .v = hall ? pins.hall_v : pins.comparator_v,
                                     .w = hall ? pins.hall_w : pins.comparator_w,
                                     .hold = words.bemf.blanking});

    const auto rotor = rotor_.tick({.follows = in.with.follower,
                                    .on = follow_,
                                    .u = pins.comparator_u,
                                    .v = pins.comparator_v,
                                    .w = pins.comparator_w,
                                    .crossing = crossing_,
                                    .elapsed = divided_.elapsed,
                                    .quarter = divided_.phase.bit(15) || divided_.phase.bit(14),
                                    .update = update_,
                                    .good = good_,
                                    .fast = fast_,
                                    .slow = slow_,
                                    .steady = steady_,
                                    .step = divided_.step,
                                    .reverse = reverse_,
                                    .sample_every = words.bemf.sample_every,
                                    .look = words.start.look,
                                    .probe = words.start.probe,
                                    .still = words.start.still});
    const auto start = start_.tick({.observes = in.with.hall_decoder,
                                    .tick = tick_,
                                    .command = command,
                                    .source = words.source,
                                    .words = start_words,
                                    .fast = fast_,
                                    .slow = slow_,
                                    .commutate = divided_.commutate,
                                    .update = update_,
                                    .good = good_,
                                    .lags = lags_,
                                    .turns_reverse = sectors.reverse,
                                    .sector = sectors.sector,
                                    // A rotor that may turn the other way drives its own current where no shunt sees it.
                                    .follower_drives = rotor.drive && (rotor.sure || chop_),
                                    .caught = rotor.caught,
                                    .sure = rotor.sure,
                                    .moves = rotor.moves,
                                    .blocked = rotor.blocked,
                                    .still = still_,
                                    .at = divided_.step,
                                    .lost = lost_,
                                    .fatal = fatal_,
                                    .cause = cause_});

    // With Hall sensors the sector is the step, in reverse with the current turned round.
    const bool hold = start.watch == Evidence::kSectors && (in.with.hall_decoder || in.with.follower);
    const bool new_sector = hold && (rotor.load || (!follow_ && sectors.changed));
    const Step hall_step = !start.reverse       ? sectors.sector
                           : sectors.sector < 3 ? wrap<Step>(sectors.sector + 3)
                                                : wrap<Step>(sectors.sector - 3);
    const DivideByN::Out divider = divided_;
    const Step step = hall ? hall_step : divider.step;

    const auto bemf = bemf_.tick({.u = pins.comparator_u,
                                  .v = pins.comparator_v,
                                  .w = pins.comparator_w,
                                  .step = step,
                                  .reverse = start.reverse,
                                  .commutate = divider.commutate || rotor.restart,
                                  .chop = chop_,
                                  .phase = divider.phase,
                                  .words = words.bemf});
    const auto detector = detector_.tick({.watch = start.watch,
                                          .crossing = bemf.crossing,
                                          .crossing_phase = bemf.crossing_phase,
                                          .before_seen = bemf.before_seen,
                                          .commutate = divider.commutate,
                                          .step = step,
                                          .reverse = start.reverse,
                                          .changed = follow_ ? rotor.changed : sectors.moved,
                                          .elapsed = divider.elapsed,
                                          .phase = divider.phase,
                                          .detector = words.loop.detector,
                                          .expected = words.loop.expected,
                                          .lead_error = words.loop.lead_error,
                                          .window = words.start.window});
    const auto filter = filter_.tick({.loop = start.loop,
                                      .error = detector.error,
                                      .update = detector.update,
                                      .tick = tick_,
                                      .ramp = words.start.ramp,
                                      .gentle = start.gentle,
                                      .bandwidth = words.loop.bandwidth,
                                      .delay = words.loop.delay >> int(words.loop.divide.raw()),
                                      .ki = words.loop.ki,
                                      .kp = words.loop.kp,
                                      .pole = words.loop.pole,
                                      .scale = words.loop.scale,
                                      .minimum = words.loop.minimum,
                                      .maximum = words.loop.maximum,
                                      .hand_over = words.start.hand_over,
                                      .stall = words.protection.stall});
    const bool load = start.load_step || new_sector;
    const auto vco = vco_.tick({.enable = start.turn_vco,
                                .load = load,
                                .half = start.load_step && words.loop.divide == 0,
                                .frequency = filter.frequency});
    divided_ = divide_.tick({.pulse = vco.pulse,
                             .phase = vco.phase,
                             .divide = words.loop.divide,
                             .reverse = start.reverse,
                             .hold = hold,
                             .load = load,
                             .step = start.load_step ? start.step : follow_ ? rotor.step : hall_step,
                             .half = start.load_step});

    // A step that follows the sectors drives no gate: they wait for the next one.
    const Gates legs = Commutation::legs(start.load_step ? start.step : divided_.turned);

    // While pulling in, a step without a good crossing says nothing of the speed: the duty rises on none.
    const bool unknown = update_ && !good_ && start.mode == SpeedMode::kControl && !start.running;
    const auto speed = speed_.tick({.tick = tick_,
                                    .mode = start.mode,
                                    .fixed_duty = start.duty,
                                    .frequency = filter.frequency,
                                    .target = start.stop ? Frequency(0) : words.speed.target,
                                    .limited = limited_ || unknown,
                                    .hurries = hurries_,
                                    .freewheels = freewheels_,
                                    .period = words.pwm.period,
                                    .slip = words.protection.slip,
                                    .words = words.speed});
    const auto pwm = pwm_.tick({.on_clocks = speed.on_clocks,
                                .period = words.pwm.period,
                                .minimum = words.pwm.minimum,
                                .centred = words.pwm.centred,
                                .tick_periods = words.pwm.tick_periods});
    const auto limit = limit_.tick({.on = pwm.on,
                                    .comparator = pins.limit,
                                    .fast = start.running || (follow_ && !rotor.sure),
                                    .words = words.limit});
    // A cut of a rotor that runs turns all gates off.  With a low side on, the back-EMF would drive the current on, where no
    // shunt sees it, and nothing but that side's diode would take the outgoing winding's current down.
    const auto request = commutation_.tick({.pattern = start.pattern.when(!(limit.cut && start.running)),
                                            .legs = hall ? Commutation::legs(hall_step) : legs_,
                                            .chop = limit.on,
                                            .complementary = words.pwm.complementary});
    const auto gates = guard_.tick({.request = request,
                                    .enable = start.enable && command.configured,
                                    .fault = pins.fault,
                                    .dead_time = words.pwm.dead_time,
                                    .minimum = saturate<UInt<8>>(words.pwm.minimum)});

    const auto protection = protection_.tick({.running = start.running,
                                              .tick = tick_,
                                              .commutate = divider.commutate || divider.elapsed,
                                              .update = detector.update,
                                              .good = detector.good,
                                              .missed = detector.missed,
                                              .lags = detector.error.negative(),
                                              .slow = filter.slow,
                                              .slips = speed.slips,
                                              .freewheel = hall ? Phase(0) : bemf.freewheel,
                                              .stuck = limit.stuck,
                                              .fault_pin = pins.fault,
                                              .hall = hall,
                                              .hall_illegal = !sectors.legal,
                                              .words = words.protection});
    const auto counts = telemetry_.tick({.counts = in.with.telemetry,
                                         .clear = start.began,
                                         .crossing = bemf.crossing,
                                         .missed = detector.missed,
                                         .freewheel_long = protection.freewheel_long,
                                         .limit_hit = limit.hit,
                                         .retry = start.failed});

    still_ = words.speed.target == 0;
    legs_ = legs;
    tick_ = pwm.tick;
    chop_ = limit.on;
    limited_ = limit.hit;
    fast_ = filter.fast;
    update_ = detector.update;
    good_ = detector.good;
    lags_ = detector.error.negative();
    slow_ = filter.slow;
    follow_ = start.follow;
    steady_ = start.steady;
    reverse_ = start.reverse;
    crossing_ = bemf.crossing;
    hurries_ = detector.hurries;
    // 15/32 of a step: more current would hide the crossing, or did.  Not while pulling in, which has its own way out.
    freewheels_ = !hall && start.running && bemf.freewheel.slice<15, 11>() >= 15;
    lost_ = protection.lost;
    fatal_ = protection.fatal;
    cause_ = protection.reason;

    return {.gates = gates,
            .state = start.state,
            .reason = start.reason,
            .locked = start.running,
            .reverse = start.reverse,
            .step = step,
            .chop = limit.on,
            .commutate = divider.commutate,
            .turn = DivideByN::turn(divider.step),
            .frequency = filter.frequency,
            .step_phase = divider.phase,
            .phase_error = detector.error,
            .update = detector.update,
            .crossing = bemf.crossing,
            .missed = detector.missed,
            .crossing_phase = bemf.crossing_phase,
            .freewheel = bemf.freewheel,
            .duty = speed.duty,
            .counts = counts};
  }

  bool operator==(const SixStepTop&) const = default;

 protected:  // testbench/engine/skipping_top.hpp counts with these

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
  bool hurries_ = false;
  bool freewheels_ = false;
  bool lost_ = false;
  bool fatal_ = false;
  Reason cause_ = Reason::kNone;
};

}  // namespace steplock
