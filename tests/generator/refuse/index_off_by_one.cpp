#include "hls/numeric/bits.hpp"
#include "hls/numeric/block.hpp"

#include <array>

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
    if (in.x.raw() <= 6) kept_ = table_[in.x.raw()];  // refused: the index may leave the array of 6
    return {kept_};
  }

 private:
  UInt<8> kept_ = 0;
  std::array<UInt<8>, 6> table_ = {1, 2, 3, 4, 5, 6};
};

template struct Synthesize<Refused>;

}  // namespace steplock
