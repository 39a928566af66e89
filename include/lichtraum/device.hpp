#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "lichtraum/api.hpp"

namespace LICHTRAUM_API lichtraum {

enum class DeviceKind { reference, cpu, gpu, accelerator };

/// Something that can trace a scene. The reference tracer (plain C++) is always one of them, and the last.
struct DeviceInfo {
  int index = 0;  ///< what `--device N` means
  DeviceKind kind = DeviceKind::reference;
  std::string name;
  std::string platform;
  std::string platform_version;
  std::string device_version;
  std::string driver_version;
  unsigned compute_units = 0;
  std::uint64_t global_memory_bytes = 0;
  std::uint64_t max_allocation_bytes = 0;
};

/// The host itself, without OpenCL. Its index is 0 until a list of devices gives it another.
DeviceInfo reference_device();

/// What a search for devices found.
struct DeviceList {
  std::vector<DeviceInfo> devices;    ///< best first; the reference tracer is last
  std::vector<std::string> warnings;  ///< why a platform or device cannot be used, and what to install
};

enum class ProbeInChild {
  when_suspicious,  ///< costs nothing where no platform is known to abort its process
  always,           ///< 30 ms more
};

/// Looks at every OpenCL platform. PoCL aborts the whole process when it cannot read /sys or memory is short, so the
/// platforms are tried in a child process first where that could happen. Never throws for a broken platform: it is left
/// out, with a warning.
DeviceList find_devices(ProbeInChild probe = ProbeInChild::when_suspicious);

/// `selector`: empty (the best), an index, "cpu", "gpu", "reference", or a part of a device's name in any case.
/// Throws Error{no_device} that lists what there is.
DeviceInfo const& select_device(DeviceList const& list, std::string_view selector);

}  // namespace lichtraum
