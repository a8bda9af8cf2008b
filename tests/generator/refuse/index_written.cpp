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
    shadow_[in.x.raw()] = in.x;  // refused: the index may leave the array of 100
    return {shadow_[3]};
  }

 private:
  UInt<8> shadow_[100] = {};
};

template struct Synthesize<Refused>;

}  // namespace steplock
