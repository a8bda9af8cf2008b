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
    int sum;
    sum += in.x.raw();  // refused: uninitialized
    return {sum};
  }

 private:
};

template struct Synthesize<Refused>;

}  // namespace steplock
