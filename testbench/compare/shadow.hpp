// The blocks drive, the reference looks over their shoulder: how far the two are apart.
//
// Both see the same pins.  At each commutation of the steady span the blocks' and the reference's
// commutation to the same step are paired, and the differences of instant, phase error, speed and duty
// stand beside the error budget that the design library prints.
//
// Doc: docs/report.md   Test: tests/testbench/compare_test.cpp
#pragma once

#include <functional>
#include <optional>

#include "model/design/parameters.hpp"
#include "testbench/drive/six_step/summary.hpp"

namespace steplock {

// `blocks`: what a run of this drive came to, with the rtl or the fixed engine; it tells where the steady
// span is, and that part is run again.  `reference`: parameters of the reference if not the design's, a
// negative control.
FloatErrors shadow_errors(const design::Settings&, const Summary& blocks,
                          const std::function<bool(double done)>& progress = {},
                          const std::optional<design::Parameters>& reference = {});

}  // namespace steplock
