#pragma once

#include <cstddef>

/// The functions of Open Image Denoise's C API that are used here, as its documentation declares them
/// (https://www.openimagedenoise.org/documentation.html): FUNCTION(result, name, parameters). Versions 2.0 and later
/// have them all; 1.x lacks the filters' setters.

namespace lichtraum::oidn {

using Device = struct DeviceObject*;
using Filter = struct FilterObject*;

inline constexpr int device_type_cpu = 1;
inline constexpr int error_none = 0;
inline constexpr int error_out_of_memory = 4;
inline constexpr int format_float3 = 3;

// clang-format off
#define LICHTRAUM_OIDN_FUNCTIONS(FUNCTION)                                                                 \
  FUNCTION(Device, oidnNewDevice, (int type))                                                              \
  FUNCTION(void, oidnReleaseDevice, (Device device))                                                       \
  FUNCTION(void, oidnSetDeviceBool, (Device device, char const* name, bool value))                         \
  FUNCTION(int, oidnGetDeviceInt, (Device device, char const* name))                                       \
  FUNCTION(void, oidnCommitDevice, (Device device))                                                        \
  FUNCTION(int, oidnGetDeviceError, (Device device, char const** message))                                 \
  FUNCTION(Filter, oidnNewFilter, (Device device, char const* type))                                       \
  FUNCTION(void, oidnReleaseFilter, (Filter filter))                                                       \
  FUNCTION(void, oidnSetSharedFilterImage,                                                                 \
           (Filter filter, char const* name, void* pixels, int format, std::size_t width,                  \
            std::size_t height, std::size_t offset, std::size_t pixel_stride, std::size_t row_stride))     \
  FUNCTION(void, oidnSetFilterBool, (Filter filter, char const* name, bool value))                         \
  FUNCTION(void, oidnCommitFilter, (Filter filter))                                                        \
  FUNCTION(void, oidnExecuteFilter, (Filter filter))
// clang-format on

struct Functions {
#define LICHTRAUM_MEMBER(result, name, parameters) result(*name) parameters = nullptr;
  LICHTRAUM_OIDN_FUNCTIONS(LICHTRAUM_MEMBER)
#undef LICHTRAUM_MEMBER
};

}  // namespace lichtraum::oidn
