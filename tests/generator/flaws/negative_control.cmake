# Proof and linters must be able to fail: this runs them on files with a known flaw.
#
#   cmake -D ROOT=<tree> -D RTL=<readable> -D PLAIN=<plain> -P negative_control.cmake

function(expect_failure what said)
  execute_process(COMMAND ${ARGN} WORKING_DIRECTORY ${WORK}
                  RESULT_VARIABLE code OUTPUT_VARIABLE out ERROR_VARIABLE out)
  if(NOT code EQUAL 1 OR NOT out MATCHES "${said}")
    message(FATAL_ERROR "${what} was not found (exit code ${code}):\n${out}")
  endif()
  message(STATUS "found: ${what}")
endfunction()

# Writes a file with the first `from` of another replaced.
function(write_changed changed original from to)
  file(READ ${original} text)
  string(FIND "${text}" "${from}" at)
  if(at EQUAL -1)
    message(FATAL_ERROR "${original} has no '${from}' to change")
  endif()
  string(LENGTH "${from}" length)
  math(EXPR end "${at} + ${length}")
  string(SUBSTRING "${text}" 0 ${at} head)
  string(SUBSTRING "${text}" ${end} -1 tail)
  file(WRITE ${changed} "${head}${to}${tail}")
endfunction()

# A plain print that differs from the readable one in a single place.
function(expect_difference what module from to)
  write_changed(${WORK}/plain/${module}.sv ${PLAIN}/${module}.sv "${from}" "${to}")
  expect_failure("${what}" "${ARGN}" ${ROOT}/tools/prove_print ${RTL} ${WORK}/plain ${module})
endfunction()

set(WORK ${CMAKE_CURRENT_BINARY_DIR}/negative_control)
file(REMOVE_RECURSE ${WORK})

expect_difference("a changed operator" vco_counter " + " " - " "NOT EQUIVALENT")
expect_difference("a changed constant" gate_guard "'b1100;" "'b1101;" "NOT EQUIVALENT")
expect_difference("a changed comparison" pwm_generator " < " " <= " "NOT EQUIVALENT")
expect_difference("a changed factor" sinusoidal_control ") * $signed(" ") * -$signed(" "NOT EQUIVALENT")
expect_difference("a part that stays with a parameter of 0" telemetry " = COUNTS;" " = 1'b1;" "NOT EQUIVALENT")
expect_difference("a child that has another parameter" six_step_top "(WITH_TELEMETRY)" "(WITH_RAMP)" "child's parameters")

# A map that makes the same wrong product of both sides would hide such a factor.
function(expect_no_product what from to)
  set(map ${WORK}/map.v)
  write_changed(${map} ${ROOT}/tools/rows_of_adders.v "${from}" "${to}")
  expect_failure("${what}" "no product" ${ROOT}/tests/generator/rows_of_adders.sh ${map})
endfunction()
expect_no_product("a lost carry" "(sum[i] ^ part[i])" "sum[i]")
expect_no_product("a row shifted the wrong way" "a << row" "a >> row")
expect_no_product("a sign that is none" "A_SIGNED && " "")

file(WRITE ${WORK}/unused.sv "module unused_input (input logic a, output logic y);\n"
     "  assign y = 1'b0;\nendmodule\n")
file(RENAME ${WORK}/unused.sv ${WORK}/unused_input.sv)
file(WRITE ${WORK}/unused_input.f "unused_input.sv\n")
expect_failure("an input nothing reads" "UNUSED" ${ROOT}/tools/lint_rtl unused_input.f)

file(WRITE ${WORK}/selects.sv "module selects (input logic [1:0] a, output logic y);\n"
     "  logic z;\n  always_comb z = a[0] && a[1];\n  assign y = z;\nendmodule\n")
file(WRITE ${WORK}/selects.f "selects.sv\n")
expect_failure("a select that Icarus does not follow" "Icarus" ${ROOT}/tools/lint_rtl selects.f)

file(WRITE ${WORK}/twice.sv "module twice (input logic a, input logic b, output logic y);\n"
     "  assign y = a;\n  assign y = b;\nendmodule\n")
file(WRITE ${WORK}/twice.f "twice.sv\n")
expect_failure("two drivers of one wire" "Yosys" ${ROOT}/tools/lint_rtl twice.f)
