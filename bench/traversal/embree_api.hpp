#pragma once

#include <sys/types.h>

#include <cstddef>
#include <string>

/// The few calls of Embree that are needed, found in a library at run time, so that several versions can be compared in
/// one process. Versions 3.13 and 4.4 have the same functions and layouts but for what says how coherent rays are
/// (their headers rtcore_ray.h, rtcore_common.h, rtcore_scene.h).
namespace lichtraum::bench::embree {

inline constexpr unsigned invalid_id = ~0u;

struct alignas(16) Ray {
  float org_x, org_y, org_z, t_near;
  float dir_x, dir_y, dir_z, time;
  float t_far;  ///< of the hit, afterwards; negative infinity where an any-hit query found one
  unsigned mask, id, flags;
};
struct alignas(16) RayHit {
  Ray ray;
  float normal[3], u, v;
  unsigned primitive, geometry, instance;
  unsigned instance_primitive;  ///< version 4.4 only: at the end, where others don't look
};
struct alignas(64) Ray16 {
  float org_x[16], org_y[16], org_z[16], t_near[16];
  float dir_x[16], dir_y[16], dir_z[16], time[16];
  float t_far[16];
  unsigned mask[16], id[16], flags[16];
};
struct alignas(64) RayHit16 {
  Ray16 ray;
  float normal[3][16], u[16], v[16];
  unsigned primitive[16], geometry[16], instance[16];
  unsigned instance_primitive[16];
};

using Object = struct Opaque*;  ///< a device, a scene or a geometry

enum class Coherence { incoherent, coherent };

/// One of Embree's libraries. It stays loaded: its threads outlive its devices.
class Library {
 public:
  /// `path` is looked for as dlopen does. Throws std::runtime_error.
  explicit Library(std::string const& path);

  void closest(Object scene, Coherence coherence, RayHit& query) const;
  void closest(int const* valid, Object scene, Coherence coherence, RayHit16& query) const;
  void any(Object scene, Coherence coherence, Ray& query) const;
  void any(int const* valid, Object scene, Coherence coherence, Ray16& query) const;

  int major_version = 0;
  std::string version;  ///< such as 4.4.0

  Object (*new_device)(char const* settings);
  void (*release_device)(Object device);
  void (*set_memory_monitor)(Object device, bool (*monitor)(void*, ssize_t, bool), void* user);
  Object (*new_scene)(Object device);
  void (*release_scene)(Object scene);
  void (*set_build_quality)(Object scene, int quality);
  void (*commit_scene)(Object scene);
  Object (*new_geometry)(Object device, int type);
  void* (*new_buffer)(Object geometry, int type, unsigned slot, int format, std::size_t stride, std::size_t count);
  void (*set_instanced_scene)(Object geometry, Object scene);
  void (*set_transform)(Object geometry, unsigned time_step, int format, void const* world_from_object);
  void (*commit_geometry)(Object geometry);
  unsigned (*attach_geometry)(Object scene, Object geometry);
  void (*release_geometry)(Object geometry);

 private:
  void* intersect_1_;
  void* intersect_16_;
  void* occluded_1_;
  void* occluded_16_;
};

}  // namespace lichtraum::bench::embree
