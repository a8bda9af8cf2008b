# From C++ to the netlist, and what must be refused on the way.
function(frontend_test stem)
  add_executable(${stem}_test frontend/${stem}_test.cpp)
  target_link_libraries(${stem}_test PRIVATE hlsgen_lib GTest::gtest_main ${ARGN})
  target_compile_definitions(${stem}_test PRIVATE HLSGEN_ROOT="${PROJECT_SOURCE_DIR}"
                             HLSGEN_PROGRAM="$<TARGET_FILE:hlsgen>")
  add_dependencies(${stem}_test hlsgen)
  gtest_discover_tests(${stem}_test DISCOVERY_TIMEOUT 60 PROPERTIES TIMEOUT 900)
endfunction()

frontend_test(design)
frontend_test(refusal)
frontend_test(names)
frontend_test(faults)
frontend_test(reach)
frontend_test(layout)
frontend_test(program)
frontend_test(memory)
frontend_test(parameter)
compile_quickly(design refusal names reach layout program memory parameter)

# Headers as the lockstep tests get them, for the test blocks.
set(ports_list "")
foreach(top history plain state_machine wide)
  set(header ${CMAKE_CURRENT_BINARY_DIR}/ports/${top}_ports.hpp)
  add_custom_command(
    OUTPUT ${header}
    COMMAND hlsgen tests/generator/frontend/blocks.cpp --top ${top}
            --ports ${CMAKE_CURRENT_BINARY_DIR}/ports
    COMMAND ${CMAKE_COMMAND} -E touch ${header}
    DEPENDS hlsgen ${CMAKE_CURRENT_SOURCE_DIR}/frontend/blocks.cpp
    WORKING_DIRECTORY ${PROJECT_SOURCE_DIR}
    VERBATIM)
  list(APPEND ports_list ${header})
endforeach()
frontend_test(ports)
target_sources(ports_test PRIVATE ${ports_list})
