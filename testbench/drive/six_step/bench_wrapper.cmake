# cmake -D TOP=rtl/six_step_top.sv -D OUT=six_step_bench.sv -P bench_wrapper.cmake
#
# Prints a module around the top for simulation.  Verilator evaluates all logic behind an input at every
# eval(), and the hundreds of bits of configuration and command hardly ever change: here they pass registers,
# taken at the clock's edge while `load` is high, which cuts the time to a third and changes nothing
# else.  Pins go straight through (they end in registers inside).  Every change of `toggle` gives
# whole clocks in one eval(), each begun by the end of the last, until the counter `given` is at
# `until_given` or `watch_o` has changed.  `watch_o` gathers what the bench compares at every clock, in
# the places of testbench/drive/six_step/watch.hpp; all outputs show their values while `look` is high, and
# else what they last showed, because copying them takes a twentieth of the time.

cmake_minimum_required(VERSION 3.25)

file(STRINGS ${TOP} ports REGEX "^ +(input|output) +logic")
set(declarations "")
set(latches "")
set(registers "")
set(shown "")
set(connections "")
foreach(port IN LISTS ports)
  string(REGEX MATCH "^ +(input|output) +logic +(\\[[0-9:]+\\])? *([A-Za-z0-9_]+)" found "${port}")
  set(direction ${CMAKE_MATCH_1})
  set(range "${CMAKE_MATCH_2}")
  set(name ${CMAKE_MATCH_3})
  if(NOT name STREQUAL "clk")
    string(APPEND declarations "    ${direction} logic ${range} ${name},\n")
  endif()
  if(name MATCHES "^(config|command)_")
    string(APPEND registers "  logic ${range} ${name}_held;\n")
    string(APPEND latches "      ${name}_held <= ${name};\n")
    list(APPEND connections ".${name}(${name}_held)")
  elseif(direction STREQUAL "output")
    string(APPEND registers "  logic ${range} ${name}_now;\n")
    string(APPEND shown "      ${name} = ${name}_now;\n")
    list(APPEND connections ".${name}(${name}_now)")
  else()
    list(APPEND connections ".${name}(${name})")
  endif()
endforeach()
list(JOIN connections ",\n      " connections)

file(WRITE ${OUT}
"// Printed by testbench/drive/six_step/bench_wrapper.cmake; for simulation only.
module six_step_bench (
    input logic toggle,
    input logic load,
    input logic look,
    input logic [15:0] until_given,
    output logic [15:0] given,
${declarations}    output logic [31:0] watch_o
);
${registers}
  logic fell, rose;
  logic [19:0] seen;
  wire clk = toggle ^ fell ^ rose;
  always_ff @(posedge clk) begin
    rose <= ~rose;
    given <= given + 16'd1;
    seen <= watch_o[19:0];
    if (load) begin
${latches}    end
  end

  // Blocking, so that the clock rises in the same round in which it fell: 3 % of the time.
  always @(negedge clk) if (given != until_given && watch_o[19:0] == seen) fell = ~fell;

  six_step_top top (
      ${connections});

  always_latch begin
    if (look) begin
${shown}    end
  end

  assign watch_o = {12'd0, locked_o_now, missed_o_now, crossing_o_now, reason_o_now, state_o_now,
                    step_o_now, gates_wl_o_now, gates_wh_o_now, gates_vl_o_now, gates_vh_o_now,
                    gates_ul_o_now, gates_uh_o_now};
endmodule
")
