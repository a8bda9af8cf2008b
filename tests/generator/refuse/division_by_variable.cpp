#include "hls/numeric/bits.hpp"
#include "hls/numeric/block.hpp"

namespace steplock {

class Refused {
 public:
  struct In {
    UInt<8> x = 1;
  };
  struct Out {
    UInt<8> y = 0;
  };
  Out tick(const In& in) {
    return {200 / in.x.raw()};  // refused: division by what is only known at run time
  }

 private:
};

template struct Synthesize<Refused>;

}  // namespace steplock
