#pragma once

#include <cstdint>
#include <string_view>

#include "lichtraum/device.hpp"

namespace lichtraum::app {

constexpr std::string_view kind_name(DeviceKind kind) {
  switch (kind) {
    case DeviceKind::reference:
      return "reference";
    case DeviceKind::cpu:
      return "cpu";
    case DeviceKind::gpu:
      return "gpu";
    case DeviceKind::accelerator:
      return "accelerator";
  }
  return "";
}

constexpr double gibibytes(std::uint64_t bytes) { return double(bytes) / double(std::uint64_t(1) << 30); }

}  // namespace lichtraum::app
