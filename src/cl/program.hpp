#pragma once

#include <string>
#include <string_view>

#include "cl/opencl.hpp"

namespace lichtraum {

/// Builds kernels/<name>.cl for a device. The source is the one embedded in the library; when the environment variable
/// LICHTRAUM_KERNEL_DIR is set, it is read from that folder instead (for work on kernels). clBuildProgram only: PoCL
/// caches what goes through it.
/// Throws Error{internal} with the compiler's log.
cl::Program build_program(cl::Context const& context, cl::Device const& device, std::string_view name,
                          std::string options);

}  // namespace lichtraum
