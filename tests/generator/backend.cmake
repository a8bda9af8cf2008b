# What is tested without C++: checks, passes and printers on netlists made by hand or by chance.
unit_test(backend_print hlsgen_lib)
unit_test(clocked_print hlsgen_lib)
unit_test(backend_pass hlsgen_lib)
unit_test(machine hlsgen_lib)
unit_test(spoken_names hlsgen_lib)
compile_quickly(backend_print clocked_print)

# Every printed module is proved equal to its plain print, and is lint-clean.
include(${PROJECT_SOURCE_DIR}/generator/prove.cmake)
get_property(tops TARGET hls_rtl PROPERTY TOPS)
foreach(top ${tops})
  prove_rtl(${top})
endforeach()
# So are random netlists, which use every operator on mixed widths.
add_executable(random_netlists random_netlists.cpp)
target_link_libraries(random_netlists PRIVATE hlsgen_lib)
set(netlists ${CMAKE_CURRENT_BINARY_DIR}/netlists)
add_test(NAME random_netlists_print COMMAND random_netlists 10 200 ${netlists})
set_tests_properties(random_netlists_print PROPERTIES FIXTURES_SETUP random_netlists)
foreach(seed RANGE 9)
  add_test(NAME prove_random_netlist_${seed}
    COMMAND ${PROJECT_SOURCE_DIR}/tools/prove_print ${netlists}/rtl ${netlists}/plain random_${seed})
  add_test(NAME lint_random_netlist_${seed}
    COMMAND ${PROJECT_SOURCE_DIR}/tools/lint_rtl ${netlists}/rtl/random_${seed}.f
    WORKING_DIRECTORY ${netlists})
  set_tests_properties(prove_random_netlist_${seed} lint_random_netlist_${seed}
    PROPERTIES FIXTURES_REQUIRED random_netlists TIMEOUT 600)
endforeach()

# Products are compared as rows of adders: those are products.
add_test(NAME rows_of_adders_are_products
  COMMAND ${CMAKE_CURRENT_SOURCE_DIR}/rows_of_adders.sh ${PROJECT_SOURCE_DIR}/tools/rows_of_adders.v)

add_test(NAME proof_and_lint_can_fail
  COMMAND ${CMAKE_COMMAND} -D ROOT=${PROJECT_SOURCE_DIR} -D RTL=${PROJECT_BINARY_DIR}/rtl
          -D PLAIN=${PROJECT_BINARY_DIR}/plain
          -P ${CMAKE_CURRENT_SOURCE_DIR}/flaws/negative_control.cmake)
