// The register words as the blocks take them, from the same words as the design library gives them:
// member by member, because model/ and hls/ must not know each other.
//
// Test: tests/testbench/engine_test.cpp
#pragma once

#include "hls/six_step/words.hpp"
#include "model/design/words.hpp"

namespace steplock {

Words hls_words(const design::Words&);

}  // namespace steplock
