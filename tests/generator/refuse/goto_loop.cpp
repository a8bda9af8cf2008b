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
    int i = in.x.raw();
    if (i > 9) goto middle;
  top:
    kept_ = wrap<UInt<8>>(kept_ + i);  // refused: jumps that form a loop
  middle:
    if ((i += 3) < 100) goto top;
    return {kept_};
  }

 private:
  UInt<8> kept_ = 0;
};

template struct Synthesize<Refused>;

}  // namespace steplock
