# Random programs, each group of blocks one top: written, generated, verilated and compiled in the build.
# A group of 80 takes two CPU minutes, most of them to build: two are written, and twelve blocks as programs.
# -D RANDOM_SEEDS="161;241;1001" adds groups of 80 from these seeds on.
find_package(verilator REQUIRED HINTS /usr/share/verilator)
add_library(random_writer STATIC random/program.cpp random/tables.cpp random/statements.cpp random/expressions.cpp)
add_executable(random_programs random/random_programs.cpp)
target_link_libraries(random_programs PRIVATE random_writer)
add_executable(programs_test random/programs_test.cpp)
target_link_libraries(programs_test PRIVATE random_writer GTest::gtest_main)
gtest_discover_tests(programs_test DISCOVERY_TIMEOUT 60)
add_library(random_harness OBJECT random/random_test.cpp)
target_compile_definitions(random_harness PRIVATE HLSGEN_ROOT="${PROJECT_SOURCE_DIR}")
target_link_libraries(random_harness PUBLIC hlsgen_lib GTest::gtest_main)

# random_test(random|compiled <first seed> <count>): hlsgen says how many clocks programs take, and
# their C++ is written again with them.
function(random_test kind first count)
  set(name ${kind}_${first})
  set(group RandomGroup${first})
  set(pace 1)
  if(kind STREQUAL compiled)
    set(group CompiledGroup${first})
    set(pace 40)
  endif()
  set(directory ${CMAKE_CURRENT_BINARY_DIR}/random)
  set(module ${kind}_group${first})
  set(header ${directory}/${name}.hpp)
  set(source ${directory}/${name}.cpp)
  set(list ${directory}/rtl/${name}.f)
  set(model ${directory}/V${name})
  file(MAKE_DIRECTORY ${model})
  set(numeric ${PROJECT_SOURCE_DIR}/hls/numeric)
  if(NOT kind STREQUAL random)
    set(draft ${directory}/draft/${name})
    set(clocks ${draft}.clocks)
    file(MAKE_DIRECTORY ${directory}/draft)
    add_custom_command(OUTPUT ${clocks}
      COMMAND random_programs ${first} ${count} ${draft} ${kind}
      COMMAND hlsgen ${draft}.cpp -I ${PROJECT_SOURCE_DIR} -o ${directory}/rtl
              --ports ${directory}/ports --any-clocks --schedules > ${clocks}
      DEPENDS hlsgen random_programs ${numeric}/scheduled.hpp
      VERBATIM)
    add_custom_command(OUTPUT ${header} ${source} ${list}
      COMMAND random_programs ${first} ${count} ${directory}/${name} ${kind} ${clocks}
      COMMAND ${CMAKE_COMMAND} -E touch ${list}
      DEPENDS ${clocks}
      VERBATIM)
  else()
    add_custom_command(OUTPUT ${header} ${source}
      COMMAND random_programs ${first} ${count} ${directory}/${name}
      DEPENDS random_programs
      VERBATIM)
    add_custom_command(OUTPUT ${list}
      COMMAND hlsgen ${source} -I ${PROJECT_SOURCE_DIR} -o ${directory}/rtl
              --ports ${directory}/ports
      COMMAND ${CMAKE_COMMAND} -E touch ${list}
      DEPENDS hlsgen ${header} ${source} ${numeric}/bits.hpp
      VERBATIM)
  endif()
  # No optimisation: compiling would take longer than the clocks that are run.
  set(library ${model}/V${name}__ALL.a)
  add_custom_command(OUTPUT ${library}
    COMMAND ${VERILATOR_BIN} --cc --build -f ${list} --top-module ${module} --prefix V${name}
            --Mdir ${model} --x-assign fast --x-initial fast -Wno-fatal -Wno-UNUSED
            -CFLAGS -w -MAKEFLAGS "-s OPT_FAST=-O0 OPT_SLOW=-O0" --output-split 20000
    DEPENDS ${list}
    WORKING_DIRECTORY ${directory}  # the list names rtl/<module>.sv
    VERBATIM)
  add_executable(${name}_test random/group.cpp ${header} ${library})
  target_compile_definitions(${name}_test PRIVATE
    GROUP_HEADER="${header}" GROUP_SOURCE="${source}" GROUP=${group} MODULE=${module}
    PORTS_HEADER="${directory}/ports/${module}_ports.hpp" VERILATED_HEADER="${model}/V${name}.h"
    VERILATED=V${name} PACE=${pace})
  target_include_directories(${name}_test SYSTEM PRIVATE ${model})
  target_compile_options(${name}_test PRIVATE -O0 -w)
  target_link_libraries(${name}_test PRIVATE random_harness ${library} verilated_runtime)
  set(test ${kind}_programs_${first})
  add_test(NAME ${test} COMMAND ${name}_test)  # one, or each case would read C++ anew
  set_tests_properties(${test} PROPERTIES TIMEOUT 900)
endfunction()

foreach(first 1 81 ${RANDOM_SEEDS})
  random_test(random ${first} 80)
endforeach()
random_test(compiled 81 12)
