// Writes a run as an FST wave; a GTKWave save file to go with it groups and scales the signals.
//
// Logic (gates, pins, state) changes at its own clock; analog values are sampled.  Times are in
// picoseconds.  Signals keep the names of the drive's ports.  Which ones a drive has says its table.
//
// Doc: docs/report.md   Test: tests/testbench/trace_writer_test.cpp
#pragma once

#include <array>
#include <cstdint>
#include <initializer_list>
#include <string>
#include <vector>

#include "model/plant/plant.hpp"

namespace steplock {

// Beside the six gates, the state and the reason, which every drive has.
struct WaveTable {
  struct Logic {
    const char* name;
    int width;
  };
  std::vector<Logic> logic;
  bool pins = false;  // comparators, current limit and Hall sensors
  std::vector<const char*> analog;
};

class TraceWriter {
 public:
  // Throws std::runtime_error if the file cannot be made.  The table must live as long.
  TraceWriter(const std::string& path, const WaveTable&, int pole_pairs);
  TraceWriter(const TraceWriter&) = delete;
  TraceWriter& operator=(const TraceWriter&) = delete;
  ~TraceWriter();  // closes the file, complete up to the last write

  // Values in the table's order.
  void logic(double time, std::uint32_t gate_bits, std::initializer_list<std::uint32_t> values, const char* state,
             const char* reason);
  void pins(double time, const plant::Pins&);
  void analog(double time, std::initializer_list<double> values);

  int pole_pairs() const { return pole_pairs_; }

 private:
  struct Signal {
    std::uint32_t handle = 0, last = 0;
    bool written = false;
  };
  struct Text {
    std::uint32_t handle = 0;
    const char* last = nullptr;
  };
  struct Analog {
    std::uint32_t handle = 0;
    double last = 0;
    bool written = false;
  };
  void at(double time);
  void bits(Signal&, std::uint32_t value, int width);
  void text(Text&, const char* name);
  void real(Analog&, double value);

  void* file_;
  const WaveTable& table_;
  int pole_pairs_;
  std::uint64_t now_ps_ = 0;
  std::array<Signal, 6> gates_;
  std::array<Signal, 7> pins_;
  std::vector<Signal> logic_;
  std::vector<Analog> analog_;
  Text state_, reason_;
};

// Degrees within the turn, 0 to 360.
double turn_of(double rad);

// The save file for the wave of that name in the same directory.
std::string gtkwave_save_file(const std::string& wave_name, const WaveTable&);

}  // namespace steplock
