#include "hls/numeric/bits.hpp"
#include "hls/numeric/block.hpp"

namespace steplock {

class Refused {
 public:
  struct In {
    UInt<8> x = 0;
  };
  struct Out {
    int y;  // refused: output 'y' may be left without a value
  };
  Out tick(const In& in) {
    Out out;
    if (in.x.raw() > 3) out.y = 7;
    return out;
  }

 private:
};

template struct Synthesize<Refused>;

}  // namespace steplock
