#pragma once

#include <string>
#include <vector>

#include "cl/opencl.hpp"
#include "lichtraum/device.hpp"

namespace lichtraum {

/// A usable OpenCL device and its description (`index` not yet set).
struct OpenClDevice {
  DeviceInfo info;
  cl::Device device;
};

/// Every device of every platform that can compile kernels. A platform that fails is left out, with a warning.
/// Does not look out for platforms that abort the process: see child_probe.hpp.
std::vector<OpenClDevice> find_opencl_devices(std::vector<std::string>& warnings);

}  // namespace lichtraum
