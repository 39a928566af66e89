#include "cl/machine_code_target.hpp"

#include <fmt/format.h>

#include <cstdlib>
#include <fstream>

namespace lichtraum {
namespace {

/// The class of processors that PoCL is told to compile for (pocl_get_distro_kernellib_name in its
/// lib/CL/pocl_llvm_utils.cc).
std::string chosen_class() {
  char const* const name = std::getenv("POCL_KERNELLIB_NAME");
  return name ? name : "";
}

/// The first processor's line in /proc/cpuinfo ("flags" on x86, "Features" on ARM); empty where there is none. A
/// device's name is not enough: a virtual machine may hide instructions of the processor that it names.
std::string processor_features() {
  std::ifstream in("/proc/cpuinfo");
  for (std::string line; std::getline(in, line) && !line.empty();) {
    if (line.starts_with("flags") || line.starts_with("Features")) return line;
  }
  return {};
}

}  // namespace

std::string machine_code_target(cl::Device const& device) {
  cl::Platform const platform(device.getInfo<CL_DEVICE_PLATFORM>());
  return fmt::format("{}; {}; {}; {}; {}; {}; {}", platform.getInfo<CL_PLATFORM_NAME>(),
                     platform.getInfo<CL_PLATFORM_VERSION>(), device.getInfo<CL_DEVICE_NAME>(),
                     device.getInfo<CL_DEVICE_VERSION>(), device.getInfo<CL_DRIVER_VERSION>(), processor_features(),
                     chosen_class());
}

}  // namespace lichtraum
