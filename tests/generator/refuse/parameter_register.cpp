#include "hls/numeric/block.hpp"
#include "hls/numeric/parameter.hpp"

namespace steplock {

class Refused {
 public:
  struct In {
    bool counts = false;
  };
  struct Out {
    bool counts = false;
  };
  Out tick(const In& in) {
    counts_ = in.counts;
    return {counts_};
  }

 private:
  Parameter<false> counts_;  // refused: parameter 'counts_' is no member of an In
};

template struct Synthesize<Refused>;

}  // namespace steplock
