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
    return {kRules[in.x.bit(0)](in.x)};  // refused: a call through a pointer
  }

 private:
  static UInt<8> same(UInt<8> x) { return x; }
  static UInt<8> other(UInt<8> x) { return ~x; }
  static constexpr UInt<8> (*kRules[])(UInt<8>) = {same, other};
};

template struct Synthesize<Refused>;

}  // namespace steplock
