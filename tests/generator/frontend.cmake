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
