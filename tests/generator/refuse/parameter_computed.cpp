#include "hls/numeric/bits.hpp"
#include "hls/numeric/block.hpp"
#include "hls/numeric/parameter.hpp"

namespace steplock {

class Child {
 public:
  struct In {
    Parameter<true> counts;
    bool event = false;
  };
  struct Out {
    UInt<4> count = 0;
  };
  Out tick(const In& in) {
    if (in.event && in.counts) count_ = wrap<UInt<4>>(count_ + 1);
    return {count_};
  }

 private:
  UInt<4> count_ = 0;
};

class Refused {
 public:
  struct In {
    Parameter<true> counts;
    bool event = false;
    bool pauses = false;
  };
  struct Out {
    UInt<4> count = 0;
  };
  Out tick(const In& in) {
    return {child_.tick({.counts = in.counts && !in.pauses, .event = in.event}).count};
  }

 private:
  Child child_;  // refused: parameter 'counts' of 'child_' is computed
};

template struct Synthesize<Refused>;

}  // namespace steplock
