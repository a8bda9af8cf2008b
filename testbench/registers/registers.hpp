// The register maps (hls/bus/six_step_registers.hpp, sinusoidal_registers.hpp) as text, for those who cannot
// read C++.
//
//                 six_step()                           sinusoidal()
//     markdown    docs/six_step_registers.md                    docs/sinusoidal_registers.md
//     c_header    rtl/host/steplock_registers.h        rtl/host/steplock_sinusoidal_registers.h
//     systemrdl   rtl/host/steplock.rdl                rtl/host/steplock_sinusoidal.rdl
//     ip_xact     the registers of rtl/host/steplock.xml and steplock_sinusoidal.xml (IEEE 1685-2014; tools/ip_xact)
//
// Doc: docs/six_step_registers.md   Test: tests/testbench/registers_test.cpp
#pragma once

#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <tuple>
#include <type_traits>
#include <vector>

#include "hls/bus/sinusoidal_registers.hpp"
#include "hls/bus/six_step_registers.hpp"
#include "hls/sinusoidal/spi_adc.hpp"
#include "hls/sinusoidal/config.hpp"

namespace steplock::registers {

// A register: its fields from the lowest bit up.
struct Register {
  std::string name;
  int address = 0;
  Access access = Access::kReadOnly;  // of its writable fields, or read-only
  std::uint32_t reset = 0, mask = 0;
  std::vector<Field> fields;
};
// A map, and what its texts call it.
struct Map {
  std::span<const Field> fields;
  const char* drive;     // "six-step"
  const char* top;       // "six_step_axi"
  const char* option;    // of `steplock registers`
  const char* stem;      // of its files in rtl/host
  const char* prefix;    // of its names in C
};
const Map& six_step();
const Map& sinusoidal();

std::vector<Register> registers(const Map&);  // by address

std::string markdown(const Map&);
std::string c_header(const Map&);
std::string systemrdl(const Map&);
std::string ip_xact(const Map&);

// What a map says of a drive's words: registers by address.
template <class Table>
std::map<int, std::uint32_t> values_of(const typename Table::Config& config) {
  std::map<int, std::uint32_t> values;
  const auto place = [&](const auto& row) {
    using Word = typename std::remove_cvref_t<decltype(row)>::Word;
    values[row.address] |= static_cast<std::uint32_t>(bits_of(Word::of(config)).raw()) << row.lsb;
  };
  std::apply([&](const auto&... row) { (place(row), ...); }, Table::kWordRows);
  return values;
}

// The words of a drive as initialisers of `struct steplock_word`, by address.
std::string config_c_header(const SixStepConfig&, const std::string& name, double clock_hz);
std::string config_c_header(const SinusoidalConfig&, const std::string& name, double clock_hz);
// The same as a list for $readmemh, a register a line: 64 bits, its offset in the upper ones, its value in the lower ones.
std::string config_mem(const SixStepConfig&, const std::string& name, double clock_hz);
std::string config_mem(const SinusoidalConfig&, const std::string& name, double clock_hz);
// The same words as constants: a module six_step_fixed, which is six_step_standalone with all words tied.
std::string config_verilog(const SixStepConfig&, const std::string& name, double clock_hz);
// Likewise sinusoidal_fixed around sinusoidal_standalone and its ADC.
std::string config_verilog(const SinusoidalConfig&, const SpiAdcConfig&, const std::string& name,
                          double clock_hz);

// In the texts.
std::string page_of(const Map&);  // docs/...
const char* access_name(Access);
std::string lower(std::string);

}  // namespace steplock::registers
