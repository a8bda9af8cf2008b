// A host with the C driver of rtl/host, at the initiator's end of TLM-2.0: what firmware does on a
// virtual platform.
//
//     words, interrupt enabled, set speed, start  ->  interrupt `started`  ->  0.1 s
//                                                 ->  telemetry  ->  stop
//
// A step that fails ends it, and is its outcome; so is an interrupt that stays away for 0.5 s.
//
// Doc: docs/systemc.md   Test: tests/testbench/CMakeLists.txt
#pragma once

#include <tlm_utils/simple_initiator_socket.h>

#include <cstdint>
#include <string>
#include <systemc>
#include <tlm>
#include <utility>
#include <vector>

#include "rtl/host/steplock.h"

namespace steplock {

class HostModule : public sc_core::sc_module {
 public:
  struct Plan {
    std::vector<steplock_word> config;
    std::uint32_t speed = 0;  // as steplock_speed() gives it
    double settle_s = 0;      // from the lock to the set speed
  };

  tlm_utils::simple_initiator_socket<HostModule, 32> socket{"socket"};
  sc_core::sc_in<bool> interrupt{"interrupt"};

  SC_HAS_PROCESS(HostModule);
  HostModule(sc_core::sc_module_name name, Plan plan) : sc_module(name), plan_(std::move(plan)) {
    SC_THREAD(run);
  }

  const std::string& failure() const { return failure_; }  // empty: all went well
  double started_s() const { return started_s_; }
  std::uint32_t frequency() const { return telemetry_.frequency; }
  bool done() const { return done_; }
  const sc_core::sc_event& done_event() const { return done_event_; }
  sc_core::sc_event measured;  // telemetry was just taken: the motor is at its set speed

 private:
  void run() {
    failure_ = work();
    done_ = true;
    done_event_.notify(sc_core::SC_ZERO_TIME);
  }

  // What failed.
  std::string work() {
    using sc_core::sc_time;
    const steplock_bus bus = {
        .write = &HostModule::write, .read = &HostModule::read, .context = this};
    if (steplock_init(&bus, plan_.config.data(), plan_.config.size()) != STEPLOCK_OK) return "init";
    // The map has nothing behind its last register: a bus error, which the drive survives.
    std::uint32_t nothing = 0;
    if (read(this, 0xffc, &nothing) == 0) return "a hole in the map was answered";
    if (steplock_enable_interrupts(&bus, STEPLOCK_INTERRUPT_STARTED_MASK) != STEPLOCK_OK)
      return "enable";
    if (steplock_set_speed(&bus, plan_.speed) != STEPLOCK_OK) return "set speed";
    if (steplock_start(&bus, 0) != STEPLOCK_OK) return "start";
    wait(sc_time(0.5, sc_core::SC_SEC), interrupt.posedge_event());
    if (!interrupt.read()) return "no interrupt";
    std::uint32_t events = 0;
    if (steplock_take_interrupts(&bus, &events) != STEPLOCK_OK) return "take interrupts";
    started_s_ = sc_core::sc_time_stamp().to_seconds();
    wait(sc_time(plan_.settle_s, sc_core::SC_SEC));
    if (steplock_get_telemetry(&bus, &telemetry_) != STEPLOCK_OK) return "telemetry";
    measured.notify(sc_core::SC_ZERO_TIME);
    if (steplock_stop(&bus, 0) != STEPLOCK_OK) return "stop";
    wait(sc_time(1, sc_core::SC_MS));
    steplock_status status;
    if (steplock_get_status(&bus, &status) != STEPLOCK_OK) return "status";
    return status.stopped != 0 ? "" : "not stopped";
  }

  static int write(void* self, std::uint32_t offset, std::uint32_t value) {
    return static_cast<HostModule*>(self)->transfer(tlm::TLM_WRITE_COMMAND, offset, &value);
  }
  static int read(void* self, std::uint32_t offset, std::uint32_t* value) {
    return static_cast<HostModule*>(self)->transfer(tlm::TLM_READ_COMMAND, offset, value);
  }
  int transfer(tlm::tlm_command command, std::uint32_t offset, std::uint32_t* value) {
    tlm::tlm_generic_payload payload;
    payload.set_command(command);
    payload.set_address(offset);
    payload.set_data_ptr(reinterpret_cast<unsigned char*>(value));
    payload.set_data_length(4);
    payload.set_streaming_width(4);
    sc_core::sc_time delay = sc_core::SC_ZERO_TIME;
    socket->b_transport(payload, delay);
    wait(delay);
    return payload.is_response_ok() ? 0 : 1;
  }

  Plan plan_;
  std::string failure_;
  double started_s_ = 0;
  steplock_telemetry telemetry_{};
  bool done_ = false;
  sc_core::sc_event done_event_;
};

}  // namespace steplock
