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
    __atomic_fetch_add(&kept_, in.x.raw(), __ATOMIC_RELAXED);  // refused: atomic
    return {kept_};
  }

 private:
  unsigned kept_ = 0;
};

template struct Synthesize<Refused>;

}  // namespace steplock
