// From a value in its unit to the nearest register word, under its name; what was wanted, and what the word means instead, is
// kept as a row, and what does not fit as a problem.
//
// Test: tests/model/design/config_test.cpp
#pragma once

#include <algorithm>
#include <cmath>
#include <sstream>
#include <string>
#include <vector>

#include "model/design/config.hpp"

namespace steplock::design {

class Quantiser {
 public:
  Quantiser(Config& config, std::vector<WordRow>& rows, std::vector<std::string>& problems)
      : config_(config), rows_(rows), problems_(problems) {}

  // The word whose `unit_per_lsb` multiple is nearest; `bits` wide.
  Word operator()(const char* name, const char* unit, double wanted, double unit_per_lsb, int bits,
                  double most_allowed = 0) {
    const double most = most_allowed > 0 ? most_allowed : std::ldexp(1.0, bits) - 1;
    const double nearest = std::round(wanted / unit_per_lsb);
    if (!(nearest >= 0 && nearest <= most)) {
      std::ostringstream line;
      line << name << " needs the word " << nearest << "; at most " << most;
      problems_.push_back(line.str());
    }
    const Word word = nearest > 0 ? Word(std::min(nearest, most)) : 0;
    rows_.push_back({name, unit, wanted, word, word * unit_per_lsb});
    config_.set(name, word);
    return word;
  }
  // One that says which of some, or how many, and has nothing to round.
  template <class Choice>
  void choose(const char* name, Choice choice) {
    config_.set(name, static_cast<Word>(choice));
  }

 private:
  Config& config_;
  std::vector<WordRow>& rows_;
  std::vector<std::string>& problems_;
};

}  // namespace steplock::design
