#pragma once

#include <span>
#include <string_view>

namespace lichtraum {

/// A device program, compiled on the machine that lichtraum was built on: compiling takes seconds, loading this
/// hundredths of one. It is for machines with the same OpenCL and processors of the same class only.
struct PrecompiledProgram {
  std::string_view name;     ///< kernels/<name>.cl
  std::string_view options;  ///< of clBuildProgram
  std::string_view target;   ///< its machine_code_target
  std::string_view binary;   ///< for clCreateProgramWithBinary
};

/// Made by tools/precompile_kernels; none where no OpenCL CPU device worked then.
std::span<PrecompiledProgram const> precompiled_programs();

}  // namespace lichtraum
