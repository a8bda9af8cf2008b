// One group, named by the build: GROUP, MODULE, VERILATED and their headers; PACE is more than 1 where
// its blocks take several clocks.

#include "tests/generator/random/group.hpp"

#include GROUP_HEADER
#include PORTS_HEADER
#include VERILATED_HEADER

#include "testbench/lockstep.hpp"

namespace hlsgen::test {
namespace {

namespace ports = steplock::ports;

class Compiled : public Forms {
 public:
  Words clock(const Words& in, bool is_wrong, const char*& differing) override {
    std::size_t i = 0;
    in_.each([&](auto& number) { ports::set_number(number, in.at(i++)); });
    ports::MODULE::drive_ports(rtl_.ports(), in_);
    rtl_.settle();
    auto out = cpp_.tick(in_);
    if (is_wrong) turn_first_bit(out);
    differing = ports::MODULE::differs(rtl_.ports(), out);
    rtl_.edge();
    Words words;
    out.each([&](auto& number) { words.push_back(ports::word_of(number, 128)); });
    return words;
  }

 private:
  using Group = steplock::test::GROUP;

  static void turn_first_bit(Group::Out& out) {
    bool is_first = true;
    out.each([&](auto& number) {
      if (is_first) ports::set_number(number, ports::word_of(number, 128) ^ 1);
      is_first = false;
    });
  }

  Group cpp_;
  Group::In in_;
  steplock::Lockstep<VERILATED> rtl_;
};

}  // namespace

std::unique_ptr<Forms> make_forms() { return std::make_unique<Compiled>(); }
const char* const kGroupSource = GROUP_SOURCE;
const int kPace = PACE;

}  // namespace hlsgen::test
