# What is tested without C++: checks, passes and printers on netlists made by hand or by chance.
unit_test(backend_print hlsgen_lib)
unit_test(backend_pass hlsgen_lib)

# Every printed module is proved equal to its plain print, and is lint-clean.
include(${PROJECT_SOURCE_DIR}/generator/prove.cmake)
get_property(tops TARGET hls_rtl PROPERTY TOPS)
foreach(top ${tops})
  prove_rtl(${top})
endforeach()
add_test(NAME proof_and_lint_can_fail
  COMMAND ${CMAKE_COMMAND} -D ROOT=${PROJECT_SOURCE_DIR} -D RTL=${PROJECT_BINARY_DIR}/rtl
          -D PLAIN=${PROJECT_BINARY_DIR}/plain
          -P ${CMAKE_CURRENT_SOURCE_DIR}/flaws/negative_control.cmake)
