// The wires between a drive, its host's bus and its motor; `bind` ties them to six_step_axi, to the
// module that `verilator --sc` makes of the RTL as well as to the one made of the C++ block.
//
// Doc: docs/systemc.md   Test: tests/testbench/CMakeLists.txt
#pragma once

#include <cstdint>
#include <systemc>

namespace steplock {

struct DriveSignals {
  template <class T>
  using Signal = sc_core::sc_signal<T>;

  Signal<bool> comparator[3], limit, fault, hall[3];
  Signal<std::uint32_t> clock_khz;  // constant
  Signal<bool> gate[6];  // uh, ul, vh, vl, wh, wl
  Signal<bool> interrupt, locked, latched;
  Signal<bool> awvalid, awready, wvalid, wready, bvalid, bready, arvalid, arready, rvalid, rready;
  Signal<std::uint32_t> awaddr, wdata, wstrb, bresp, araddr, rdata, rresp;

  template <class Drive>
  void bind(Drive& drive) {
    drive.pins_comparator_u_i(comparator[0]);
    drive.pins_comparator_v_i(comparator[1]);
    drive.pins_comparator_w_i(comparator[2]);
    drive.pins_limit_i(limit);
    drive.pins_fault_i(fault);
    drive.pins_hall_u_i(hall[0]);
    drive.pins_hall_v_i(hall[1]);
    drive.pins_hall_w_i(hall[2]);
    drive.clock_khz_i(clock_khz);
    drive.gates_uh_o(gate[0]);
    drive.gates_ul_o(gate[1]);
    drive.gates_vh_o(gate[2]);
    drive.gates_vl_o(gate[3]);
    drive.gates_wh_o(gate[4]);
    drive.gates_wl_o(gate[5]);
    drive.interrupt_o(interrupt);
    drive.locked_o(locked);
    drive.fault_o(latched);
    drive.axi_awvalid_i(awvalid);
    drive.axi_awready_o(awready);
    drive.axi_awaddr_i(awaddr);
    drive.axi_wvalid_i(wvalid);
    drive.axi_wready_o(wready);
    drive.axi_wdata_i(wdata);
    drive.axi_wstrb_i(wstrb);
    drive.axi_bvalid_o(bvalid);
    drive.axi_bready_i(bready);
    drive.axi_bresp_o(bresp);
    drive.axi_arvalid_i(arvalid);
    drive.axi_arready_o(arready);
    drive.axi_araddr_i(araddr);
    drive.axi_rvalid_o(rvalid);
    drive.axi_rready_i(rready);
    drive.axi_rdata_o(rdata);
    drive.axi_rresp_o(rresp);
  }

  // All that a drive shows, for comparing two of them.
  bool shows_same(const DriveSignals& o) const {
    for (int i = 0; i < 6; ++i) {
      if (gate[i].read() != o.gate[i].read()) return false;
    }
    const auto same = [](const auto& a, const auto& b) { return a.read() == b.read(); };
    return same(interrupt, o.interrupt) && same(locked, o.locked) && same(latched, o.latched) &&
           same(awready, o.awready) && same(wready, o.wready) && same(bvalid, o.bvalid) &&
           same(bresp, o.bresp) && same(arready, o.arready) && same(rvalid, o.rvalid) &&
           same(rdata, o.rdata) && same(rresp, o.rresp);
  }
};

}  // namespace steplock
