# cmake -D OUTPUT=x.cpp [-D PROGRAM=precompile_kernels] -P precompile_kernels.cmake
#
# Writes the C++ file that src/cl/precompiled_program.hpp declares: with what PROGRAM makes, or with no programs where
# it is not given or fails. Then the first picture waits for the compiler, and that is all.

cmake_minimum_required(VERSION 3.22)

if(PROGRAM)
  set(ENV{POCL_CACHE_DIR} ${OUTPUT}.cache)
  file(MAKE_DIRECTORY ${OUTPUT}.cache)
  execute_process(COMMAND ${PROGRAM} ${OUTPUT} RESULT_VARIABLE result OUTPUT_VARIABLE text ERROR_VARIABLE text)
  file(REMOVE_RECURSE ${OUTPUT}.cache)
  if(result EQUAL 0)
    return()
  endif()
  message(STATUS "No OpenCL CPU device compiles kernels here (${result}): each machine's first picture will")
endif()
file(WRITE ${OUTPUT} "#include \"cl/precompiled_program.hpp\"

namespace lichtraum {
std::span<PrecompiledProgram const> precompiled_programs() { return {}; }
}  // namespace lichtraum
")
