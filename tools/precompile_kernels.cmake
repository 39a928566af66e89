# cmake -D OUTPUT=x.inc [-D PROGRAM=precompile_kernels] [-D CLASSES=avx2,avx512] -D NUMBER=1 -D COUNT=8 -P precompile_kernels.cmake
#
# Writes part NUMBER of COUNT of the table in src/cl/precompiled_programs.cpp.in: what PROGRAM makes, or nothing where it
# is not given or fails. Then the first picture waits for the compiler, and that is all.
# CLASSES: of processors, by their names in POCL_KERNELLIB_NAME; by default this machine's. For one that this machine cannot run,
# PoCL takes another; what is there already is not made again.

cmake_minimum_required(VERSION 3.22)

file(WRITE ${OUTPUT} "")
if(NOT PROGRAM)
  return()
endif()
set(ENV{POCL_CACHE_DIR} ${OUTPUT}.cache)
file(MAKE_DIRECTORY ${OUTPUT}.cache)
string(REPLACE "," ";" classes "${CLASSES}")
if(NOT classes)
  set(classes as_it_is)
endif()
foreach(class IN LISTS classes)
  file(SIZE ${OUTPUT} size_before)
  if(NOT class STREQUAL as_it_is)
    set(ENV{POCL_KERNELLIB_NAME} ${class})
  endif()
  execute_process(COMMAND ${PROGRAM} ${OUTPUT} ${NUMBER} ${COUNT}
    RESULT_VARIABLE result OUTPUT_VARIABLE text ERROR_VARIABLE text)
  if(NOT result EQUAL 0)
    message(STATUS "No OpenCL CPU device compiles kernels here (${class}: ${result}): each machine's first picture will")
    continue()
  endif()
  file(SIZE ${OUTPUT} size)
  if(NUMBER EQUAL 1 AND size EQUAL size_before)
    message(STATUS "No kernels are compiled for ${class}: this machine cannot run it, or PoCL does not know it")
  endif()
endforeach()
file(REMOVE_RECURSE ${OUTPUT}.cache)
