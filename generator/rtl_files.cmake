# cmake -D MODE=copy|compare -D PRINTED=DIR -D COMMITTED=DIR -D TOPS=a;b -D HEADERS=c.hpp;d.hpp -P rtl_files.cmake
#
# PRINTED holds what the tops' lists name, and perhaps leftovers of older builds; COMMITTED shall hold
# exactly what the lists name (subfolders are hand-written and not looked at, but ports/: the headers that the
# command needs, in HEADERS).

set(wanted "")
foreach(top IN LISTS TOPS)
  if(NOT EXISTS ${PRINTED}/${top}.f)
    message(FATAL_ERROR "${top} has not been generated; build the target hls_rtl")
  endif()
  file(STRINGS ${PRINTED}/${top}.f lines)
  list(TRANSFORM lines REPLACE "^rtl/" "")
  list(APPEND wanted ${top}.f ${lines})
endforeach()
list(TRANSFORM HEADERS PREPEND ports/)
list(APPEND wanted ${HEADERS})
list(REMOVE_DUPLICATES wanted)
list(SORT wanted)
file(GLOB present RELATIVE ${COMMITTED} ${COMMITTED}/*.sv ${COMMITTED}/*.f)

set(differing "")
foreach(file IN LISTS wanted)
  set(made ${PRINTED}/${file})
  if(file MATCHES "^ports/")
    set(made ${PRINTED}/../${file})  # beside rtl/ in the build
  endif()
  execute_process(COMMAND ${CMAKE_COMMAND} -E compare_files ${made} ${COMMITTED}/${file}
                  RESULT_VARIABLE differs OUTPUT_QUIET ERROR_QUIET)
  if(differs)
    list(APPEND differing ${file})
  endif()
endforeach()
set(extra ${present})
list(REMOVE_ITEM extra ${wanted})

if(MODE STREQUAL "copy")
  foreach(file IN LISTS differing)
    set(made ${PRINTED}/${file})
    if(file MATCHES "^ports/")
      set(made ${PRINTED}/../${file})
    endif()
    configure_file(${made} ${COMMITTED}/${file} COPYONLY)
    message(STATUS "rtl/${file}: generated")
  endforeach()
  foreach(file IN LISTS extra)
    file(REMOVE ${COMMITTED}/${file})
    message(STATUS "rtl/${file}: removed, no block prints it")
  endforeach()
elseif(differing OR extra)
  list(JOIN differing " " differing)
  list(JOIN extra " " extra)
  message(FATAL_ERROR "rtl/ is not what hls/ generates; run `cmake --build . -t print_rtl`\n"
                      "  differing: ${differing}\n  without a block: ${extra}")
endif()
