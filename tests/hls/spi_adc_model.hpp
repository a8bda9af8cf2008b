// An ADC that answers bit by bit as the AD7928's data sheet says, and counts what its master does wrong.
#pragma once

#include <deque>
#include <functional>
#include <map>
#include <random>
#include <utility>

#include "hls/sinusoidal/spi_adc.hpp"

namespace steplock {

// 12 bits, 8 channels: holds its input when cs_n falls, drives DOUT after falling edges of SCLK, reads DIN
// at them, and converts next time the channel that a frame has written.
class SpiAdcModel {
 public:
  struct Pins {
    bool cs_n = true, sclk = true, mosi = false;
  };
  std::function<int(int channel, long clock)> input;  // 0 .. 4095
  int delay = 1;                                      // clocks from an edge to the line, at least 1
  SpiAdcConfig config;                                  // what the pins' times are judged by
  std::map<int, long> held;                           // clock, by channel
  int violations = 0;                                 // of the interface's rules
  int frames = 0;

  // Somebody has turned its supply off and on.
  void reset() {
    channel_ = int(any_() % 8);
    asleep_ = 2;
  }

  bool clock(const Pins& pins) {
    ++now_;
    const int half = int(config.half.raw());
    if (pins.sclk != sclk_ && now_ - sclk_changed_ < half) ++violations;
    if (pins.mosi != mosi_ && sclk_ && !pins.sclk) ++violations;
    if (pins.mosi != mosi_ && !pins.cs_n && !pins.sclk) ++violations;  // holds while low
    if (cs_n_ && !pins.cs_n) begin(pins);
    if (!cs_n_ && pins.cs_n) end(pins);
    if (!pins.cs_n && sclk_ && !pins.sclk) falls(pins.mosi);
    if (pins.sclk != sclk_) sclk_changed_ = now_;
    if (pins.cs_n != cs_n_) cs_changed_ = now_;
    cs_n_ = pins.cs_n, sclk_ = pins.sclk, mosi_ = pins.mosi;
    while (!line_.empty() && line_.front().first <= now_) {
      miso_ = line_.front().second;
      line_.pop_front();
    }
    return miso_;
  }
  long now() const { return now_; }

 private:
  void begin(const Pins& pins) {
    if (!pins.sclk || (frames > 0 && now_ - cs_changed_ < int(config.quiet.raw()))) ++violations;
    held[channel_] = now_;
    const int code = input(channel_, now_) ^ (binary_ ? 0 : 2048);
    answer_ = asleep_ > 0 ? int(any_() & 0xffff) : channel_ << 12 | code;
    edges_ = written_ = 0;
    drive();
  }
  void falls(bool mosi) {
    if (edges_ == 0 && now_ - cs_changed_ < int(config.half.raw())) ++violations;
    if (++edges_ <= 12) written_ = written_ << 1 | int(mosi);
    // WRITE, SEQ, -, ADD, PM, SHADOW, -, RANGE, CODING
    if (edges_ == 12 && asleep_ == 0 && (written_ & 0x800)) {
      channel_ = written_ >> 6 & 7;
      binary_ = written_ & 1;
      if ((written_ >> 4 & 3) != 3 || (written_ & 0x408)) ++violations;  // normal mode, no sequence
      if (((written_ >> 1 & 1) == 0) != config.twice) ++violations;
    }
    drive();
  }
  void end(const Pins&) {
    if (edges_ != 16) ++violations;
    if (asleep_ > 0) {
      if (written_ != 0xfff) ++violations;
      --asleep_;
    }
    ++frames;
  }
  void drive() {
    line_.push_back({now_ + delay - 1, edges_ < 16 ? answer_ >> (15 - edges_) & 1 : bool(any_() & 1)});
  }

  std::mt19937 any_{1};
  int channel_ = 5, asleep_ = 2;  // unknown at power-up
  bool binary_ = false;
  int answer_ = 0, edges_ = 0, written_ = 0;
  bool cs_n_ = true, sclk_ = true, mosi_ = false, miso_ = false;
  long now_ = 0, sclk_changed_ = -1000, cs_changed_ = -1000;
  std::deque<std::pair<long, bool>> line_;
};

}  // namespace steplock
