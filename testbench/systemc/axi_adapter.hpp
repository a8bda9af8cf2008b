// A TLM-2.0 target socket in front of the pins of an AXI4-Lite slave: one blocking transport is one
// transfer.
//
//     socket  ->  awvalid, wvalid, bready / arvalid, rready, on the clock's rising edges
//
//     response  OK, or GENERIC_ERROR   the slave answered SLVERR, or not within kPatience clocks
//               ADDRESS_ERROR          not a multiple of four
//               BURST_ERROR            not four bytes
//               BYTE_ENABLE_ERROR      byte enables on a read; on a write they become strobes
//
// Initiators may share it: transfers wait for one another.  During reset they wait, too.
//
// Doc: docs/systemc.md   Test: tests/testbench/CMakeLists.txt
#pragma once

#include <tlm_utils/simple_target_socket.h>

#include <cstdint>
#include <cstring>
#include <systemc>
#include <tlm>

#include "testbench/systemc/drive_signals.hpp"

namespace steplock {

class AxiAdapter : public sc_core::sc_module {
 public:
  sc_core::sc_in<bool> clk{"clk"}, rst{"rst"};
  tlm_utils::simple_target_socket<AxiAdapter, 32> socket{"socket"};

  AxiAdapter(sc_core::sc_module_name name, DriveSignals& pins) : sc_module(name), pins_(pins) {
    socket.register_b_transport(this, &AxiAdapter::transport);
  }

 private:
  static constexpr int kPatience = 100;  // clocks

  void transport(tlm::tlm_generic_payload& payload, sc_core::sc_time& delay) {
    wait(delay);
    delay = sc_core::SC_ZERO_TIME;
    if (payload.get_address() % 4 != 0) {
      return payload.set_response_status(tlm::TLM_ADDRESS_ERROR_RESPONSE);
    }
    if (payload.get_data_length() != 4 || payload.get_streaming_width() < 4) {
      return payload.set_response_status(tlm::TLM_BURST_ERROR_RESPONSE);
    }
    if (payload.is_read() && payload.get_byte_enable_ptr() != nullptr) {
      return payload.set_response_status(tlm::TLM_BYTE_ENABLE_ERROR_RESPONSE);
    }
    busy_.lock();
    do wait(clk.posedge_event());
    while (rst.read());
    const bool okay = payload.is_read() ? read(payload) : write(payload);
    busy_.unlock();
    payload.set_response_status(okay ? tlm::TLM_OK_RESPONSE : tlm::TLM_GENERIC_ERROR_RESPONSE);
  }

  // What a process reads right after the edge is what stood before it, as for a flip-flop.
  bool write(tlm::tlm_generic_payload& payload) {
    std::uint32_t data = 0, strobes = payload.get_byte_enable_ptr() == nullptr ? 0xf : 0;
    std::memcpy(&data, payload.get_data_ptr(), 4);
    for (unsigned i = 0; strobes != 0xf && i < 4; ++i) {
      const unsigned at = i % payload.get_byte_enable_length();
      if (payload.get_byte_enable_ptr()[at] == TLM_BYTE_ENABLED) strobes |= 1u << i;
    }
    pins_.awaddr = static_cast<std::uint32_t>(payload.get_address());
    pins_.wdata = data;
    pins_.wstrb = strobes;
    show_write(true);
    bool okay = false;
    for (int i = 0; i < kPatience; ++i) {
      wait(clk.posedge_event());
      if (pins_.awready.read()) pins_.awvalid = false;
      if (pins_.wready.read()) pins_.wvalid = false;
      if (!pins_.bvalid.read()) continue;
      okay = pins_.bresp.read() == 0;
      break;
    }
    show_write(false);
    return okay;
  }

  bool read(tlm::tlm_generic_payload& payload) {
    pins_.araddr = static_cast<std::uint32_t>(payload.get_address());
    show_read(true);
    bool okay = false;
    for (int i = 0; i < kPatience; ++i) {
      wait(clk.posedge_event());
      if (pins_.arready.read()) pins_.arvalid = false;
      if (!pins_.rvalid.read()) continue;
      const std::uint32_t data = pins_.rdata.read();
      std::memcpy(payload.get_data_ptr(), &data, 4);
      okay = pins_.rresp.read() == 0;
      break;
    }
    show_read(false);
    return okay;
  }

  void show_write(bool valid) {
    pins_.awvalid = valid;
    pins_.wvalid = valid;
    pins_.bready = valid;
  }
  void show_read(bool valid) {
    pins_.arvalid = valid;
    pins_.rready = valid;
  }

  DriveSignals& pins_;
  sc_core::sc_mutex busy_;
};

}  // namespace steplock
