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
    const auto place = reinterpret_cast<std::uintptr_t>(&kept_);  // refused: the address of a register escapes
    kept_ = in.x;
    return {static_cast<unsigned>(place >> 4)};
  }

 private:
  UInt<8> kept_ = 0;
};

template struct Synthesize<Refused>;

}  // namespace steplock
