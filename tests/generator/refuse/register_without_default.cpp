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
    const int before = kept_;
    kept_ = in.x.raw();
    return {before};
  }

 private:
  int kept_;  // refused: register 'kept_' has no default value
};

template struct Synthesize<Refused>;

}  // namespace steplock
