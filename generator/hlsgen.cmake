# hls_top(<name> <source.cpp>): prints the blocks of a C++ top into the build, at every change.
#
#   ${PROJECT_BINARY_DIR}/rtl/     <module>.sv of each block, <name>.f with their list, children first
#   ${PROJECT_BINARY_DIR}/plain/   the same modules printed plainly, for proofs (prove.cmake)
#   ${PROJECT_BINARY_DIR}/ports/   <module>_ports.hpp for lockstep tests
#
# The source is called <name>.cpp, after its top module.  Targets: <name>_rtl for one, hls_rtl for all.
# `print_rtl` copies what was printed into the committed rtl/; the test `rtl_is_what_hls_prints` fails
# while the two differ.

set(HLSGEN_DIRECTORY ${CMAKE_CURRENT_LIST_DIR} CACHE INTERNAL "")

add_custom_target(hls_rtl ALL)
add_custom_target(print_rtl DEPENDS hls_rtl
  COMMAND ${CMAKE_COMMAND} -D MODE=copy -D PRINTED=${PROJECT_BINARY_DIR}/rtl
          -D COMMITTED=${PROJECT_SOURCE_DIR}/rtl "-DTOPS=$<TARGET_PROPERTY:hls_rtl,TOPS>"
          "-DHEADERS=six_step_top_ports.hpp;sinusoidal_top_ports.hpp"
          -P ${HLSGEN_DIRECTORY}/rtl_files.cmake
  VERBATIM)
add_test(NAME rtl_is_what_hls_prints
  COMMAND ${CMAKE_COMMAND} -D MODE=compare -D PRINTED=${PROJECT_BINARY_DIR}/rtl
          -D COMMITTED=${PROJECT_SOURCE_DIR}/rtl "-DTOPS=$<TARGET_PROPERTY:hls_rtl,TOPS>"
          "-DHEADERS=six_step_top_ports.hpp;sinusoidal_top_ports.hpp"
          -P ${HLSGEN_DIRECTORY}/rtl_files.cmake)

function(hls_top name source)
  cmake_path(ABSOLUTE_PATH source BASE_DIRECTORY ${CMAKE_CURRENT_SOURCE_DIR})
  cmake_path(GET source STEM stem)
  if(NOT stem STREQUAL name)
    message(FATAL_ERROR "hls_top(${name} ${source}): call the source ${name}.cpp")
  endif()
  cmake_path(RELATIVE_PATH source BASE_DIRECTORY ${PROJECT_SOURCE_DIR} OUTPUT_VARIABLE relative)
  set(list ${PROJECT_BINARY_DIR}/rtl/${name}.f)
  add_custom_command(
    OUTPUT ${list}
    COMMAND hlsgen ${relative} -o ${PROJECT_BINARY_DIR}/rtl --plain ${PROJECT_BINARY_DIR}/plain
            --ports ${PROJECT_BINARY_DIR}/ports --depfile ${CMAKE_CURRENT_BINARY_DIR}/${name}.d
    COMMAND ${CMAKE_COMMAND} -E touch ${list}  # printed files keep their time when they are the same
    DEPENDS hlsgen ${source}
    DEPFILE ${CMAKE_CURRENT_BINARY_DIR}/${name}.d
    WORKING_DIRECTORY ${PROJECT_SOURCE_DIR}  # paths in the print are relative to the root
    COMMENT "Printing ${name} and its blocks"
    VERBATIM)
  add_custom_target(${name}_rtl DEPENDS ${list})
  add_dependencies(hls_rtl ${name}_rtl)
  set_property(TARGET hls_rtl APPEND PROPERTY TOPS ${name})
endfunction()
