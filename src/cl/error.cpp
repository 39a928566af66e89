#include "cl/error.hpp"

#include <fmt/format.h>

namespace lichtraum {

std::string_view opencl_error_name(int code) {
#define LICHTRAUM_NAME(code_name) \
  case code_name:                 \
    return #code_name
  switch (code) {
    LICHTRAUM_NAME(CL_DEVICE_NOT_FOUND);
    LICHTRAUM_NAME(CL_DEVICE_NOT_AVAILABLE);
    LICHTRAUM_NAME(CL_COMPILER_NOT_AVAILABLE);
    LICHTRAUM_NAME(CL_MEM_OBJECT_ALLOCATION_FAILURE);
    LICHTRAUM_NAME(CL_OUT_OF_RESOURCES);
    LICHTRAUM_NAME(CL_OUT_OF_HOST_MEMORY);
    LICHTRAUM_NAME(CL_BUILD_PROGRAM_FAILURE);
    LICHTRAUM_NAME(CL_MAP_FAILURE);
    LICHTRAUM_NAME(CL_INVALID_VALUE);
    LICHTRAUM_NAME(CL_INVALID_PLATFORM);
    LICHTRAUM_NAME(CL_INVALID_DEVICE);
    LICHTRAUM_NAME(CL_INVALID_CONTEXT);
    LICHTRAUM_NAME(CL_INVALID_COMMAND_QUEUE);
    LICHTRAUM_NAME(CL_INVALID_HOST_PTR);
    LICHTRAUM_NAME(CL_INVALID_MEM_OBJECT);
    LICHTRAUM_NAME(CL_INVALID_BINARY);
    LICHTRAUM_NAME(CL_INVALID_BUILD_OPTIONS);
    LICHTRAUM_NAME(CL_INVALID_PROGRAM);
    LICHTRAUM_NAME(CL_INVALID_PROGRAM_EXECUTABLE);
    LICHTRAUM_NAME(CL_INVALID_KERNEL_NAME);
    LICHTRAUM_NAME(CL_INVALID_KERNEL);
    LICHTRAUM_NAME(CL_INVALID_ARG_INDEX);
    LICHTRAUM_NAME(CL_INVALID_ARG_VALUE);
    LICHTRAUM_NAME(CL_INVALID_ARG_SIZE);
    LICHTRAUM_NAME(CL_INVALID_KERNEL_ARGS);
    LICHTRAUM_NAME(CL_INVALID_WORK_GROUP_SIZE);
    LICHTRAUM_NAME(CL_INVALID_WORK_ITEM_SIZE);
    LICHTRAUM_NAME(CL_INVALID_OPERATION);
    LICHTRAUM_NAME(CL_INVALID_BUFFER_SIZE);
    LICHTRAUM_NAME(CL_INVALID_GLOBAL_WORK_SIZE);
    LICHTRAUM_NAME(CL_PLATFORM_NOT_FOUND_KHR);
    default:
      return "unknown error";
  }
#undef LICHTRAUM_NAME
}

DeviceError to_device_error(cl::Error const& error) {
  auto message = fmt::format("{} failed: {} ({})", error.what(), opencl_error_name(error.err()), error.err());
  switch (error.err()) {
    case CL_MEM_OBJECT_ALLOCATION_FAILURE:
    case CL_OUT_OF_RESOURCES:
    case CL_OUT_OF_HOST_MEMORY:
      message += "; the device ran out of memory: try a smaller picture or scene, or another --device";
      break;
    default:
      break;
  }
  return DeviceError(message, error.what(), error.err());
}

}  // namespace lichtraum
