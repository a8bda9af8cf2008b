#include "testbench/drive/six_step/config.hpp"

#include "hls/bus/word_rows.hpp"
#include "model/design/parameters.hpp"
#include "testbench/engine/config_by_name.hpp"

namespace steplock {
namespace {

// Enumerators have the same order on both sides.
static_assert(int(design::Sampling::kOnTime) == int(Sampling::kOnTime));
static_assert(int(design::Sampling::kOffTime) == int(Sampling::kOffTime));
static_assert(int(design::Sampling::kBoth) == int(Sampling::kBoth));
static_assert(int(design::Detector::kOncePerTurn) == int(Detector::kOncePerTurn));
static_assert(int(design::Detector::kEveryStep) == int(Detector::kEveryStep));
static_assert(int(design::LoopForm::kPerSecond) == int(Bandwidth::kPerSecond));
static_assert(int(design::LoopForm::kPerStep) == int(Bandwidth::kPerStep));
static_assert(int(design::Source::kBemf) == int(Source::kBemf));
static_assert(int(design::Source::kHall) == int(Source::kHall));
static_assert(int(design::Method::kRamp) == int(Method::kRamp));
static_assert(int(design::Method::kFollow) == int(Method::kFollow));

}  // namespace

SixStepConfig hls_config(const design::Config& d) { return config_by_name<SixStepConfig>(kWordRows, d); }

}  // namespace steplock
