#include "hls/numeric/block.hpp"
#include "hls/numeric/scheduled.hpp"

namespace steplock {

class Refused {
 public:
  struct In {
    Int<8> x = 0;
    bool start = false;  // refused: would be printed as port 'start_i', which a schedule needs
  };
  struct Out {
    Int<16> product = 0;
  };
  Out tick(const In& in) { return {in.start ? in.x * in.x : Int<16>(0)}; }
};

template struct Synthesize<Scheduled<Refused, Budget{.clocks = 3}>>;

}  // namespace steplock
