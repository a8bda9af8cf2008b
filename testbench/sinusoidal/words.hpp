// The sinusoidal drive's words as the blocks take them, from the same words as the design library
// gives them: member by member, because model/ and hls/ must not know each other.
//
// Test: tests/testbench/sinusoidal_engines_test.cpp
#pragma once

#include "hls/sinusoidal/words.hpp"
#include "model/design/sinusoidal/words.hpp"

namespace steplock::sinusoidal {

SinusoidalWords hls_words(const design::sinusoidal::Words&);

// Those of a drive's settings.  Throws std::invalid_argument where they do not fit: one line each.
SinusoidalWords words_of(const design::Settings&);

}  // namespace steplock::sinusoidal
