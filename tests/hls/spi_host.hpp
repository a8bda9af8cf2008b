// An SPI host in mode 0 whose clock has nothing to do with the slave's: times are real numbers of the slave's
// clocks.
//
//     Line   bool(const Spi::Pins&): one clock of the slave; what miso shows in it
#pragma once

#include <cstdint>

#include "hls/bus/spi.hpp"

namespace steplock {

struct SpiAnswer {
  int status = 0;
  std::uint32_t data = 0;
};

// The first `bits` of a frame: head and 32 bits of data in the places of a write; the last 40 bits that
// came back.  `half`: half a period of sclk.
template <class Line>
std::uint64_t spi_frame(Line& line, double half, int head, std::uint32_t data, int bits = 56) {
  const std::uint64_t out = std::uint64_t(head) << 40 | std::uint64_t(data) << 8;
  std::uint64_t back = 0;
  Spi::Pins pins{.cs_n = false, .sclk = false, .mosi = false};
  bool miso = false;
  double time = 0;
  long clocks = 0;
  const auto wait = [&](double more) {
    time += more;
    for (; double(clocks) < time; ++clocks) miso = line(pins);
  };
  for (int bit = 0; bit < bits; ++bit) {
    pins.mosi = bit < 56 && (out >> (55 - bit) & 1) != 0;
    wait(half);
    back = back << 1 | (miso ? 1 : 0);  // as it stands when sclk rises
    pins.sclk = true;
    wait(half);
    pins.sclk = false;
  }
  wait(half);
  pins.cs_n = true;
  wait(half);
  return back & 0xff'ffff'ffff;
}

template <class Line>
SpiAnswer spi_write(Line& line, double half, int address, std::uint32_t data) {
  const auto back = spi_frame(line, half, 0x8000 | address, data);
  return {int(back & 0xff), 0};
}
template <class Line>
SpiAnswer spi_read(Line& line, double half, int address) {
  const auto back = spi_frame(line, half, address, 0);
  return {int(back >> 32), std::uint32_t(back)};
}

}  // namespace steplock
