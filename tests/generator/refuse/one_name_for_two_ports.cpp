#include "hls/numeric/bits.hpp"
#include "hls/numeric/block.hpp"

namespace steplock {

class Refused {
 public:
  struct Gain {
    UInt<8> kp = 0;
  };
  struct In {
    Gain gain;
    UInt<8> gain_kp = 0;  // refused: both 'gain.kp' and 'gain_kp' would be printed as port
  };
  struct Out {
    UInt<8> y = 0;
  };
  Out tick(const In& in) { return {in.gain.kp ^ in.gain_kp}; }
};

template struct Synthesize<Refused>;

}  // namespace steplock
