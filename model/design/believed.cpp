#include "model/design/believed.hpp"

#include <sstream>

namespace steplock::design {
namespace {

// visit(key, believed, the motor's) for each.
template <class Motor, class Visit>
void for_each_belief(const BelievedSection& b, Motor& m, Visit&& visit) {
  visit("resistance_ohm", b.resistance_ohm, m.resistance_ohm);
  visit("inductance_h", b.inductance_h, m.inductance_h);
  visit("inductance_d_h", b.inductance_d_h, m.inductance_d_h);
  visit("inductance_q_h", b.inductance_q_h, m.inductance_q_h);
  visit("flux_vs", b.flux_vs, m.flux_vs);
  visit("inertia_kgm2", b.inertia_kgm2, m.inertia_kgm2);
}

}  // namespace

Settings as_believed(const Settings& given) {
  Settings s = given;
  for_each_belief(given.believed, s.motor, [](const char*, const std::optional<double>& believed, auto& real) {
    if (believed) real = *believed;
  });
  s.believed = {};
  return s;
}

std::string beliefs(const Settings& s) {
  std::ostringstream text;
  text.precision(4);
  for_each_belief(s.believed, s.motor, [&](const char* key, const std::optional<double>& believed, std::optional<double> real) {
    if (!believed) return;
    text << (text.tellp() > 0 ? ", " : "believed: ") << key << ' ' << *believed / real.value_or(s.motor.inductance_h - s.motor.mutual_h)
         << " times the motor's";
  });
  return text.str();
}

}  // namespace steplock::design
