#include "hls/numeric/bits.hpp"
#include "hls/numeric/block.hpp"

namespace steplock {

enum class Mode : std::uint8_t { kOff, kSlow, kFast };

class Refused {
 public:
  struct In {
    UInt<8> x = 0;
  };
  struct Out {
    UInt<8> y = 0;
  };
  Out tick(const In& in) {
    mode_ = static_cast<Mode>(static_cast<unsigned>(mode_) + 1);
    return {static_cast<unsigned>(mode_) + in.x.raw()};
  }

 private:
  Mode mode_ = Mode::kOff;  // refused: 'mode_' may take a value that is no enumerator
};

template struct Synthesize<Refused>;

}  // namespace steplock
