#include "embree_tracer.hpp"

#include <atomic>
#include <cmath>
#include <cstring>
#include <glm/mat4x3.hpp>
#include <limits>
#include <stdexcept>
#include <string>
#include <thread>

namespace lichtraum::bench {
namespace {

constexpr float infinity = std::numeric_limits<float>::infinity();
constexpr int tile_size = 32;    // pixels; a thread takes one after the other
constexpr int packet_width = 4;  // pixels: 16 rays are 4x4 of them

bool count_bytes(void* total, ssize_t bytes, bool) {
  static_cast<std::atomic<std::int64_t>*>(total)->fetch_add(bytes);
  return true;
}

/// Calls work(i) for i in [0, count) on `threads` threads.
template <class Work>
void parallel(std::size_t count, int threads, Work const& work) {
  std::atomic<std::size_t> next = 0;
  auto const loop = [&] {
    for (std::size_t i = next++; i < count; i = next++) work(i);
  };
  std::vector<std::thread> others;
  for (int i = 1; i < threads; ++i) others.emplace_back(loop);
  loop();
  for (std::thread& other : others) other.join();
}

/// Calls work(x, y) for the corner of each block of `step` pixels, tile by tile.
template <class Work>
void parallel_blocks(int width, int height, int step, int threads, Work const& work) {
  int const columns = (width + tile_size - 1) / tile_size, rows = (height + tile_size - 1) / tile_size;
  parallel(std::size_t(columns) * std::size_t(rows), threads, [&](std::size_t tile) {
    int const tile_x = int(tile) % columns * tile_size, tile_y = int(tile) / columns * tile_size;
    for (int y = tile_y; y < std::min(tile_y + tile_size, height); y += step) {
      for (int x = tile_x; x < std::min(tile_x + tile_size, width); x += step) work(x, y);
    }
  });
}

/// Calls work(first, count) for runs of `step` of `count` rays, a thousand to a thread at a time.
template <class Work>
void parallel_runs(std::size_t count, int threads, std::size_t step, Work const& work) {
  constexpr std::size_t chunk = 1024;
  parallel((count + chunk - 1) / chunk, threads, [&](std::size_t part) {
    std::size_t const end = std::min(count, (part + 1) * chunk);
    for (std::size_t first = part * chunk; first < end; first += step) work(first, std::min(step, end - first));
  });
}

embree::Ray make_ray(float const (&o)[3], float const (&d)[3], float t_max) {
  embree::Ray ray{};
  ray.org_x = o[0], ray.org_y = o[1], ray.org_z = o[2];
  ray.dir_x = d[0], ray.dir_y = d[1], ray.dir_z = d[2];
  ray.t_far = t_max;
  ray.mask = 0xffffffffu;
  return ray;
}

void set_ray(embree::Ray16& rays, unsigned i, float const (&o)[3], float const (&d)[3], float t_max) {
  rays.org_x[i] = o[0], rays.org_y[i] = o[1], rays.org_z[i] = o[2];
  rays.dir_x[i] = d[0], rays.dir_y[i] = d[1], rays.dir_z[i] = d[2];
  rays.t_near[i] = 0, rays.time[i] = 0, rays.t_far[i] = t_max;
  rays.mask[i] = 0xffffffffu, rays.id[i] = i, rays.flags[i] = 0;
}

/// False: there is no ray.
bool load_ray(FreeRays const& rays, std::size_t i, float (&o)[3], float (&d)[3]) {
  auto const &origin = rays.origins[i], &direction = rays.directions[i];
  o[0] = origin.x, o[1] = origin.y, o[2] = origin.z;
  d[0] = direction.x, d[1] = direction.y, d[2] = direction.z;
  return d[0] != 0 || d[1] != 0 || d[2] != 0;
}

/// `instance`: 0 is the number of the world's own triangles.
RayHit hit_of(float t, unsigned geometry, unsigned primitive, unsigned instance) {
  if (geometry == embree::invalid_id) return {infinity};
  return {t, primitive, instance == embree::invalid_id ? RayHit::none : instance - 1};
}

constexpr int triangle_geometry = 0, instance_geometry = 121, index_buffer = 0,
              vertex_buffer = 1;  // RTCGeometryType, RTCBufferType
constexpr int format_uint3 = 0x5003, format_float3 = 0x9003, format_float3x4_columns = 0x9234;  // RTCFormat

}  // namespace

struct EmbreeTracer::State {
  embree::Library const* api;
  std::atomic<std::int64_t> bytes = 0;
  embree::Object device = nullptr, scene = nullptr;
  embree::Object object = nullptr;  // what instances show
  int threads = 1;

  ~State() {
    api->release_scene(scene);
    if (object) api->release_scene(object);
    api->release_device(device);
  }
};

EmbreeTracer::EmbreeTracer(embree::Library const& library, BenchScene const& scene, Quality quality, int threads)
    : state_(std::make_unique<State>()) {
  State& s = *state_;
  s.api = &library;
  s.threads = threads;
  s.device = library.new_device(("threads=" + std::to_string(threads)).c_str());
  library.set_memory_monitor(s.device, count_bytes, &s.bytes);
  auto const attach = [&](embree::Object to, embree::Object geometry) {
    library.commit_geometry(geometry);
    library.attach_geometry(to, geometry);
    library.release_geometry(geometry);
  };
  auto const scene_of = [&](TriangleMesh const& mesh) {
    embree::Object const made = library.new_scene(s.device);
    library.set_build_quality(made, int(quality));
    embree::Object const geometry = library.new_geometry(s.device, triangle_geometry);
    auto const copy = [&](auto const& elements, int buffer, int format) {
      void* const to = library.new_buffer(geometry, buffer, 0, format, sizeof elements[0], elements.size());
      std::memcpy(to, elements.data(), sizeof elements[0] * elements.size());
    };
    copy(mesh.positions, vertex_buffer, format_float3);
    copy(mesh.triangles, index_buffer, format_uint3);
    attach(made, geometry);
    return made;
  };
  s.scene = scene_of(scene.world);
  if (scene.placements.empty()) return;
  s.object = scene_of(scene.object);
  for (Transform const& placement : scene.placements) {
    embree::Object const instance = library.new_geometry(s.device, instance_geometry);
    library.set_instanced_scene(instance, s.object);
    glm::mat4x3 const world_from_object(placement.matrix());  // columns
    library.set_transform(instance, 0, format_float3x4_columns, &world_from_object);
    attach(s.scene, instance);
  }
}

EmbreeTracer::~EmbreeTracer() = default;
void EmbreeTracer::build() {
  if (state_->object) state_->api->commit_scene(state_->object);
  state_->api->commit_scene(state_->scene);
}
std::size_t EmbreeTracer::device_bytes() const { return std::size_t(state_->bytes.load()); }

void EmbreeTracer::closest(PrimaryRays const& rays, std::vector<RayHit>& hits, bool packets) const {
  auto const& camera = rays.camera;
  float const origin[3] = {camera.origin.x, camera.origin.y, camera.origin.z};
  auto const direction = [&](int px, int py, float(&d)[3]) {
    float const x = (float(px) + 0.5f) * rays.pixels_per_ray, y = (float(py) + 0.5f) * rays.pixels_per_ray;
    d[0] = camera.corner.x + x * camera.step_x.x + y * camera.step_y.x;
    d[1] = camera.corner.y + x * camera.step_x.y + y * camera.step_y.y;
    d[2] = camera.corner.z + x * camera.step_x.z + y * camera.step_y.z;
  };
  if (!packets) {
    parallel_blocks(rays.width, rays.height, 1, state_->threads, [&](int x, int y) {
      float d[3];
      direction(x, y, d);
      embree::RayHit query;
      query.ray = make_ray(origin, d, infinity);
      query.geometry = embree::invalid_id;
      query.instance = embree::invalid_id;
      state_->api->closest(state_->scene, embree::Coherence::coherent, query);
      hits[std::size_t(y) * std::size_t(rays.width) + std::size_t(x)] =
          hit_of(query.ray.t_far, query.geometry, query.primitive, query.instance);
    });
    return;
  }
  parallel_blocks(rays.width, rays.height, packet_width, state_->threads, [&](int x, int y) {
    embree::RayHit16 query;
    alignas(64) int valid[16];
    for (unsigned i = 0; i < 16; ++i) {
      int const px = x + int(i) % packet_width, py = y + int(i) / packet_width;
      valid[i] = px < rays.width && py < rays.height ? -1 : 0;
      float d[3];
      direction(px, py, d);
      set_ray(query.ray, i, origin, d, infinity);
      query.geometry[i] = embree::invalid_id;
      query.instance[i] = embree::invalid_id;
    }
    state_->api->closest(valid, state_->scene, embree::Coherence::coherent, query);
    for (unsigned i = 0; i < 16; ++i) {
      if (!valid[i]) continue;
      int const px = x + int(i) % packet_width, py = y + int(i) / packet_width;
      hits[std::size_t(py) * std::size_t(rays.width) + std::size_t(px)] =
          hit_of(query.ray.t_far[i], query.geometry[i], query.primitive[i], query.instance[i]);
    }
  });
}

void EmbreeTracer::any(ShadowRays const& rays, std::vector<std::uint8_t>& occluded, bool packets) const {
  int const step = packets ? packet_width : 1;
  parallel_blocks(rays.width, rays.height, step, state_->threads, [&](int x, int y) {
    auto const index = [&](int i) {
      return std::size_t(y + i / packet_width) * std::size_t(rays.width) + std::size_t(x + i % packet_width);
    };
    auto const to_light = [&](std::size_t i, float(&o)[3], float(&d)[3]) {
      auto const& p = rays.points[i];
      o[0] = p.x, o[1] = p.y, o[2] = p.z;
      d[0] = rays.light.x - p.x, d[1] = rays.light.y - p.y, d[2] = rays.light.z - p.z;
    };
    float o[3], d[3];
    if (!packets) {
      if (rays.points[index(0)].w == 0) {
        occluded[index(0)] = 0;
        return;
      }
      to_light(index(0), o, d);
      embree::Ray ray = make_ray(o, d, 1.0f);
      state_->api->any(state_->scene, embree::Coherence::coherent, ray);
      occluded[index(0)] = ray.t_far < 0;
      return;
    }
    embree::Ray16 query;
    alignas(64) int valid[16];
    for (int i = 0; i < 16; ++i) {
      bool const inside = x + i % packet_width < rays.width && y + i / packet_width < rays.height;
      valid[i] = inside && rays.points[index(i)].w != 0 ? -1 : 0;
      if (valid[i]) {
        to_light(index(i), o, d);
      }
      set_ray(query, unsigned(i), o, d, 1.0f);
    }
    state_->api->any(valid, state_->scene, embree::Coherence::coherent, query);
    for (int i = 0; i < 16; ++i) {
      bool const inside = x + i % packet_width < rays.width && y + i / packet_width < rays.height;
      if (inside) occluded[index(i)] = valid[i] && query.t_far[i] < 0;
    }
  });
}

void EmbreeTracer::closest(FreeRays const& rays, std::vector<RayHit>& hits, bool packets) const {
  parallel_runs(rays.size(), state_->threads, packets ? 16 : 1, [&](std::size_t first, std::size_t count) {
    float o[3], d[3];
    if (!packets) {
      embree::RayHit query;
      bool const exists = load_ray(rays, first, o, d);
      query.ray = make_ray(o, d, infinity);
      query.geometry = query.instance = embree::invalid_id;
      if (exists) state_->api->closest(state_->scene, embree::Coherence::incoherent, query);
      hits[first] = hit_of(query.ray.t_far, query.geometry, query.primitive, query.instance);
      return;
    }
    embree::RayHit16 query;
    alignas(64) int valid[16];
    for (unsigned i = 0; i < 16; ++i) {
      valid[i] = i < count && load_ray(rays, first + i, o, d) ? -1 : 0;
      set_ray(query.ray, i, o, d, infinity);
      query.geometry[i] = query.instance[i] = embree::invalid_id;
    }
    state_->api->closest(valid, state_->scene, embree::Coherence::incoherent, query);
    for (unsigned i = 0; i < count; ++i) {
      hits[first + i] = hit_of(query.ray.t_far[i], query.geometry[i], query.primitive[i], query.instance[i]);
    }
  });
}

void EmbreeTracer::any(FreeRays const& rays, std::vector<std::uint8_t>& occluded, bool packets) const {
  parallel_runs(rays.size(), state_->threads, packets ? 16 : 1, [&](std::size_t first, std::size_t count) {
    float o[3], d[3];
    if (!packets) {
      bool const exists = load_ray(rays, first, o, d);
      embree::Ray query = make_ray(o, d, rays.t_max);
      if (exists) state_->api->any(state_->scene, embree::Coherence::incoherent, query);
      occluded[first] = query.t_far < 0;
      return;
    }
    embree::Ray16 query;
    alignas(64) int valid[16];
    for (unsigned i = 0; i < 16; ++i) {
      valid[i] = i < count && load_ray(rays, first + i, o, d) ? -1 : 0;
      set_ray(query, i, o, d, rays.t_max);
    }
    state_->api->any(valid, state_->scene, embree::Coherence::incoherent, query);
    for (unsigned i = 0; i < count; ++i) occluded[first + i] = query.t_far[i] < 0;
  });
}

}  // namespace lichtraum::bench
