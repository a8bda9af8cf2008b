#include "hls/numeric/bits.hpp"
#include "hls/numeric/block.hpp"

namespace steplock {

extern const unsigned kOffset;

class Refused {
 public:
  struct In {
    UInt<8> x = 0;
  };
  struct Out {
    UInt<8> y = 0;
  };
  Out tick(const In& in) {
    return {in.x.raw() + kOffset};  // refused: the value of 'steplock::kOffset' is not known here
  }

 private:
};

template struct Synthesize<Refused>;

}  // namespace steplock
