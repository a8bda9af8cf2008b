# What every printed module must stand: prove_rtl(<top>) adds two tests,
#
#   prove_<top>   tools/prove_print: the readable print equals the plain one
#   lint_<top>    tools/lint_rtl: Verilator, Icarus and Yosys have nothing to say
#
# for the files of rtl/<top>.f, as printed into the build.  Modules that are tops themselves are left to
# their own tests.

function(prove_rtl top)
  set(printed ${PROJECT_BINARY_DIR}/rtl)
  add_test(NAME prove_${top}
    COMMAND ${PROJECT_SOURCE_DIR}/tools/prove_print ${printed} ${PROJECT_BINARY_DIR}/plain
            ${printed}/${top}.f)
  add_test(NAME lint_${top}
    COMMAND ${PROJECT_SOURCE_DIR}/tools/lint_rtl ${printed}/${top}.f
    WORKING_DIRECTORY ${PROJECT_BINARY_DIR})  # where rtl/ of the list is the one just printed
  set_tests_properties(prove_${top} lint_${top} PROPERTIES TIMEOUT 600)
endfunction()
