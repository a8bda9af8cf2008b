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
    UInt<8> y = in.x;
    while (y.raw() % 7 != 3) {  // refused: the loop has no bound
      y = wrap<UInt<8>>(y * y + 1);
    }
    return {y};
  }

 private:
};

template struct Synthesize<Refused>;

}  // namespace steplock
