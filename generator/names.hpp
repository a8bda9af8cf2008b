// Names, on their way from C++ to SystemVerilog.  Everything that must agree on a spelling (the
// printers, the lockstep headers, the file names) asks here.
//
//     class SixStepTop            ->  six_step_top          (modules and files)
//     config.kp, an input         ->  config_kp_i           (ports)
//     with.telemetry, a parameter ->  WITH_TELEMETRY
//     history[3], a register      ->  history_3             (registers, instances)
//
// Doc: docs/generator.md   Test: tests/generator/frontend/names_test.cpp

#pragma once

#include <string>
#include <string_view>

#include "generator/netlist.hpp"

namespace hlsgen {

enum class Direction : std::uint8_t { kIn, kOut };

inline constexpr std::string_view kClockPort = "clk";
inline constexpr std::string_view kResetPort = "rst";  // synchronous, active high

// CamelCase -> snake_case; a run of capitals counts as one word (PIControl -> pi_control).
std::string snake_case(std::string_view name);

// The same of a constant, without its k: kPullIn -> pull_in.
std::string constant_name(std::string_view name);

// A C++ path as one identifier: "config.kp" -> "config_kp", "history[3].x" -> "history_3_x".  A
// trailing underscore, which C++ uses to mark private members, is dropped from each part.
std::string flat_name(std::string_view path);

std::string port_name(const Leaf& leaf, Direction direction);

// Whether a Verilog tool would take the word for its own, in whatever case.
bool is_keyword(std::string_view word);

}  // namespace hlsgen
