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
    for (int i = 0; i < 1000; ++i) {  // refused: the loop and those within it unroll to
      for (int k = 0; k < 60; ++k) kept_ = wrap<UInt<8>>(kept_ * in.x + i + k);
    }
    return {kept_};
  }

 private:
  UInt<8> kept_ = 0;
};

template struct Synthesize<Refused>;

}  // namespace steplock
