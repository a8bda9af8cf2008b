#include "hls/numeric/bits.hpp"
#include "hls/numeric/block.hpp"

namespace steplock {

unsigned total = 0;

class Refused {
 public:
  struct In {
    UInt<8> x = 0;
  };
  struct Out {
    UInt<8> y = 0;
  };
  Out tick(const In& in) {
    total += in.x.raw();  // refused: state outside the registers: 'steplock::total'
    return {total};
  }

 private:
};

template struct Synthesize<Refused>;

}  // namespace steplock
