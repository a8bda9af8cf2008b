// Hosts of a bus with one transfer under way at a time, as tests/hls/bus_traffic.hpp has them, of any drive.
#pragma once

#include <cstdint>

#include "hls/bus/apb.hpp"
#include "hls/bus/axi_lite.hpp"
#include "hls/bus/wishbone.hpp"
#include "tests/hls/bus_traffic.hpp"

namespace steplock {

template <class TheTop, class TheMap>
struct WishboneHost {
  using Top = TheTop;
  using Map = TheMap;
  static constexpr int kPhases = 1;
  static constexpr int kClocks = 3;  // of a transfer at most
  static void idle(typename Top::In& in) { in.wb = {}; }
  static void show(typename Top::In& in, const Transfer& t, int phase) {
    (void)phase;
    in.wb = {.cyc = true, .stb = true, .we = t.write, .adr = t.address, .dat = t.data, .sel = t.strobes};
  }
  static Answer answer(const typename Top::Out& out) {
    return {.done = out.wb.ack || out.wb.err, .error = out.wb.err, .data = std::uint32_t(out.wb.dat.raw())};
  }
};

template <class TheTop, class TheMap>
struct ApbHost {
  using Top = TheTop;
  using Map = TheMap;
  static constexpr int kPhases = 2;
  static constexpr int kClocks = 3;  // of a transfer at most
  static void idle(typename Top::In& in) { in.apb = {}; }
  static void show(typename Top::In& in, const Transfer& t, int phase) {
    in.apb = {.psel = true, .penable = phase > 0, .pwrite = t.write, .paddr = t.address, .pwdata = t.data, .pstrb = t.strobes};
  }
  static Answer answer(const typename Top::Out& out) {
    return {.done = out.apb.pready, .error = out.apb.pslverr, .data = std::uint32_t(out.apb.prdata.raw())};
  }
};

// Ready comes in the clock after valid, and the answer one later.
template <class TheTop, class TheMap>
struct AxiHost {
  using Top = TheTop;
  using Map = TheMap;
  static constexpr int kPhases = 3;
  static constexpr int kClocks = 3;
  static void idle(typename Top::In& in) { in.axi = {}; }
  static void show(typename Top::In& in, const Transfer& t, int phase) {
    in.axi = {.bready = true, .rready = true};
    in.axi.awvalid = in.axi.wvalid = t.write && phase < 2;
    in.axi.arvalid = !t.write && phase < 2;
    in.axi.awaddr = in.axi.araddr = t.address;
    in.axi.wdata = t.data;
    in.axi.wstrb = t.strobes;
  }
  static Answer answer(const typename Top::Out& out) {
    const AxiAnswers& axi = out.axi;
    return {.done = axi.bvalid || axi.rvalid, .error = (axi.bvalid ? axi.bresp : axi.rresp) != UInt<2>(0),
            .data = std::uint32_t(axi.rdata.raw())};
  }
};

}  // namespace steplock
