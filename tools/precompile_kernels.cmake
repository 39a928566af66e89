# cmake -D OUTPUT=x.inc [-D PROGRAM=precompile_kernels] -D NUMBER=1 -D COUNT=8 -P precompile_kernels.cmake
#
# Writes part NUMBER of COUNT of the table in src/cl/precompiled_programs.cpp.in: what PROGRAM makes, or nothing where it
# is not given or fails. Then the first picture waits for the compiler, and that is all.

cmake_minimum_required(VERSION 3.22)

if(PROGRAM)
  set(ENV{POCL_CACHE_DIR} ${OUTPUT}.cache)
  file(MAKE_DIRECTORY ${OUTPUT}.cache)
  execute_process(COMMAND ${PROGRAM} ${OUTPUT} ${NUMBER} ${COUNT}
    RESULT_VARIABLE result OUTPUT_VARIABLE text ERROR_VARIABLE text)
  file(REMOVE_RECURSE ${OUTPUT}.cache)
  if(result EQUAL 0)
    return()
  endif()
  message(STATUS "No OpenCL CPU device compiles kernels here (${result}): each machine's first picture will")
endif()
file(WRITE ${OUTPUT} "")
