// SPI slave, mode 0: a frame of 56 bits to one request, and nothing of the registers behind.
//
//     write    1 000 aaaaaaaaaaaa   32 bits of data   -> 8 bits of status
//     read     0 000 aaaaaaaaaaaa   -> 8 bits of status, 32 bits of data
//
// Highest bit first; a is an address in bytes whose lowest two bits do not count.  Status is 0x5a, or
// 0x5e for a hole or a refused write; a line that stands still shows neither.  A write is asked for
// with its last data bit, a read with its last address bit.  cs_n up ends a frame: one that was cut
// before has written nothing.  What comes after the 56th bit is ignored.
//
// The pins are asynchronous: two flip-flops each, and sclk's edges are seen in the core's clock.
//
//     sclk         f_clk / 8 at most: high and low for 4 clocks each
//     cs_n         low 2 clocks before sclk rises, high for 2 clocks between frames
//     latency      sclk falls to miso 3 clocks at most; last bit to request 3, of a read 4
//     registers    59 bits     multipliers  none
//
// Doc: docs/blocks/spi.md   Test: tests/hls/spi_test.cpp   Proof: tests/proofs/spi.sv

#pragma once

#include "hls/bus/bus.hpp"

namespace steplock {

class Spi {
 public:
  struct Pins {
    bool cs_n = true;
    bool sclk = false;
    bool mosi = false;
  };

  // What the registers answered, a clock ago: in a register of the top, which cuts the way through both.
  struct Reply {
    bool bit = false;    // at `place` of the read's answer
    bool error = false;  // of the present frame's answer
  };

  struct In {
    Pins pins;  // asynchronous
    Reply reply;
  };

  struct Out {
    bool miso = false;      // pin
    bool selected = false;  // miso is to be driven, where several slaves share it
    bool writing = false;   // the present frame is a write
    UInt<5> place = 0;      // of the data bit that is wanted
    BusRequest request;     // answered in the next clock
  };

  Out tick(const In& in) {
    const bool selected = !second_.cs_n;
    const bool rises = selected && second_.sclk && !was_high_;
    const bool falls = selected && !second_.sclk && was_high_;
    const Out out{.miso = miso_,
                  .selected = selected,
                  .writing = write_,
                  .place = ~wrap<UInt<5>>(bits_ + kFirstData),
                  .request = {.write = asks_ && write_,
                              .read = asks_ && !write_,
                              .index = index_,
                              .data = shift_,
                              .strobes = 15}};

    // After the 16th and the 48th bit.
    asks_ = (headed_ && !shift_.bit(15)) || (rises && bits_ == 47 && write_);
    if (headed_) {
      write_ = shift_.bit(15);
      index_ = shift_.slice<11, 2>();
    }
    headed_ = rises && bits_ == 15;

    if (!selected) {
      miso_ = false;
    } else if (falls) {
      miso_ = shows_status() ? status(in.reply.error) : !write_ && shows_data() && in.reply.bit;
    }
    if (rises) shift_ = (shift_ << 1) | UInt<32>(second_.mosi ? 1 : 0);
    if (!selected) {
      bits_ = 0;
      write_ = false;
    } else if (rises && bits_ != kBits) {
      bits_ = wrap<UInt<6>>(bits_ + 1);
    }
    was_high_ = second_.sclk;
    second_ = first_;
    first_ = in.pins;
    return out;
  }

  bool operator==(const Spi&) const = default;

 private:
  static constexpr int kBits = 56;
  static constexpr int kFirstData = 8;  // the 24th bit is place 31: place = 31 - (bits - 24) mod 32

  bool shows_status() const {
    return bits_.slice<5, 3>() == UInt<3>(write_ ? 6 : 2);
  }
  bool shows_data() const { return bits_ >= 24 && bits_ != kBits; }

  // 0x5a, or 0x5e.
  bool status(bool error) const {
    switch (bits_.slice<2, 0>().raw()) {
      case 1: return true;
      case 3: return true;
      case 4: return true;
      case 5: return error;
      case 6: return true;
      default: return false;
    }
  }

  Pins first_;              // synchroniser
  Pins second_;
  bool was_high_ = false;   // sclk, in the clock before
  UInt<6> bits_ = 0;        // of this frame
  UInt<32> shift_ = 0;      // the last bits
  bool headed_ = false;     // one clock: the head has come
  bool asks_ = false;       // one clock
  bool write_ = false;
  WordIndex index_ = 0;
  bool miso_ = false;
};

// What is to be replied in the next clock.
template <class Csr>
Spi::Reply spi_reply(const Spi::Out& bus, const Csr& drive) {
  return {.bit = drive.data.bit(int(bus.place.raw())),
          .error = bus.writing ? drive.write_error : drive.read_error};
}

// What a top shows of the bus.
struct SpiAnswers {
  bool miso = false;
  bool selected = false;  // drive miso now, where several slaves share it
};
inline SpiAnswers spi_answers(const Spi::Out& bus) {
  return {.miso = bus.miso, .selected = bus.selected};
}

}  // namespace steplock
