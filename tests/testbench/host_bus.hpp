// What every test of the C driver against an RTL behind AXI4-Lite needs: the driver's view of a master, and
// gates and answers as they stand at the Verilated top's pins.
#pragma once

#include "model/plant/plant.hpp"
#include "rtl/host/steplock.h"
#include "testbench/bus/axi_master.hpp"

namespace steplock {

// `master` has to outlive what the driver does with it.
template <class Clock>
steplock_bus driver_bus(AxiMaster<Clock>& master) {
  using Master = AxiMaster<Clock>;
  return {.write = [](void* self, std::uint32_t offset, std::uint32_t value) {
            return static_cast<Master*>(self)->write(offset, value).okay ? 0 : 1;
          },
          .read = [](void* self, std::uint32_t offset, std::uint32_t* value) {
            const auto answer = static_cast<Master*>(self)->read(offset);
            *value = answer.data;
            return answer.okay ? 0 : 1;
          },
          .context = &master};
}

template <class Rtl>
void reset_rtl(Rtl& rtl) {
  rtl.rst = 1;
  rtl.eval();
  rtl.clk = 1;
  rtl.eval();
  rtl.rst = 0;
}

template <class Rtl>
plant::Gates gates_at(const Rtl& rtl) {
  return {.uh = rtl.gates_uh_o != 0, .ul = rtl.gates_ul_o != 0,
          .vh = rtl.gates_vh_o != 0, .vl = rtl.gates_vl_o != 0,
          .wh = rtl.gates_wh_o != 0, .wl = rtl.gates_wl_o != 0};
}

template <class Rtl>
AxiAnswers answers_at(const Rtl& rtl) {
  return {.awready = rtl.axi_awready_o != 0,
          .wready = rtl.axi_wready_o != 0,
          .bvalid = rtl.axi_bvalid_o != 0,
          .bresp = rtl.axi_bresp_o,
          .arready = rtl.axi_arready_o != 0,
          .rvalid = rtl.axi_rvalid_o != 0,
          .rdata = rtl.axi_rdata_o,
          .rresp = rtl.axi_rresp_o};
}

}  // namespace steplock
