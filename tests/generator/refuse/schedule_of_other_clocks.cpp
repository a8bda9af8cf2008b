#include "hls/numeric/block.hpp"
#include "hls/numeric/scheduled.hpp"

namespace steplock {

class Refused {  // refused: takes 9 clocks under its budget, not 5; write .clocks = 9
 public:
  struct In {
    Int<8> x = 0;
    Int<8> y = 0;
  };
  struct Out {
    Int<16> product = 0;
  };
  Out tick(const In& in) { return {in.x * in.y}; }
};

template struct Synthesize<Scheduled<Refused, Budget{.clocks = 5}>>;

}  // namespace steplock
