#include "testbench/run/trace_writer.hpp"

#include <fmt/format.h>
#include <gtkwave/fstapi.h>

#include <cmath>
#include <cstring>
#include <numbers>
#include <stdexcept>

#include "testbench/run/units.hpp"

namespace steplock {
namespace {

constexpr std::array kGateNames = {"uh", "ul", "vh", "vl", "wh", "wl"};
constexpr std::array kPinNames = {"comparator_u", "comparator_v", "comparator_w", "limit",
                                  "hall_u",       "hall_v",       "hall_w"};
// An FST "string" is drawn as its text; the length given here is not used for it.
constexpr std::uint32_t kAnyLength = 0;

}  // namespace

TraceWriter::TraceWriter(const std::string& path, const WaveTable& table, int pole_pairs)
    : file_(fstWriterCreate(path.c_str(), 1)), table_(table), pole_pairs_(pole_pairs) {
  if (file_ == nullptr) throw std::runtime_error(path + ": cannot write this file");
  fstWriterSetDate(file_, "");  // the same run gives the same file
  fstWriterSetVersion(file_, "steplock");
  fstWriterSetTimescale(file_, -12);
  fstWriterSetPackType(file_, FST_WR_PT_ZLIB);
  const auto variable = [&](fstVarType type, std::uint32_t width, const char* name) {
    return fstWriterCreateVar(file_, type, FST_VD_OUTPUT, width, name, 0);
  };
  fstWriterSetScope(file_, FST_ST_VCD_MODULE, "drive", nullptr);
  for (std::size_t i = 0; i < gates_.size(); ++i) {
    gates_[i].handle = variable(FST_VT_VCD_WIRE, 1, kGateNames[i]);
  }
  for (std::size_t i = 0; table.pins && i < pins_.size(); ++i) {
    pins_[i].handle = variable(FST_VT_VCD_WIRE, 1, kPinNames[i]);
  }
  for (const WaveTable::Logic& l : table.logic) {
    logic_.push_back({.handle = variable(FST_VT_VCD_WIRE, static_cast<std::uint32_t>(l.width), l.name)});
  }
  state_.handle = variable(FST_VT_GEN_STRING, kAnyLength, "state");
  reason_.handle = variable(FST_VT_GEN_STRING, kAnyLength, "reason");
  fstWriterSetUpscope(file_);
  fstWriterSetScope(file_, FST_ST_VCD_MODULE, "plant", nullptr);
  for (const char* name : table.analog) analog_.push_back({.handle = variable(FST_VT_VCD_REAL, 8, name)});
  fstWriterSetUpscope(file_);
}

TraceWriter::~TraceWriter() { fstWriterClose(file_); }

void TraceWriter::at(double time) {
  const auto ps = static_cast<std::uint64_t>(std::llround(time * 1e12));
  if (ps > now_ps_ || ps == 0) fstWriterEmitTimeChange(file_, ps);
  now_ps_ = std::max(now_ps_, ps);
}

void TraceWriter::bits(Signal& s, std::uint32_t value, int width) {
  if (s.written && s.last == value) return;
  fstWriterEmitValueChange32(file_, s.handle, static_cast<std::uint32_t>(width), value);
  s.last = value;
  s.written = true;
}

void TraceWriter::text(Text& s, const char* name) {
  if (s.last == name) return;  // names are constants
  fstWriterEmitVariableLengthValueChange(file_, s.handle, name,
                                         static_cast<std::uint32_t>(std::strlen(name)));
  s.last = name;
}

void TraceWriter::real(Analog& a, double value) {
  // Single precision is more than a wave shows, and the zero bits below it pack well.
  value = static_cast<float>(value);
  if (a.written && a.last == value) return;
  fstWriterEmitValueChange(file_, a.handle, &value);
  a.last = value;
  a.written = true;
}

void TraceWriter::pins(double time, const plant::Pins& pins) {
  if (!table_.pins) return;
  at(time);
  for (std::size_t k = 0; k < 3; ++k) {
    bits(pins_[k], pins.comparator[k], 1);
    bits(pins_[4 + k], pins.hall[k], 1);
  }
  bits(pins_[3], pins.limit, 1);
}

void TraceWriter::logic(double time, std::uint32_t gate_bits, std::initializer_list<std::uint32_t> values,
                        const char* state, const char* reason) {
  if (values.size() != logic_.size()) throw std::logic_error("not the signals of the wave's table");
  at(time);
  for (std::size_t i = 0; i < gates_.size(); ++i) bits(gates_[i], gate_bits >> i & 1, 1);
  for (std::size_t i = 0; i < logic_.size(); ++i) bits(logic_[i], values.begin()[i], table_.logic[i].width);
  text(state_, state);
  text(reason_, reason);
}

void TraceWriter::analog(double time, std::initializer_list<double> values) {
  if (values.size() != analog_.size()) throw std::logic_error("not the curves of the wave's table");
  at(time);
  for (std::size_t i = 0; i < analog_.size(); ++i) real(analog_[i], values.begin()[i]);
}

double turn_of(double rad) {
  return degrees(rad) - 360 * std::floor(rad / (2 * std::numbers::pi));
}

std::string gtkwave_save_file(const std::string& wave_name, const WaveTable& table) {
  // Flags of GTKWave's format: 22 hexadecimal, 28 binary, 50020 real drawn as an interpolated curve.
  std::string text = fmt::format("[dumpfile] \"{}\"\n[timestart] 0\n*-35.0 0\n", wave_name);
  const auto group = [&](const char* name) { text += fmt::format("@200\n-{}\n", name); };
  const auto trace = [&](const char* flags, const char* scope, const char* name, const char* bits) {
    text += fmt::format("@{}\n{}.{}{}\n", flags, scope, name, bits);
  };
  const auto curve = [&](const char* name) {
    trace("50020", "plant", name, "");
    text += "@20000\n-\n-\n";  // two lines of height
  };
  group("Drive");
  trace("20", "drive", "state", "");
  trace("20", "drive", "reason", "");
  for (const WaveTable::Logic& l : table.logic) {
    l.width == 1 ? trace("28", "drive", l.name, "")
                 : trace("22", "drive", l.name, fmt::format("[{}:0]", l.width - 1).c_str());
  }
  group("Gates");
  for (const char* name : kGateNames) trace("28", "drive", name, "");
  if (table.pins) {
    group("Pins");
    for (const char* name : kPinNames) trace("28", "drive", name, "");
  }
  group("Motor");
  for (const char* name : table.analog) curve(name);
  return text;
}

}  // namespace steplock
