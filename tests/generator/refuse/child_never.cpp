#include "hls/numeric/bits.hpp"
#include "hls/numeric/block.hpp"

namespace steplock {

class Child {
 public:
  struct In {
    bool go = false;
  };
  struct Out {
    UInt<4> count = 0;
  };
  Out tick(const In& in) {
    if (in.go) count_ = wrap<UInt<4>>(count_ + 1);
    return {count_};
  }
  UInt<4> count_ = 0;
};

class Refused {
 public:
  struct In {
    UInt<8> x = 0;
  };
  struct Out {
    UInt<8> y = 0;
  };
  Out tick(const In& in) {
    return {child_.tick({in.x == 1}).count};
  }

 private:
  Child child_;
  Child other_;  // refused: 'other_' is never ticked
};

template struct Synthesize<Refused>;

}  // namespace steplock
