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
    for (int i = 0; i < 5000; ++i) {  // refused: the loop may run 5000 times
      kept_ = wrap<UInt<8>>(kept_ * in.x + i);
    }
    return {kept_};
  }

 private:
  UInt<8> kept_ = 0;
};

template struct Synthesize<Refused>;

}  // namespace steplock
