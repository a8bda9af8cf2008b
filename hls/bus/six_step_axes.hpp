// Several six-step drives on one AXI4-Lite slave: an axis per 256 bytes, wires between the blocks.
//
//     AXI4-Lite -> AxiLite -> axis address[9:8] -> SixStepCsr -> gates of that axis
//
// Each axis has the whole map of docs/six_step_registers.md at 0x100 times its number: words, faults, heartbeat
// watchdog and interrupt of its own.  Axes share the clock, reset and the bus, and nothing else: a
// request reaches one of them, and none hears of another's.  Behind the last axis there are holes.
// CAPABILITY.axes of each says how many there are.
//
//     fault pin to the axis' six gates off    3 clocks, as without the bus
//     write of CONTROL to the drive           2 clocks
//
// Doc: docs/blocks/six_step_axes.md   Test: tests/hls/six_step_axes_test.cpp

#pragma once

#include <array>

#include "hls/bus/axi_lite.hpp"
#include "hls/bus/six_step_axi.hpp"
#include "hls/bus/six_step_csr.hpp"

namespace steplock {

template <int Axes = 2>
class SixStepAxes {
  static_assert(Axes >= 1 && Axes <= 4);

 public:
  struct In {
    Parts with;  // of all axes
    std::array<Synchroniser::Pins, Axes> pins;  // asynchronous
    Kilohertz clock_khz = 0;  // constant: what CLOCK of each shows
    AxiLite::In axi;
  };

  using Axi = AxiAnswers;

  struct Axis {
    Gates gates;
    bool interrupt = false;  // level
    bool locked = false;     // running under speed control
    bool fault = false;      // the drive's fault is latched
  };

  struct Out {
    std::array<Axis, Axes> axis;
    Axi axi;
  };

  Out tick(const In& in) {
    const auto bus = axi_.tick(in.axi);
    const BusRequest& request = bus.request;
    const auto axis = request.index.template slice<9, 6>();
    const bool hole = axis >= Axes;

    Out out;
    out.axi = {.awready = bus.awready, .wready = bus.wready, .bvalid = bus.bvalid,
               .bresp = write_hole_ ? UInt<2>(2) : UInt<2>(0),
               .arready = bus.arready, .rvalid = bus.rvalid,
               .rdata = 0, .rresp = read_hole_ ? UInt<2>(2) : UInt<2>(0)};
    for (int k = 0; k < Axes; ++k) {
      const bool here = axis == UInt<4>(k);
      BusRequest own = request;
      own.write = request.write && here;
      own.read = request.read && here;
      own.index = UInt<10>(request.index.template slice<5, 0>());
      const auto drive = drives_[k].tick({.with = in.with, .pins = in.pins[k], .clock_khz = in.clock_khz, .request = own});
      out.axis[k] = {.gates = drive.gates,
                     .interrupt = drive.interrupt,
                     .locked = drive.locked,
                     .fault = drive.fault};
      if (write_axis_ == UInt<2>(k) && drive.write_error) out.axi.bresp = 2;
      if (read_axis_ == UInt<2>(k) && !read_hole_) {
        out.axi.rdata = read_capability_ ? with_axes(drive.data) : drive.data;
        if (drive.read_error) out.axi.rresp = 2;
      }
    }

    if (request.write) {
      write_axis_ = axis.template slice<1, 0>();
      write_hole_ = hole;
    }
    if (request.read) {
      read_axis_ = axis.template slice<1, 0>();
      read_hole_ = hole;
      read_capability_ = request.index.template slice<5, 0>() == UInt<6>(index_of("CAPABILITY"));
    }
    return out;
  }

 private:
  // A drive takes itself for the only one.
  static UInt<32> with_axes(UInt<32> capability) {
    constexpr Field kAxes = field("CAPABILITY", "axes");
    return (capability & UInt<32>::of(~mask_of(kAxes))) | UInt<32>(Axes << kAxes.lsb);
  }

  AxiLite axi_;
  std::array<SixStepCsr, Axes> drives_;
  UInt<2> write_axis_ = 0;   // whose answer is shown
  UInt<2> read_axis_ = 0;
  bool write_hole_ = false;  // there is none
  bool read_hole_ = false;
  bool read_capability_ = false;
};

}  // namespace steplock
