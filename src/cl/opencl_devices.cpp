#include "cl/opencl_devices.hpp"

#include <fmt/format.h>

#include <bit>

#include "cl/error.hpp"

namespace lichtraum {
namespace {

DeviceKind kind_of(cl_device_type type) {
  if (type & CL_DEVICE_TYPE_GPU) return DeviceKind::gpu;
  if (type & CL_DEVICE_TYPE_CPU) return DeviceKind::cpu;
  return DeviceKind::accelerator;
}

/// Why the kernels cannot run there, or nothing.
std::string unsuitable(cl::Device const& device) {
  if (!device.getInfo<CL_DEVICE_AVAILABLE>()) return "it is not available";
  if (!device.getInfo<CL_DEVICE_COMPILER_AVAILABLE>()) return "its platform has no compiler";
  if (bool(device.getInfo<CL_DEVICE_ENDIAN_LITTLE>()) != (std::endian::native == std::endian::little)) {
    return "its byte order is not the host's";
  }
  return {};
}

DeviceInfo describe(cl::Platform const& platform, cl::Device const& device) {
  DeviceInfo info;
  info.kind = kind_of(device.getInfo<CL_DEVICE_TYPE>());
  info.name = device.getInfo<CL_DEVICE_NAME>();
  info.platform = platform.getInfo<CL_PLATFORM_NAME>();
  info.platform_version = platform.getInfo<CL_PLATFORM_VERSION>();
  info.device_version = device.getInfo<CL_DEVICE_VERSION>();
  info.driver_version = device.getInfo<CL_DRIVER_VERSION>();
  info.compute_units = device.getInfo<CL_DEVICE_MAX_COMPUTE_UNITS>();
  info.global_memory_bytes = device.getInfo<CL_DEVICE_GLOBAL_MEM_SIZE>();
  info.max_allocation_bytes = device.getInfo<CL_DEVICE_MAX_MEM_ALLOC_SIZE>();
  return info;
}

void append_devices(cl::Platform const& platform, std::vector<OpenClDevice>& found,
                    std::vector<std::string>& warnings) {
  std::vector<cl::Device> devices;
  try {
    platform.getDevices(CL_DEVICE_TYPE_ALL, &devices);
  } catch (cl::Error const& error) {
    if (error.err() != CL_DEVICE_NOT_FOUND) throw;  // an installed platform without its hardware is nothing unusual
  }
  for (cl::Device const& device : devices) {
    if (auto const reason = unsuitable(device); reason.empty()) {
      found.push_back({describe(platform, device), device});
    } else {
      warnings.push_back(fmt::format("device '{}' cannot be used: {}", device.getInfo<CL_DEVICE_NAME>(), reason));
    }
  }
}

}  // namespace

std::vector<OpenClDevice> find_opencl_devices(std::vector<std::string>& warnings) {
  std::vector<OpenClDevice> found;
  std::vector<cl::Platform> platforms;
  try {
    cl::Platform::get(&platforms);
  } catch (cl::Error const& error) {
    if (error.err() != CL_PLATFORM_NOT_FOUND_KHR) warnings.push_back(to_device_error(error).what());
  }
  for (cl::Platform const& platform : platforms) {
    try {
      append_devices(platform, found, warnings);
    } catch (cl::Error const& error) {
      warnings.push_back(fmt::format("an OpenCL platform cannot be used: {}", to_device_error(error).what()));
    }
  }
  return found;
}

}  // namespace lichtraum
