#include "hls/numeric/bits.hpp"
#include "hls/numeric/block.hpp"

namespace steplock {

unsigned lookup(unsigned);

class Refused {
 public:
  struct In {
    UInt<8> x = 0;
  };
  struct Out {
    UInt<8> y = 0;
  };
  Out tick(const In& in) {
    return {lookup(in.x.raw())};  // refused: the body of 'steplock::lookup(unsigned int)' is not known
  }

 private:
};

template struct Synthesize<Refused>;

}  // namespace steplock
