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
    delete kept_from(in);  // refused: memory from the heap
    return {in.x};
  }

 private:
  static const UInt<8>* kept_from(const In& in) { return &in.x; }
};

template struct Synthesize<Refused>;

}  // namespace steplock
