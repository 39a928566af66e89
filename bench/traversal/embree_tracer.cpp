#include "embree_tracer.hpp"

#include <atomic>
#include <chrono>
#include <cmath>
#include <cstring>
#include <ctime>
#include <limits>
#include <stdexcept>
#include <string>
#include <thread>

#include "embree_api.hpp"

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

RTCRay make_ray(float const (&o)[3], float const (&d)[3], float t_max) {
  RTCRay ray{};
  ray.org_x = o[0], ray.org_y = o[1], ray.org_z = o[2];
  ray.dir_x = d[0], ray.dir_y = d[1], ray.dir_z = d[2];
  ray.tfar = t_max;
  ray.mask = 0xffffffffu;
  return ray;
}

void set_ray(RTCRay16& rays, unsigned i, float const (&o)[3], float const (&d)[3], float t_max) {
  rays.org_x[i] = o[0], rays.org_y[i] = o[1], rays.org_z[i] = o[2];
  rays.dir_x[i] = d[0], rays.dir_y[i] = d[1], rays.dir_z[i] = d[2];
  rays.tnear[i] = 0, rays.time[i] = 0, rays.tfar[i] = t_max;
  rays.mask[i] = 0xffffffffu, rays.id[i] = i, rays.flags[i] = 0;
}

RayHit hit_of(float t, unsigned geometry, unsigned primitive) {
  if (geometry == RTC_INVALID_GEOMETRY_ID) return {infinity, 0xffffffffu};
  return {t, primitive};
}

}  // namespace

struct EmbreeTracer::State {
  std::atomic<std::int64_t> bytes = 0;
  RTCDevice device = nullptr;
  RTCScene scene = nullptr;
  int threads = 1;
  double build_ms = 0;
  double build_processor_ms = 0;

  ~State() {
    rtcReleaseScene(scene);
    rtcReleaseDevice(device);
  }
};

EmbreeTracer::EmbreeTracer(TriangleMesh const& mesh, Quality quality, int threads) : state_(std::make_unique<State>()) {
  State& s = *state_;
  s.threads = threads;
  s.device = rtcNewDevice(("threads=" + std::to_string(threads)).c_str());
  if (!s.device) throw std::runtime_error("Embree finds no device");
  rtcSetDeviceMemoryMonitorFunction(s.device, count_bytes, &s.bytes);
  s.scene = rtcNewScene(s.device);
  rtcSetSceneBuildQuality(s.scene, quality == Quality::high ? RTC_BUILD_QUALITY_HIGH : RTC_BUILD_QUALITY_MEDIUM);
  RTCGeometry const geometry = rtcNewGeometry(s.device, RTC_GEOMETRY_TYPE_TRIANGLE);
  void* const positions = rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                                                  sizeof mesh.positions[0], mesh.positions.size());
  std::memcpy(positions, mesh.positions.data(), sizeof mesh.positions[0] * mesh.positions.size());
  void* const triangles = rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                                                  sizeof mesh.triangles[0], mesh.triangles.size());
  std::memcpy(triangles, mesh.triangles.data(), sizeof mesh.triangles[0] * mesh.triangles.size());
  rtcCommitGeometry(geometry);
  rtcAttachGeometry(s.scene, geometry);
  rtcReleaseGeometry(geometry);
  auto const start = std::chrono::steady_clock::now();
  std::clock_t const clock = std::clock();
  rtcCommitScene(s.scene);
  s.build_processor_ms = 1e3 * double(std::clock() - clock) / CLOCKS_PER_SEC;
  s.build_ms = std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
}

EmbreeTracer::~EmbreeTracer() = default;
double EmbreeTracer::build_ms() const { return state_->build_ms; }
double EmbreeTracer::build_processor_ms() const { return state_->build_processor_ms; }
std::size_t EmbreeTracer::device_bytes() const { return std::size_t(state_->bytes.load()); }

void EmbreeTracer::closest(PrimaryRays const& rays, std::vector<RayHit>& hits, bool packets) const {
  auto const& camera = rays.camera;
  float const origin[3] = {camera.origin.x, camera.origin.y, camera.origin.z};
  EmbreeQuery const coherent(Coherence::coherent);
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
      RTCRayHit query;
      query.ray = make_ray(origin, d, infinity);
      query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
      query.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
      auto own = coherent;
      own.closest(state_->scene, query);
      hits[std::size_t(y) * std::size_t(rays.width) + std::size_t(x)] =
          hit_of(query.ray.tfar, query.hit.geomID, query.hit.primID);
    });
    return;
  }
  parallel_blocks(rays.width, rays.height, packet_width, state_->threads, [&](int x, int y) {
    alignas(64) RTCRayHit16 query;
    alignas(64) int valid[16];
    for (unsigned i = 0; i < 16; ++i) {
      int const px = x + int(i) % packet_width, py = y + int(i) / packet_width;
      valid[i] = px < rays.width && py < rays.height ? -1 : 0;
      float d[3];
      direction(px, py, d);
      set_ray(query.ray, i, origin, d, infinity);
      query.hit.geomID[i] = RTC_INVALID_GEOMETRY_ID;
      query.hit.instID[0][i] = RTC_INVALID_GEOMETRY_ID;
    }
    auto own = coherent;
    own.closest(valid, state_->scene, query);
    for (unsigned i = 0; i < 16; ++i) {
      if (!valid[i]) continue;
      int const px = x + int(i) % packet_width, py = y + int(i) / packet_width;
      hits[std::size_t(py) * std::size_t(rays.width) + std::size_t(px)] =
          hit_of(query.ray.tfar[i], query.hit.geomID[i], query.hit.primID[i]);
    }
  });
}

void EmbreeTracer::any(ShadowRays const& rays, std::vector<std::uint8_t>& occluded, bool packets) const {
  EmbreeQuery const coherent(Coherence::coherent);
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
    auto own = coherent;
    if (!packets) {
      if (rays.points[index(0)].w == 0) {
        occluded[index(0)] = 0;
        return;
      }
      to_light(index(0), o, d);
      RTCRay ray = make_ray(o, d, 1.0f);
      own.any(state_->scene, ray);
      occluded[index(0)] = ray.tfar < 0;
      return;
    }
    alignas(64) RTCRay16 query;
    alignas(64) int valid[16];
    for (int i = 0; i < 16; ++i) {
      bool const inside = x + i % packet_width < rays.width && y + i / packet_width < rays.height;
      valid[i] = inside && rays.points[index(i)].w != 0 ? -1 : 0;
      if (valid[i]) {
        to_light(index(i), o, d);
      }
      set_ray(query, unsigned(i), o, d, 1.0f);
    }
    own.any(valid, state_->scene, query);
    for (int i = 0; i < 16; ++i) {
      bool const inside = x + i % packet_width < rays.width && y + i / packet_width < rays.height;
      if (inside) occluded[index(i)] = valid[i] && query.tfar[i] < 0;
    }
  });
}

void EmbreeTracer::closest(FreeRays const& rays, std::vector<RayHit>& hits, bool packets) const {
  constexpr std::size_t chunk = 1024;
  parallel((rays.size() + chunk - 1) / chunk, state_->threads, [&](std::size_t part) {
    EmbreeQuery incoherent(Coherence::incoherent);
    std::size_t const end = std::min(rays.size(), (part + 1) * chunk);
    for (std::size_t first = part * chunk; first < end; first += packets ? 16 : 1) {
      float o[3], d[3];
      auto const load = [&](std::size_t i) {
        auto const &origin = rays.origins[i], &direction = rays.directions[i];
        o[0] = origin.x, o[1] = origin.y, o[2] = origin.z;
        d[0] = direction.x, d[1] = direction.y, d[2] = direction.z;
        return d[0] != 0 || d[1] != 0 || d[2] != 0;
      };
      if (!packets) {
        RTCRayHit query;
        bool const traced = load(first);
        query.ray = make_ray(o, d, infinity);
        query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
        query.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
        if (traced) incoherent.closest(state_->scene, query);
        hits[first] = hit_of(query.ray.tfar, query.hit.geomID, query.hit.primID);
        continue;
      }
      alignas(64) RTCRayHit16 query;
      alignas(64) int valid[16];
      for (unsigned i = 0; i < 16; ++i) {
        valid[i] = first + i < end && load(first + i) ? -1 : 0;
        set_ray(query.ray, i, o, d, infinity);
        query.hit.geomID[i] = RTC_INVALID_GEOMETRY_ID;
        query.hit.instID[0][i] = RTC_INVALID_GEOMETRY_ID;
      }
      incoherent.closest(valid, state_->scene, query);
      for (unsigned i = 0; i < 16 && first + i < end; ++i) {
        hits[first + i] = hit_of(query.ray.tfar[i], query.hit.geomID[i], query.hit.primID[i]);
      }
    }
  });
}

}  // namespace lichtraum::bench
