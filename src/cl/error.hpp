#pragma once

#include <string_view>
#include <utility>

#include "cl/opencl.hpp"
#include "lichtraum/error.hpp"

namespace lichtraum {

/// "CL_OUT_OF_RESOURCES" for -5; "unknown error" for a code that OpenCL 1.2 does not define.
std::string_view opencl_error_name(int code);

/// The failed call, its code by name, and what usually helps.
DeviceError to_device_error(cl::Error const& error);

/// Runs `calls`; what OpenCL's C++ bindings throw becomes a DeviceError.
template <class Calls>
decltype(auto) checked(Calls&& calls) {
  try {
    return std::forward<Calls>(calls)();
  } catch (cl::Error const& error) {
    throw to_device_error(error);
  }
}

}  // namespace lichtraum
