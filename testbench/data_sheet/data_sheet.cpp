#include "testbench/data_sheet/data_sheet.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "testbench/drive_file/drive_file.hpp"
#include "testbench/drive_file/sheet_terms.hpp"

namespace steplock {
namespace {


class Reader {
 public:
  // A quantity that a sheet may print in several ways, the one named first being believed.
  double one_of(const std::string& what, const std::vector<std::optional<Told>>& ways, const std::string& mend) {
    const Told* first = nullptr;
    for (const auto& way : ways) {
      if (!way) continue;
      if (first == nullptr) first = &*way;
      if (const auto text = disagreement(what, *first, *way)) say(*text);
    }
    if (first == nullptr) say(fmt::format("{} is missing; give {}", what, mend));
    return first == nullptr ? 1 : first->value;
  }
  void say(const std::string& problem) { problems_.push_back("steplock new: " + problem); }
  void check() const {
    if (!problems_.empty()) throw BadInput(fmt::format("{}", fmt::join(problems_, "\n")));
  }

  // What is not printed, and what is taken instead.
  double or_assumed(const std::optional<double>& given, double otherwise, const std::string& key, const std::string& why) {
    if (given) return *given;
    assumed_.push_back(fmt::format("{}: {}", key, why));
    return otherwise;
  }
  const std::vector<std::string>& assumed() const { return assumed_; }
  void assume(const std::string& key, const std::string& why) { assumed_.push_back(fmt::format("{}: {}", key, why)); }

 private:
  std::vector<std::string> problems_, assumed_;
};

template <class Of>
std::optional<Told> told(const char* by, const std::optional<double>& given, Of&& of) {
  if (!given) return std::nullopt;
  return Told{by, of(*given)};
}

}  // namespace

const std::vector<SheetEntry>& sheet_entries() {
  static const std::vector<SheetEntry> kEntries = {
      {"--bus", "dc bus, V", "of the battery or supply under load, not of a charged one", &DataSheet::bus_v, 1, 1000},
      {"--poles", "magnet poles", "poles, not pairs: what `12N14P` calls 14P", &DataSheet::poles, 2, 200},
      {"--pole-pairs", "pole pairs", "half of the poles", &DataSheet::pole_pairs, 1, 100},
      {"--kv", "KV, r/min per V", "of the peak between two terminals; makers of propeller motors round it",
       &DataSheet::kv_rpm_per_v, 0.1, 1e5},
      {"--torque-constant", "torque constant, N m/A", "of the dc current with six steps, not of a phase's rms",
       &DataSheet::torque_constant_nm_a, 1e-6, 100},
      {"--no-load-speed", "speed without load on that bus, r/min", "at the same voltage as --bus",
       &DataSheet::no_load_speed_rpm, 1, 1e6},
      {"--no-load-current", "current without load, A", "of the dc bus; it is friction and iron, and no start depends on it",
       &DataSheet::no_load_current_a, 0, 1000},
      {"--resistance-line", "resistance between two terminals, ohm", "what an ohmmeter shows, without the leads",
       &DataSheet::resistance_line_ohm, 1e-5, 1e4},
      {"--resistance-phase", "resistance of a phase, ohm", "half of what is measured between two terminals",
       &DataSheet::resistance_phase_ohm, 1e-5, 1e4},
      {"--inductance-line", "inductance between two terminals, H", "at 1 kHz or more; 100 uH is 100e-6",
       &DataSheet::inductance_line_h, 1e-8, 10},
      {"--inductance-phase", "inductance of a phase, H", "half of what is measured between two terminals",
       &DataSheet::inductance_phase_h, 1e-8, 10},
      {"--inertia-gcm2", "rotor's inertia, g cm^2", "1 kg m^2 is 1e7 of them", &DataSheet::inertia_gcm2, 1e-4, 1e9},
      {"--rated-current", "rated current, A", "continuous, of the dc current with six steps",
       &DataSheet::rated_current_a, 1e-3, 1e4},
      {"--rated-torque", "rated torque, N m", "continuous", &DataSheet::rated_torque_nm, 1e-7, 1e5},
      {"--limit", "limit of the current, A", "of the drive, in any phase", &DataSheet::limit_a, 1e-3, 1e4},
      {"--speed", "set speed, r/min", "of the shaft, not electrical", &DataSheet::speed_rpm, 1, 1e6}};
  return kEntries;
}

std::string drive_file_of(const DataSheet& sheet) {
  Reader read;
  const double bus = read.one_of("the bus voltage", {told("--bus", sheet.bus_v, [](double v) { return v; })}, "--bus");
  const double pairs = read.one_of("the number of pole pairs",
                                   {told("--poles", sheet.poles, [](double n) { return n / 2; }),
                                    told("--pole-pairs", sheet.pole_pairs, [](double n) { return n; })},
                                   "--poles or --pole-pairs");
  if (pairs != std::round(pairs)) read.say(fmt::format("{:g} pole pairs are no whole number; --poles is even", pairs));
  const double line = read.one_of("the resistance between two terminals",
                                  {told("--resistance-line", sheet.resistance_line_ohm, [](double r) { return r; }),
                                   told("--resistance-phase", sheet.resistance_phase_ohm, [](double r) { return 2 * r; })},
                                  "--resistance-line or --resistance-phase");
  const double inductance = read.one_of("the inductance between two terminals",
                                        {told("--inductance-line", sheet.inductance_line_h, [](double l) { return l; }),
                                         told("--inductance-phase", sheet.inductance_phase_h, [](double l) { return 2 * l; })},
                                        "--inductance-line or --inductance-phase");
  const double idle = sheet.no_load_current_a.value_or(0);
  const double k_e = read.one_of("the back-EMF constant in V s/rad",
                                 {told("--torque-constant", sheet.torque_constant_nm_a, [](double k) { return k; }),
                                  told("--kv", sheet.kv_rpm_per_v, [](double kv) { return k_e_of_kv(kv); }),
                                  told("--no-load-speed", sheet.no_load_speed_rpm,
                                       [&](double n) { return k_e_without_load(bus, idle, line, n); })},
                                 "--kv, --torque-constant or --no-load-speed");
  const double rated = read.one_of("the rated current",
                                   {told("--rated-current", sheet.rated_current_a, [](double i) { return i; }),
                                    told("--rated-torque", sheet.rated_torque_nm, [&](double t) { return t / k_e; })},
                                   "--rated-current or --rated-torque");
  read.check();

  const double stalled = bus / line;
  const double limit = read.or_assumed(sheet.limit_a, estimated_limit(rated, stalled), "sensors.limit_a",
                                       "2.5 times the rated current, or 0.6 of what the bus drives through two phases");
  if (limit > 0.9 * stalled) {
    read.say(fmt::format("the limit is {:.4g} A, and {:g} V drive {:.4g} A through two phases; at most 0.9 of it, --limit {:.4g}", limit, bus,
                         stalled, 0.9 * stalled));
  }
  if (limit < rated) read.say(fmt::format("the limit is {:.4g} A, less than the rated current of {:.4g} A; raise --limit", limit, rated));
  const double no_load = bus / k_e / kRadPerSecond;
  const double speed = read.or_assumed(sheet.speed_rpm, std::round(0.6 * no_load), "scenario.speed_rpm",
                                       fmt::format("0.6 of the {:.0f} r/min that the back-EMF allows on this bus", no_load));
  if (speed > 0.9 * no_load) {
    read.say(fmt::format("the set speed is {:.4g} r/min, and the back-EMF allows {:.4g} on {:g} V; at most 0.9 of it, --speed {:.0f}", speed,
                         no_load, bus, 0.9 * no_load));
  }
  read.check();
  const double inertia = 1e-7 * read.or_assumed(sheet.inertia_gcm2, 1e7 * estimated_inertia(k_e, line), "motor.inertia_kgm2",
                                                "a mechanical time constant of 15 ms; the gains of the speed control follow from it");
  const double friction = sheet.no_load_current_a ? *sheet.no_load_current_a * k_e : 0.02 * k_e * rated;
  read.assume("motor.coulomb_nm", sheet.no_load_current_a ? "all of the current without load is dry friction" : "2 % of the rated torque");
  read.assume("inverter.on_resistance_ohm", "a twentieth of a phase's resistance, 10 ohm at most");
  read.assume("inverter.bus_resistance_ohm", "a tenth of a phase's resistance, 10 ohm at most");
  read.assume("sensors.comparator_offset_v", "4 in 10,000 of the bus, as dividers of 0.1 % and a comparator of some mV have");
  read.assume("load.inertia_kgm2", "the rotor's own once more, and no other load");

  const design::Shape shape = sheet.trapezoidal ? design::Shape::kTrapezoidal : design::Shape::kSinusoidal;
  std::string assumed;
  for (const std::string& a : read.assumed()) assumed += fmt::format("  \"{}\",\n", a);
  return fmt::format(R"(# Written by `steplock new` from a data sheet.  Change what you know better; docs/drive_file.md has every key.

[drive]
name = "{}"
source = "a data sheet, by steplock new"
assumed = [
{}]

[motor]
resistance_ohm = {:.4g}      # a phase: half of {:.4g} between two terminals
inductance_h = {:.4g}
flux_vs = {:.4g}             # back-EMF constant {:.4g} V s/rad: KV {:.4g}, {:.4g} N m/A
pole_pairs = {:g}
shape = "{}"
inertia_kgm2 = {:.4g}
coulomb_nm = {:.4g}
rated_current_a = {:.4g}

[load]
inertia_kgm2 = {:.4g}

[inverter]
bus_v = {:g}
bus_resistance_ohm = {:.4g}
on_resistance_ohm = {:.4g}
dead_time_s = 0.5e-6

[sensors]
comparator_offset_v = [{:.4g}, {:.4g}, {:.4g}]
comparator_noise_v = {:.4g}
limit_a = {:.4g}

[control]
clock_hz = {:g}e6
pwm_hz = {:g}e3
chopping = "complementary"   # the low side takes over: a motor without load does not run away from a low duty

[scenario]
speed_rpm = {:g}
duration_s = 3
)",
                     sheet.name, assumed, line / 2, line, inductance / 2,
                     k_e / k_e_per_flux(shape, pairs), k_e, kv_of_k_e(k_e), k_e, pairs,
                     design::enum_words(shape)[static_cast<std::size_t>(shape)], inertia, friction, rated, inertia, bus,
                     std::min(10.0, line / 20), std::min(10.0, line / 40), 4e-4 * bus, -4e-4 * bus, 2e-4 * bus, 2e-4 * bus, limit,
                     sheet.clock_mhz, sheet.pwm_khz, speed);
}

}  // namespace steplock
