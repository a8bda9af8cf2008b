// A part of a block that its user may leave out: a member of In that is fixed at synthesis.
//
//     struct Parts {
//       Parameter<true> telemetry;  // counts events
//     };
//
// In C++ it is a bool of In with a default.  Its module has it as a parameter, TELEMETRY, and whoever
// instantiates the module says #(.TELEMETRY(0)).  A block gives a child's parameter its own, or a constant:
// hlsgen refuses what is computed.  It has to stand still; a block says itself what a 0 leaves of it.
//
// Doc: docs/generator.md   Test: tests/generator/frontend/parameter_test.cpp

#pragma once

namespace steplock {

template <bool Default>
class Parameter {
 public:
  constexpr Parameter() = default;
  constexpr Parameter(bool in) : in_(in) {}
  constexpr operator bool() const { return in_; }

 private:
  bool in_ = Default;
};

}  // namespace steplock
