// Writes a run as an FST wave; a GTKWave save file to go with it groups and scales the signals.
//
// Logic (gates, pins, step, state) changes at its own clock; analog values are sampled.  Times are in
// picoseconds.  Signals keep the names of the drive's ports.
//
// Doc: docs/report.md   Test: tests/testbench/trace_writer_test.cpp
#pragma once

#include <array>
#include <cstdint>
#include <string>

#include "testbench/run/record.hpp"

namespace steplock {

class TraceWriter {
 public:
  // Throws std::runtime_error if the file cannot be made.
  TraceWriter(const std::string& path, int pole_pairs);
  TraceWriter(const TraceWriter&) = delete;
  TraceWriter& operator=(const TraceWriter&) = delete;
  ~TraceWriter();  // closes the file, complete up to the last write

  void logic(const Sample&);  // gates, step, state and strobes
  void logic(double time, const plant::Pins&);
  void analog(const Sample&);

 private:
  struct Signal {
    std::uint32_t handle = 0, last = 0;
    bool written = false;
  };
  struct Analog {
    std::uint32_t handle = 0;
    double last = 0;
    bool written = false;
  };
  void at(double time);
  void bits(Signal&, std::uint32_t value, int width);
  void text(Signal&, std::uint32_t code, const char* name);
  void real(Analog&, double value);

  void* file_;
  int pole_pairs_;
  std::uint64_t now_ps_ = 0;
  std::array<Signal, 6> gates_;
  std::array<Signal, 7> pins_;
  Signal step_, crossing_, missed_, locked_, state_, reason_;
  std::array<Analog, 15> analog_;
};

// The save file for the wave of that name in the same directory.
std::string gtkwave_save_file(const std::string& wave_name);

}  // namespace steplock
