// systemc_example DRIVE.toml [model|rtl|both|late]: a host on TLM-2.0 starts, measures and stops a
// motor through six_step_axi in SystemC.
//
// `both` runs the C++ block and the RTL side by side and compares all they show on every clock, up
// to the first that differs; `late` is its control, with the block's reset one clock longer. Exit
// code 0: everything went well.
//
// Doc: docs/systemc.md   Test: tests/testbench/CMakeLists.txt
#include <Vsix_step_axi.h>

#include <cmath>
#include <cstdio>
#include <memory>
#include <string>
#include <systemc>

#include "testbench/systemc/bench.hpp"
#include "testbench/systemc/six_step_axi_module.hpp"

namespace steplock {
namespace {

using Model = Bench<SixStepAxiModule>;
using Rtl = Bench<Vsix_step_axi>;

// Clock, reset, and the end: when every host is done.
class System : public sc_core::sc_module {
 public:
  SC_HAS_PROCESS(System);
  System(sc_core::sc_module_name name, const design::Settings& s, const std::string& what)
      : sc_module(name),
        clock_("clock", sc_core::sc_time(1 / s.control.clock_hz, sc_core::SC_SEC)),
        late_(what == "late") {
    if (what != "rtl") add(model_, "model", s, model_rst_);
    if (what != "model") add(rtl_, "rtl", s, rtl_rst_);
    SC_THREAD(supervise);
    if (model_ && rtl_) {
      SC_METHOD(compare);
      sensitive << clock_.negedge_event();
      dont_initialize();
    }
  }

  bool judge(double wanted_rpm) const {
    bool well = true;
    if (model_) well = report("model", *model_, wanted_rpm) && well;
    if (rtl_) well = report("rtl", *rtl_, wanted_rpm) && well;
    if (model_ && rtl_) {
      std::printf("model and RTL: %s on %llu clocks\n", differs_ ? "not equal" : "equal",
                  compared_);
      well = well && !differs_ && compared_ > 0;
    }
    return well;
  }

 private:
  template <class Any>
  void add(std::unique_ptr<Any>& bench, const char* name, const design::Settings& s,
           sc_core::sc_signal<bool>& rst) {
    bench = std::make_unique<Any>(name, s);
    bench->clk(clock_);
    bench->rst(rst);
  }

  void supervise() {
    model_rst_ = true;
    rtl_rst_ = true;
    for (int i = 0; i < 4; ++i) wait(clock_.posedge_event());
    rtl_rst_ = false;
    if (late_) wait(clock_.posedge_event());
    model_rst_ = false;
    in_reset_ = false;
    while (model_ && !model_->host.done()) wait(model_->host.done_event());
    while (rtl_ && !rtl_->host.done()) wait(rtl_->host.done_event());
    sc_core::sc_stop();
  }

  void compare() {
    if (in_reset_) return;
    ++compared_;
    if (model_->wires.shows_same(rtl_->wires)) return;
    differs_ = true;
    sc_core::sc_stop();
  }

  template <class Any>
  static bool report(const char* name, const Any& bench, double wanted_rpm) {
    const HostModule& host = bench.host;
    const bool well = host.done() && host.failure().empty();
    const std::string end = well          ? "stopped"
                            : host.done() ? "failed: " + host.failure()
                                          : "not at its end";
    std::printf("%s: started after %.3f s, %.0f r/min of %.0f, %s\n", name, host.started_s(),
                bench.measured_rpm(), wanted_rpm, end.c_str());
    return well && bench.motor.shoot_throughs() == 0 &&
           std::abs(bench.measured_rpm() - wanted_rpm) < 0.05 * wanted_rpm;
  }

  sc_core::sc_clock clock_;
  sc_core::sc_signal<bool> model_rst_{"model_rst"}, rtl_rst_{"rtl_rst"};
  std::unique_ptr<Model> model_;
  std::unique_ptr<Rtl> rtl_;
  bool late_, in_reset_ = true, differs_ = false;
  unsigned long long compared_ = 0;
};

}  // namespace
}  // namespace steplock

int sc_main(int count, char** arguments) {
  const std::string what = count == 3 ? arguments[2] : "both";
  if (count < 2 || count > 3 ||
      (what != "model" && what != "rtl" && what != "both" && what != "late")) {
    return std::fprintf(stderr, "systemc_example: want DRIVE.toml [model|rtl|both|late]\n"), 2;
  }
  try {
    const auto settings = steplock::load_drive_file(arguments[1]).settings;
    steplock::System system("system", settings, what);
    sc_core::sc_start();
    return system.judge(settings.scenario.speed_rpm) ? 0 : 1;
  } catch (const steplock::BadInput& problem) {
    return std::fprintf(stderr, "%s\n", problem.what()), 1;
  }
}
