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
    kept_ = in.x.raw();
    return {kept_};
  }

 private:
  unsigned kept_ : 8 = 0;  // refused: bit-field 'kept_'
};

template struct Synthesize<Refused>;

}  // namespace steplock
