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
  float gain_ = 1;  // refused: 'gain_' is floating point
};

template struct Synthesize<Refused>;

}  // namespace steplock
