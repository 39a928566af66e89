#include "cl/machine_code_target.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <string_view>

namespace lichtraum {
namespace {

/// What PoCL compiles for instead of the host's processor: all that have the instructions of one of these run it
/// (kernellib_feature_map in its lib/CL/pocl_llvm_utils.cc). The lowest is called athlon64 by PoCL 3.1, x86-64 by 6.0.
constexpr std::string_view class_names[] = {"athlon64",  "x86-64", "core2",   "penryn",        "sandybridge",
                                            "ivybridge", "bdver1", "haswell", "skylake-avx512"};

/// Built with KERNELLIB_HOST_DISTRO_VARIANTS, which PoCL tells in its version, for x86: elsewhere the name is the
/// host's.
bool compiles_for_classes(std::string_view platform_version, std::string_view device_version) {
  return platform_version.find("DISTRO") != std::string_view::npos &&
         std::any_of(std::begin(class_names), std::end(class_names),
                     [&](std::string_view name) { return device_version.ends_with(fmt::format("-{}", name)); });
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
  std::string const platform_version = platform.getInfo<CL_PLATFORM_VERSION>();
  std::string const device_version = device.getInfo<CL_DEVICE_VERSION>();
  std::string target = fmt::format("{}; {}; {}; {}", platform.getInfo<CL_PLATFORM_NAME>(), platform_version,
                                   device_version, device.getInfo<CL_DRIVER_VERSION>());
  if (compiles_for_classes(platform_version, device_version)) return target;
  return fmt::format("{}; {}; {}", target, device.getInfo<CL_DEVICE_NAME>(), processor_features());
}

}  // namespace lichtraum
