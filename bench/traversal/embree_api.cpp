#include "embree_api.hpp"

#include <dlfcn.h>

#include <fmt/format.h>

#include <stdexcept>

namespace lichtraum::bench::embree {
namespace {

/// RTCIntersectContext of version 3.
struct Context3 {
  int flags;
  void* filter;
  unsigned instance;
};
Context3 context_3(Coherence coherence) { return {coherence == Coherence::coherent ? 1 : 0, nullptr, invalid_id}; }

/// RTCIntersectArguments and RTCOccludedArguments of version 4.
struct Arguments4 {
  int flags;
  unsigned features;
  void* context;
  void* filter;
  void* callback;
  float min_width_distance_factor;
};
Arguments4 arguments_4(Coherence coherence) {
  return {coherence == Coherence::coherent ? 1 << 16 : 0, ~0u, nullptr, nullptr, nullptr, 0};
}

template <class Function>
Function as(void* symbol) {
  return reinterpret_cast<Function>(symbol);
}

constexpr int version_property = 0;

}  // namespace

Library::Library(std::string const& path) {
  void* const handle = dlopen(path.c_str(), RTLD_NOW | RTLD_LOCAL);
  if (!handle) throw std::runtime_error(dlerror());
  auto const find = [&](auto& function, char const* name) {
    void* const symbol = dlsym(handle, name);
    if (!symbol) throw std::runtime_error(fmt::format("{} has no {}", path, name));
    function = as<std::remove_reference_t<decltype(function)>>(symbol);
  };
  find(new_device, "rtcNewDevice");
  find(release_device, "rtcReleaseDevice");
  find(set_memory_monitor, "rtcSetDeviceMemoryMonitorFunction");
  find(new_scene, "rtcNewScene");
  find(release_scene, "rtcReleaseScene");
  find(set_build_quality, "rtcSetSceneBuildQuality");
  find(commit_scene, "rtcCommitScene");
  find(new_geometry, "rtcNewGeometry");
  find(new_buffer, "rtcSetNewGeometryBuffer");
  find(set_instanced_scene, "rtcSetGeometryInstancedScene");
  find(set_transform, "rtcSetGeometryTransform");
  find(commit_geometry, "rtcCommitGeometry");
  find(attach_geometry, "rtcAttachGeometry");
  find(release_geometry, "rtcReleaseGeometry");
  find(intersect_1_, "rtcIntersect1");
  find(intersect_16_, "rtcIntersect16");
  find(occluded_1_, "rtcOccluded1");
  find(occluded_16_, "rtcOccluded16");
  ssize_t (*property)(Object, int) = nullptr;
  find(property, "rtcGetDeviceProperty");
  Object const device = new_device("threads=1");
  if (!device) throw std::runtime_error(fmt::format("{} finds no device", path));
  auto const number = property(device, version_property);
  release_device(device);
  major_version = int(number / 10000);
  if (major_version != 3 && major_version != 4) {
    throw std::runtime_error(fmt::format("{} is version {} of Embree: 3 and 4 are known", path, major_version));
  }
  version = fmt::format("{}.{}.{}", major_version, number / 100 % 100, number % 100);
}

void Library::closest(Object scene, Coherence coherence, RayHit& query) const {
  if (major_version == 3) {
    Context3 context = context_3(coherence);
    as<void (*)(Object, Context3*, RayHit*)>(intersect_1_)(scene, &context, &query);
  } else {
    Arguments4 arguments = arguments_4(coherence);
    as<void (*)(Object, RayHit*, Arguments4*)>(intersect_1_)(scene, &query, &arguments);
  }
}

void Library::closest(int const* valid, Object scene, Coherence coherence, RayHit16& query) const {
  if (major_version == 3) {
    Context3 context = context_3(coherence);
    as<void (*)(int const*, Object, Context3*, RayHit16*)>(intersect_16_)(valid, scene, &context, &query);
  } else {
    Arguments4 arguments = arguments_4(coherence);
    as<void (*)(int const*, Object, RayHit16*, Arguments4*)>(intersect_16_)(valid, scene, &query, &arguments);
  }
}

void Library::any(Object scene, Coherence coherence, Ray& query) const {
  if (major_version == 3) {
    Context3 context = context_3(coherence);
    as<void (*)(Object, Context3*, Ray*)>(occluded_1_)(scene, &context, &query);
  } else {
    Arguments4 arguments = arguments_4(coherence);
    as<void (*)(Object, Ray*, Arguments4*)>(occluded_1_)(scene, &query, &arguments);
  }
}

void Library::any(int const* valid, Object scene, Coherence coherence, Ray16& query) const {
  if (major_version == 3) {
    Context3 context = context_3(coherence);
    as<void (*)(int const*, Object, Context3*, Ray16*)>(occluded_16_)(valid, scene, &context, &query);
  } else {
    Arguments4 arguments = arguments_4(coherence);
    as<void (*)(int const*, Object, Ray16*, Arguments4*)>(occluded_16_)(valid, scene, &query, &arguments);
  }
}

}  // namespace lichtraum::bench::embree
