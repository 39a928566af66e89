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

/// The same for calls that launch kernels: where one fails, it waits for those that were launched, as they use memory
/// of the host that ends with the picture.
template <class Calls>
decltype(auto) checked(cl::CommandQueue const& queue, Calls&& calls) {
  try {
    return checked(std::forward<Calls>(calls));
  } catch (...) {
    ::clFinish(queue());  // where that fails, too, there is no device that anything runs on
    throw;
  }
}

}  // namespace lichtraum
