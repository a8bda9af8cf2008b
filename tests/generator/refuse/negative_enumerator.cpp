#include "hls/numeric/bits.hpp"
#include "hls/numeric/block.hpp"

namespace steplock {

enum class Turn : int { kBack = -1, kNone, kForward };

class Refused {
 public:
  struct In {
    UInt<8> x = 0;
  };
  struct Out {
    UInt<8> y = 0;
  };
  Out tick(const In& in) {
    return {in.x};
  }

 private:
  Turn turn_ = Turn::kNone;  // refused: 'turn_' has a negative enumerator
};

template struct Synthesize<Refused>;

}  // namespace steplock
