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
    const double scaled = in.x.raw() * 0.3;  // refused: floating point
    kept_ = static_cast<int>(scaled);
    return {kept_};
  }

 private:
  UInt<8> kept_ = 0;
};

template struct Synthesize<Refused>;

}  // namespace steplock
