#include "hls/numeric/block.hpp"
#include "hls/numeric/scheduled.hpp"

namespace steplock {

class Twice {  // refused: would be printed as module 'twice'
 public:
  struct In {
    Int<8> x = 0;
  };
  struct Out {
    Int<9> y = 0;
  };
  Out tick(const In& in) { return {in.x + in.x}; }
};

class Refused {
 public:
  struct In {
    Int<8> x = 0;
  };
  struct Out {
    Int<9> y = 0;
  };
  Out tick(const In& in) {
    Schedule::In sample;
    sample.x = in.x;
    return {wrap<Int<9>>(own_.tick({in.x}).y + scheduled_.tick(sample).y)};
  }

 private:
  using Schedule = Scheduled<Twice, Budget{.clocks = 2}>;
  Twice own_;
  Schedule scheduled_;
};

template struct Synthesize<Refused>;

}  // namespace steplock
