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
constexpr std::array kAnalogNames = {
    "iu_a",          "iv_a",      "iw_a",    "vu_v",  "vv_v",        "vw_v",      "neutral_v", "bus_v",
    "torque_mnm", "load_mnm", "theta_deg", "speed_rpm", "drive_speed_rpm", "duty_percent",
    "phase_error_deg"};
// An FST "string" is drawn as its text; the length given here is not used for it.
constexpr std::uint32_t kAnyLength = 0;

}  // namespace

TraceWriter::TraceWriter(const std::string& path, int pole_pairs)
    : file_(fstWriterCreate(path.c_str(), 1)), pole_pairs_(pole_pairs) {
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
  for (std::size_t i = 0; i < pins_.size(); ++i) {
    pins_[i].handle = variable(FST_VT_VCD_WIRE, 1, kPinNames[i]);
  }
  step_.handle = variable(FST_VT_VCD_WIRE, 3, "step");
  crossing_.handle = variable(FST_VT_VCD_WIRE, 1, "crossing");
  missed_.handle = variable(FST_VT_VCD_WIRE, 1, "missed");
  locked_.handle = variable(FST_VT_VCD_WIRE, 1, "locked");
  state_.handle = variable(FST_VT_GEN_STRING, kAnyLength, "state");
  reason_.handle = variable(FST_VT_GEN_STRING, kAnyLength, "reason");
  fstWriterSetUpscope(file_);
  fstWriterSetScope(file_, FST_ST_VCD_MODULE, "plant", nullptr);
  for (std::size_t i = 0; i < analog_.size(); ++i) {
    analog_[i].handle = variable(FST_VT_VCD_REAL, 8, kAnalogNames[i]);
  }
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

void TraceWriter::text(Signal& s, std::uint32_t code, const char* name) {
  if (s.written && s.last == code) return;
  fstWriterEmitVariableLengthValueChange(file_, s.handle, name,
                                         static_cast<std::uint32_t>(std::strlen(name)));
  s.last = code;
  s.written = true;
}

void TraceWriter::real(Analog& a, double value) {
  // Single precision is more than a wave shows, and the zero bits below it pack well.
  value = static_cast<float>(value);
  if (a.written && a.last == value) return;
  fstWriterEmitValueChange(file_, a.handle, &value);
  a.last = value;
  a.written = true;
}

void TraceWriter::logic(double time, const plant::Pins& pins) {
  at(time);
  for (std::size_t k = 0; k < 3; ++k) {
    bits(pins_[k], pins.comparator[k], 1);
    bits(pins_[4 + k], pins.hall[k], 1);
  }
  bits(pins_[3], pins.limit, 1);
}

void TraceWriter::logic(const Sample& s) {
  at(s.time);
  for (std::size_t i = 0; i < gates_.size(); ++i) bits(gates_[i], s.watch.bits >> i & 1, 1);
  bits(step_, static_cast<std::uint32_t>(s.watch.step()), 3);
  bits(crossing_, s.watch.crossing(), 1);
  bits(missed_, s.watch.missed(), 1);
  bits(locked_, s.watch.locked(), 1);
  text(state_, static_cast<std::uint32_t>(s.watch.state()), name_of(s.watch.state()));
  text(reason_, static_cast<std::uint32_t>(s.watch.reason()), name_of(s.watch.reason()));
}

void TraceWriter::analog(const Sample& s) {
  at(s.time);
  const plant::State& p = s.plant;
  const double turn = std::floor(p.electrical_angle / (2 * std::numbers::pi));
  const std::array values = {
      p.current[0], p.current[1], p.current[2], p.voltage[0], p.voltage[1], p.voltage[2], p.neutral,
      p.bus_voltage, 1e3 * p.torque, 1e3 * s.load_nm,
      degrees(p.electrical_angle) - 360 * turn, rpm(p.speed),
      rpm_of_steps(s.drive.steps_per_second, pole_pairs_), 100 * s.drive.duty,
      s.drive.phase_error_deg};
  for (std::size_t i = 0; i < values.size(); ++i) real(analog_[i], values[i]);
}

std::string gtkwave_save_file(const std::string& wave_name) {
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
  trace("22", "drive", "step", "[2:0]");
  for (const char* name : {"locked", "crossing", "missed"}) trace("28", "drive", name, "");
  group("Gates");
  for (const char* name : kGateNames) trace("28", "drive", name, "");
  group("Pins");
  for (const char* name : kPinNames) trace("28", "drive", name, "");
  group("Motor");
  for (const char* name : kAnalogNames) curve(name);
  return text;
}

}  // namespace steplock
