#pragma once

#include <string>

#include "cl/opencl.hpp"

namespace lichtraum {

/// Everything that compiled programs depend on: the platform with its version, the driver, the device, the instructions
/// that the host's processor has, and the class of processors that PoCL is told to compile for. Where two of these are
/// the same, one runs the other's programs.
std::string machine_code_target(cl::Device const& device);

}  // namespace lichtraum
