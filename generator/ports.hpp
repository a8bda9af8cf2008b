// Prints <module>_ports.hpp: how the block's In and Out meet the ports of its Verilated module.
//
//     drive_ports(rtl, in)      every input port from its member of In
//     differs(rtl, out)         the name of the first output port that is not its member of Out, or
//     null randomise(in, stimulus)   every member of In from stimulus.bits(width)
//
// A parameter is no port: both leave its member as it is.
//
// The header knows neither the block's header nor Verilator's: all types are template parameters.
//
// Doc: docs/generator.md   Test: tests/generator/frontend/ports_test.cpp

#pragma once

#include <string>

#include "generator/netlist.hpp"

namespace hlsgen {

std::string print_ports(const Module& module);

}  // namespace hlsgen
