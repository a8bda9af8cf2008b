#include "hls/numeric/block.hpp"
#include "hls/numeric/scheduled.hpp"

namespace steplock {

class Refused {  // refused: take 9 clocks, not 3; write .early = 9
 public:
  struct In {
    Int<8> x = 0;
    Int<8> y = 0;
  };
  struct Early {
    Int<16> product = 0;
  };
  struct Out {
    Early early;
    Int<16> sum = 0;
  };
  Out tick(const In& in) {
    sum_ = wrap<Int<16>>(sum_ + in.x * in.y);
    return {.early = {in.x * in.y}, .sum = sum_};
  }

 private:
  Int<16> sum_ = 0;
};

template struct Synthesize<Scheduled<Refused, Budget{.clocks = 11, .early = 3}>>;

}  // namespace steplock
