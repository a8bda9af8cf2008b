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
    const UInt<8>* p = values_ + in.x.raw();
    return {*p};  // refused: a pointer is moved by what is only known at run time
  }

 private:
  UInt<8> values_[4] = {1, 2, 3, 4};
};

template struct Synthesize<Refused>;

}  // namespace steplock
