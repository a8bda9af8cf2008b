// The register map (hls/bus/six_step_registers.hpp) as text, for those who cannot read C++.
//
//     markdown    docs/registers.md         c_header   rtl/host/steplock_registers.h
//     systemrdl   rtl/host/steplock.rdl     ip_xact    rtl/host/steplock.xml (IEEE 1685-2014)
//
// Doc: docs/registers.md   Test: tests/testbench/registers_test.cpp
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "hls/bus/six_step_registers.hpp"
#include "hls/sinusoidal/spi_adc.hpp"
#include "hls/sinusoidal/words.hpp"

namespace steplock::registers {

// A register: its fields from the lowest bit up.
struct Register {
  std::string name;
  int address = 0;
  Access access = Access::kReadOnly;  // of its writable fields, or read-only
  std::uint32_t reset = 0, mask = 0;
  std::vector<Field> fields;
};
std::vector<Register> registers();  // by address

std::string markdown();
std::string c_header();
std::string systemrdl();
std::string ip_xact();

// The words of a drive as initialisers of `struct steplock_word`, by address.
std::string words_c_header(const Words&, const std::string& name, double clock_hz);
// The same words as constants: a module six_step_fixed, which is six_step_bare with all words tied.
std::string words_verilog(const Words&, const std::string& name, double clock_hz);
// Likewise sinusoidal_fixed around sinusoidal_bare and its converter.
std::string words_verilog(const SinusoidalWords&, const SpiAdcWords&, const std::string& name,
                          double clock_hz);

// In the texts.
const char* access_name(Access);
std::string lower(std::string);

}  // namespace steplock::registers
