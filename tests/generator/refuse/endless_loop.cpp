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
    for (;;) {  // refused: the loop has no bound
      kept_ = wrap<UInt<8>>(kept_ + in.x);
    }
  }

 private:
  UInt<8> kept_ = 0;
};

template struct Synthesize<Refused>;

}  // namespace steplock
