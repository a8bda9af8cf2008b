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
    kept_.whole = in.x.raw();
    return {kept_.part};
  }

 private:
  union Overlaid {
    int whole = 0;
    std::uint8_t part;
  };
  Overlaid kept_;  // refused: a union
};

template struct Synthesize<Refused>;

}  // namespace steplock
