#ifndef LICHTRAUM_SHARED_TYPES_H
#define LICHTRAUM_SHARED_TYPES_H

/* The vocabulary of the structs that host and device share. These headers are compiled as C++ and as OpenCL C: only
 * float, int, uint and float4 may appear in a struct (a float3 has 16 bytes on one side and 12 on the other), and what
 * w means is said at each float4. DEVICE_STRUCT_SIZE stops either compiler when a size is not what both agreed on. */

#ifdef __OPENCL_C_VERSION__

/* All device code includes this file, so this holds everywhere: a * b + c rounds twice and fma(a, b, c) once, as
 * written. Left to the compiler, the choice would depend on the processor and on how it vectorises a work-group, and so
 * would the picture's bytes. (The host's compiler is told so in CMakeLists.txt.) */
#pragma OPENCL FP_CONTRACT OFF

#define DEVICE_STRUCT_SIZE(type, bytes) typedef char size_of_##type##_is_##bytes[(sizeof(type) == (bytes)) ? 1 : -1]
/* Between a struct's closing brace and its name. */
#define DEVICE_ALIGNED(bytes) __attribute__((aligned(bytes)))
#define DEVICE_NAMESPACE_BEGIN
#define DEVICE_NAMESPACE_END
#define SHARED_FUNCTION static inline
#define SHARED_TABLE __constant
#define DEVICE_MEMORY __global
#define DEVICE_PRIMITIVE(type, kind) /* for the host */
#define DEVICE_UNIT_SHAPE(type, kind) typedef UnitShape type

#else

#include <cstdint>

#define DEVICE_STRUCT_SIZE(type, bytes) static_assert(sizeof(type) == (bytes), "size differs from the device's " #type)
#define DEVICE_ALIGNED(bytes) __attribute__((aligned(bytes)))
#define DEVICE_NAMESPACE_BEGIN namespace lichtraum::device {
#define DEVICE_NAMESPACE_END }
#define SHARED_FUNCTION inline
#define SHARED_TABLE inline constexpr
#define DEVICE_MEMORY
/* After a primitive's struct: which kind it is, primitive_kind<type>. */
#define DEVICE_PRIMITIVE(type, kind) \
  template <>                        \
  inline constexpr uint primitive_kind<type> = kind
/* A kind that is stored as a UnitShape (shared/geometry.h): a type of its own on the host, the same on the device. */
#define DEVICE_UNIT_SHAPE(type, kind) \
  struct type : UnitShape {};         \
  DEVICE_PRIMITIVE(type, kind)

namespace lichtraum::device {
using uint = std::uint32_t;
struct alignas(16) float4 {
  float x, y, z, w;
};
template <class Primitive>
inline constexpr uint primitive_kind = ~0u;
}  // namespace lichtraum::device

#endif

#endif
