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
  void tick(const In& in, Out& out) {  // refused: tick is not of the form of a block
    out.y = in.x;
  }

 private:
};

template <>
struct Synthesize<Refused> {
  static Refused reset() { return {}; }
  static void tick(Refused& block, const Refused::In& in, Refused::Out& out) {
    block.tick(in, out);
  }
};
Refused (*use)() = Synthesize<Refused>::reset;

}  // namespace steplock
