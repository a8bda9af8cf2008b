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
    int sum[2];  // refused: 'sum' may be read before it has a value
    if (in.x != 0) sum[1] = 3;
    return {sum[1]};
  }

 private:
};

template struct Synthesize<Refused>;

}  // namespace steplock
