#include "hls/numeric/bits.hpp"
#include "hls/numeric/block.hpp"

namespace steplock {

struct Rule {
  virtual UInt<8> apply(UInt<8> x) const { return x; }
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
    return {rule_.apply(in.x)};
  }

 private:
  Rule rule_;  // refused: virtual functions
};

template struct Synthesize<Refused>;

}  // namespace steplock
