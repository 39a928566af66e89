#include "cl/pocl_linker.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <sstream>
#include <string>

#include "lichtraum/error.hpp"

namespace lichtraum {
namespace {

bool is_on_path(std::string const& program) {
  char const* const path = std::getenv("PATH");
  std::istringstream folders(path ? path : "");
  for (std::string folder; std::getline(folders, folder, ':');) {
    if (::access((folder + "/" + program).c_str(), X_OK) == 0) return true;
  }
  return false;
}

/// Of "OpenCL 3.0 PoCL 3.1+debian ..."; not of other platforms.
bool links_with_ld(cl::Platform const& platform) {
  if (platform.getInfo<CL_PLATFORM_NAME>() != "Portable Computing Language") return false;
  std::string const version = platform.getInfo<CL_PLATFORM_VERSION>();
  std::size_t const at = version.find("PoCL ");
  int major = 0, minor = 0;
  if (at == std::string::npos || std::sscanf(version.c_str() + at, "PoCL %d.%d", &major, &minor) != 2) return false;
  return major < 7 || (major == 7 && minor < 2);
}

}  // namespace

void check_pocl_linker(cl::Device const& device) {
  bool const is_cpu = (device.getInfo<CL_DEVICE_TYPE>() & CL_DEVICE_TYPE_CPU) != 0;
  cl::Platform const platform(device.getInfo<CL_DEVICE_PLATFORM>());
  if (!is_cpu || !links_with_ld(platform) || is_on_path("ld")) return;
  throw Error(ErrorKind::no_device,
              fmt::format("{} needs the linker 'ld' to compile for this processor, and there is none in PATH: install "
                          "the package binutils, or draw with --device reference",
                          device.getInfo<CL_DEVICE_NAME>()));
}

}  // namespace lichtraum
