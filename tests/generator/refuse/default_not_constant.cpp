#include "hls/numeric/bits.hpp"
#include "hls/numeric/block.hpp"

namespace steplock {

unsigned seed();

class Refused {
 public:
  struct In {
    UInt<8> x = 0;
  };
  struct Out {
    UInt<8> y = 0;
  };
  Out tick(const In& in) {
    return {in.x};
  }

 private:
  unsigned kept_ = seed();  // refused: the body of 'steplock::seed()' is not known
};

template struct Synthesize<Refused>;

}  // namespace steplock
