// six_step_axi as a SystemC module made of its C++ block: the ports that `verilator --sc` gives the
// RTL, by name and type, and on every clock the same values.
//
//     clk rises   ->  the state that show() worked out is taken
//     an input or the state changes  ->  show(): outputs of this clock, and the state after it
//
// An input that changes in the very delta cycle of the edge belongs to the next clock.
//
// Doc: docs/systemc.md   Test: tests/testbench/CMakeLists.txt
#pragma once

#include <cstdint>
#include <systemc>

#include "hls/bus/six_step_axi.hpp"

namespace steplock {

class SixStepAxiModule : public sc_core::sc_module {
 public:
  template <class T>
  using In = sc_core::sc_in<T>;
  template <class T>
  using Out = sc_core::sc_out<T>;

  In<bool> clk{"clk"}, rst{"rst"};
  In<bool> pins_comparator_u_i{"pins_comparator_u_i"}, pins_comparator_v_i{"pins_comparator_v_i"},
      pins_comparator_w_i{"pins_comparator_w_i"}, pins_limit_i{"pins_limit_i"},
      pins_fault_i{"pins_fault_i"}, pins_hall_u_i{"pins_hall_u_i"}, pins_hall_v_i{"pins_hall_v_i"},
      pins_hall_w_i{"pins_hall_w_i"};
  In<std::uint32_t> clock_khz_i{"clock_khz_i"};
  In<bool> axi_awvalid_i{"axi_awvalid_i"}, axi_wvalid_i{"axi_wvalid_i"},
      axi_bready_i{"axi_bready_i"}, axi_arvalid_i{"axi_arvalid_i"}, axi_rready_i{"axi_rready_i"};
  In<std::uint32_t> axi_awaddr_i{"axi_awaddr_i"}, axi_wdata_i{"axi_wdata_i"},
      axi_wstrb_i{"axi_wstrb_i"}, axi_araddr_i{"axi_araddr_i"};
  Out<bool> gates_uh_o{"gates_uh_o"}, gates_ul_o{"gates_ul_o"}, gates_vh_o{"gates_vh_o"},
      gates_vl_o{"gates_vl_o"}, gates_wh_o{"gates_wh_o"}, gates_wl_o{"gates_wl_o"};
  Out<bool> interrupt_o{"interrupt_o"}, locked_o{"locked_o"}, fault_o{"fault_o"};
  Out<bool> axi_awready_o{"axi_awready_o"}, axi_wready_o{"axi_wready_o"},
      axi_bvalid_o{"axi_bvalid_o"}, axi_arready_o{"axi_arready_o"}, axi_rvalid_o{"axi_rvalid_o"};
  Out<std::uint32_t> axi_bresp_o{"axi_bresp_o"}, axi_rdata_o{"axi_rdata_o"},
      axi_rresp_o{"axi_rresp_o"};

  SC_HAS_PROCESS(SixStepAxiModule);
  explicit SixStepAxiModule(sc_core::sc_module_name name) : sc_module(name) {
    SC_METHOD(take);
    sensitive << clk.pos();
    dont_initialize();
    SC_METHOD(show);
    sensitive << taken_ << pins_comparator_u_i << pins_comparator_v_i << pins_comparator_w_i
              << pins_limit_i << pins_fault_i << pins_hall_u_i << pins_hall_v_i << pins_hall_w_i
              << clock_khz_i << axi_awvalid_i << axi_awaddr_i << axi_wvalid_i << axi_wdata_i << axi_wstrb_i
              << axi_bready_i << axi_arvalid_i << axi_araddr_i << axi_rready_i;
  }

 private:
  void take() {
    block_ = rst.read() ? SixStepAxi{} : next_;
    taken_.notify(sc_core::SC_ZERO_TIME);
  }

  void show() {
    next_ = block_;
    const SixStepAxi::Out out = next_.tick(inputs());
    gates_uh_o = out.gates.uh;
    gates_ul_o = out.gates.ul;
    gates_vh_o = out.gates.vh;
    gates_vl_o = out.gates.vl;
    gates_wh_o = out.gates.wh;
    gates_wl_o = out.gates.wl;
    interrupt_o = out.interrupt;
    locked_o = out.locked;
    fault_o = out.fault;
    axi_awready_o = out.axi.awready;
    axi_wready_o = out.axi.wready;
    axi_bvalid_o = out.axi.bvalid;
    axi_bresp_o = std::uint32_t(out.axi.bresp.raw());
    axi_arready_o = out.axi.arready;
    axi_rvalid_o = out.axi.rvalid;
    axi_rdata_o = std::uint32_t(out.axi.rdata.raw());
    axi_rresp_o = std::uint32_t(out.axi.rresp.raw());
  }

  SixStepAxi::In inputs() const {
    return {.pins = {.comparator_u = pins_comparator_u_i.read(),
                     .comparator_v = pins_comparator_v_i.read(),
                     .comparator_w = pins_comparator_w_i.read(),
                     .limit = pins_limit_i.read(),
                     .fault = pins_fault_i.read(),
                     .hall_u = pins_hall_u_i.read(),
                     .hall_v = pins_hall_v_i.read(),
                     .hall_w = pins_hall_w_i.read()},
            .clock_khz = UInt<20>::of(clock_khz_i.read() & 0xfffff),
            .axi = {.awvalid = axi_awvalid_i.read(),
                    .awaddr = UInt<12>::of(axi_awaddr_i.read() & 0xfff),
                    .wvalid = axi_wvalid_i.read(),
                    .wdata = UInt<32>::of(axi_wdata_i.read()),
                    .wstrb = UInt<4>::of(axi_wstrb_i.read() & 0xf),
                    .bready = axi_bready_i.read(),
                    .arvalid = axi_arvalid_i.read(),
                    .araddr = UInt<12>::of(axi_araddr_i.read() & 0xfff),
                    .rready = axi_rready_i.read()}};
  }

  SixStepAxi block_, next_;
  sc_core::sc_event taken_;
};

}  // namespace steplock
