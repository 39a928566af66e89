#pragma once

#include "cl/opencl.hpp"

namespace lichtraum {

/// PoCL before 7.2 links what it compiles with the program `ld`, and aborts the process where there is none. Throws
/// Error{no_device}, with what to install, where that would happen.
void check_pocl_linker(cl::Device const& device);

}  // namespace lichtraum
