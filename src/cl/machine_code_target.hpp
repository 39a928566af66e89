#pragma once

#include <string>

#include "cl/opencl.hpp"

namespace lichtraum {

/// Everything that compiled programs depend on. Where two of these are the same, one runs the other's programs.
///
/// PoCL as distributions build it compiles for one of a few classes of processors, which the device's version names
/// ("... HSTR: pthread-x86_64-pc-linux-gnu-haswell"), and refuses programs of another class. Else it is the platform
/// with its version, the driver, the device, and the instructions that the host's processor has.
std::string machine_code_target(cl::Device const& device);

}  // namespace lichtraum
