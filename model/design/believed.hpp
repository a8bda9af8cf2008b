// A motor that is known wrongly: the design is made from what [believed] says, the plant from [motor].
//
// Doc: docs/design.md   Test: tests/model/design/believed_test.cpp
#pragma once

#include <string>

#include "model/design/settings.hpp"

namespace steplock::design {

// The settings of the motor that is believed to be there; those that are given, if none is.
Settings as_believed(const Settings&);

// What is believed beside what is, in words; nothing if nothing is.
std::string beliefs(const Settings&);

}  // namespace steplock::design
