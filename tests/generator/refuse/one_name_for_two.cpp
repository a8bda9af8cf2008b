#include "hls/numeric/bits.hpp"
#include "hls/numeric/block.hpp"

namespace steplock {

namespace one {
class Child {
 public:
  struct In {
    bool go = false;
  };
  struct Out {
    UInt<4> count = 0;
  };
  Out tick(const In& in) {
    if (in.go) count_ = wrap<UInt<4>>(count_ + 1);
    return {count_};
  }
  UInt<4> count_ = 0;
};
}  // namespace one
namespace two {
class Child {  // refused: would be printed as module 'child'
 public:
  struct In {
    bool go = false;
  };
  struct Out {
    UInt<4> count = 0;
  };
  Out tick(const In& in) {
    if (in.go) count_ = wrap<UInt<4>>(count_ + 1);
    return {count_};
  }
  UInt<4> count_ = 0;
};
}  // namespace two

class Refused {
 public:
  struct In {
    UInt<8> x = 0;
  };
  struct Out {
    UInt<8> y = 0;
  };
  Out tick(const In& in) {
    return {a_.tick({in.x == 1}).count ^ b_.tick({in.x == 2}).count};
  }

 private:
  one::Child a_;
  two::Child b_;
};

template struct Synthesize<Refused>;

}  // namespace steplock
