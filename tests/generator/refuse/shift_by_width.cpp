#include "hls/numeric/bits.hpp"
#include "hls/numeric/block.hpp"

namespace steplock {

class Refused {
 public:
  struct In {
    UInt<8> x = 0;
  };
  struct Out {
    std::uint32_t y = 0;
  };
  Out tick(const In& in) {
    return {in.x.raw() << 40};  // refused: shift count
  }

 private:
};

template struct Synthesize<Refused>;

}  // namespace steplock
