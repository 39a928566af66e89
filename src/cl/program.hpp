#pragma once

#include <span>
#include <string>
#include <string_view>

#include "cl/opencl.hpp"
#include "cl/precompiled_program.hpp"

namespace lichtraum {

/// An option of clBuildProgram, after a space: that quotients and square roots are rounded as the host's are. GPUs
/// round them roughly unless asked (OpenCL 1.2, 5.6.4.2). Empty for devices that cannot.
std::string exact_rounding_option(cl::Device const& device);

/// Whether build_program calls the device's compiler, which takes seconds. Throws DeviceError.
bool needs_compiler(cl::Device const& device, std::string_view name, std::string const& options,
                    std::span<PrecompiledProgram const> precompiled);

/// Builds kernels/<name>.cl for a device: from the machine code in `precompiled` where one entry fits and the device
/// takes it, else from the source embedded in the library. When the environment variable LICHTRAUM_KERNEL_DIR is set,
/// the source is read from that folder instead of both (for work on kernels). clBuildProgram only: PoCL caches what
/// goes through it.
/// Throws Error{internal} with the compiler's log.
cl::Program build_program(cl::Context const& context, cl::Device const& device, std::string_view name,
                          std::string const& options, std::span<PrecompiledProgram const> precompiled);

}  // namespace lichtraum
