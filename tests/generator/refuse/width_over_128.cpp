#include "hls/numeric/bits.hpp"
#include "hls/numeric/block.hpp"

namespace steplock {

class Refused {
 public:
  struct In {
    UInt<8> x = 0;
  };
  struct Out {
    UInt<8> y = 0;
  };
  Out tick(const In& in) {
    return {in.x};
  }

 private:
  unsigned _BitInt(129) kept_ = 0;  // refused: greater than 128
};

template struct Synthesize<Refused>;

}  // namespace steplock
