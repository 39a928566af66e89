#include "lichtraum/camera.hpp"

#include <set>

#include "reference.hpp"
#include "shared/frame.h"
#include "shared/sampling.h"
#include "support/catch.hpp"
#include "support/opencl_probe.hpp"
#include "support/skip.hpp"

using namespace lichtraum;
using namespace lichtraum::test;

namespace {
struct PixelSample {
  device::uint x, y, sample, unused;
};

device::ProjectiveCamera pinhole(float4 const& origin, float4 const& corner, float4 const& step_x,
                                 float4 const& step_y) {
  return {origin, corner, step_x, step_y, {}, 0, {}};
}

/// A ray through a pixel of each frame.
struct CameraRays {
  explicit CameraRays(std::size_t count) : frames(count), pixels(count), origins(count), directions(count) {
    for (device::FrameParameters& frame : frames) frame.sample_count = 1;
  }
  void trace() {
    ProbeProgram("camera.cl")
        .run("probe_camera_ray", frames.size(), {in(frames), in(pixels), out(origins), out(directions)});
  }
  /// Towards the middle of the pixel; of any length.
  Vec3 through_pixel(std::size_t i) const {
    device::ProjectiveCamera const& camera = frames[i].camera;
    return to_vec3(camera.corner) + (pixels[i].x + 0.5) * to_vec3(camera.step_x) +
           (pixels[i].y + 0.5) * to_vec3(camera.step_y);
  }

  struct Pixel {
    device::uint x, y;
  };
  std::vector<device::FrameParameters> frames;
  std::vector<Pixel> pixels;
  std::vector<float4> origins, directions;
};
}  // namespace

TEST_CASE("Camera rays go through the image point", "[kernel]") {
  NEEDS_OPENCL_DEVICE();
  Random random(1);
  std::size_t const count = scaled_count(20000);
  CameraRays rays(count);
  for (std::size_t i = 0; i < count; ++i) {
    double const scale = std::pow(10., random.uniform(-6, 6));
    rays.frames[i].camera = pinhole(to_float4(random.in_cube(1e6)), to_float4(random.in_cube(scale)),
                                    to_float4(random.in_cube(scale * 1e-3)), to_float4(random.in_cube(scale * 1e-3)));
    rays.pixels[i] = {device::uint(random.index(4000)), device::uint(random.index(4000))};
  }
  rays.trace();
  for (std::size_t i = 0; i < count; ++i) {
    auto const& camera = rays.frames[i].camera;
    double const x = rays.pixels[i].x + 0.5, y = rays.pixels[i].y + 0.5;
    Vec3 const expected = rays.through_pixel(i);
    // The terms may cancel: their size counts.
    double const terms = glm::length(to_vec3(camera.corner)) + x * glm::length(to_vec3(camera.step_x)) +
                         y * glm::length(to_vec3(camera.step_y));
    double const tolerance = 8 * rounding_unit * terms / glm::length(expected);
    Vec3 const direction = to_vec3(rays.directions[i]);
    if (to_vec3(rays.origins[i]) != to_vec3(camera.origin) || rays.origins[i].w != float_infinity ||
        glm::length(direction - glm::normalize(expected)) > tolerance || std::abs(glm::length(direction) - 1) > 3e-7) {
      FAIL("ray " << i);
    }
  }
}

TEST_CASE("Rays through a lens spread over its disc and meet in focus", "[kernel]") {
  NEEDS_OPENCL_DEVICE();
  Random random(2);
  std::size_t const count = scaled_count(20000);
  CameraRays rays(count);
  for (std::size_t i = 0; i < count; ++i) {
    rays.frames[i].camera = pinhole(to_float4(random.in_cube(10)), to_float4({-0.4, 0.3, -1}), to_float4({0.001, 0, 0}),
                                    to_float4({0, -0.001, 0}));
    rays.frames[i].lens = {to_float4({0.2, 0, 0}), to_float4({0, 0.2, 0}), float(random.uniform(0.5, 5)), 1, {}};
    rays.frames[i].seed_low = device::uint(i);
    rays.pixels[i] = {device::uint(random.index(800)), device::uint(random.index(600))};
  }
  rays.trace();
  double quarters[2][2] = {}, inner = 0;
  for (std::size_t i = 0; i < count; ++i) {
    auto const& camera = rays.frames[i].camera;
    auto const& lens = rays.frames[i].lens;
    Vec3 const from_center = (to_vec3(rays.origins[i]) - to_vec3(camera.origin)) / 0.2;
    Vec3 const sharp = to_vec3(camera.origin) + double(lens.focus) * rays.through_pixel(i);
    Vec3 const direction = to_vec3(rays.directions[i]), way = sharp - to_vec3(rays.origins[i]);
    if (glm::length(way - glm::dot(way, direction) * direction) > 1e-5) FAIL("ray " << i << " misses its focus");
    if (glm::length(from_center) > 1 + 1e-4 || std::abs(from_center.z) > 1e-4) FAIL("ray " << i << " misses the lens");
    ++quarters[from_center.x > 0][from_center.y > 0];
    inner += glm::length(from_center) < std::sqrt(0.5);
  }
  double const deviation = 4.5 * std::sqrt(double(count));
  for (auto const& half : quarters) {
    for (double const quarter : half) CHECK(std::abs(quarter - 0.25 * double(count)) < 0.44 * deviation);
  }
  CHECK(std::abs(inner - 0.5 * double(count)) < 0.5 * deviation);
}

TEST_CASE("An orthographic camera's rays are parallel, begin in its plane, and meet in focus behind a lens",
          "[kernel]") {
  NEEDS_OPENCL_DEVICE();
  Random random(4);
  std::size_t const count = scaled_count(20000);
  CameraRays rays(count);
  for (std::size_t i = 0; i < count; ++i) {
    Vec3 const direction = 3.0 * random.direction();
    rays.frames[i].camera = {to_float4(random.in_cube(10)),
                             to_float4(random.in_cube(4)),
                             to_float4(random.in_cube(0.01)),
                             to_float4(random.in_cube(0.01)),
                             to_float4(direction),
                             1,
                             {}};
    rays.frames[i].seed_low = device::uint(i);
    if (i % 2 == 1) rays.frames[i].lens = {to_float4({0.2, 0, 0}), to_float4({0, 0.2, 0}), 1.5f, 1, {}};
    rays.pixels[i] = {device::uint(random.index(800)), device::uint(random.index(600))};
  }
  rays.trace();
  int moved = 0;
  for (std::size_t i = 0; i < count; ++i) {
    auto const& camera = rays.frames[i].camera;
    bool const has_lens = rays.frames[i].lens.has_area != 0;
    Vec3 const middle = to_vec3(camera.origin) + rays.through_pixel(i),
               sharp = middle + 1.5 * to_vec3(camera.direction);
    Vec3 const origin = to_vec3(rays.origins[i]), direction = to_vec3(rays.directions[i]);
    Vec3 const expected = has_lens ? glm::normalize(sharp - origin) : glm::normalize(to_vec3(camera.direction));
    moved += glm::distance(origin, middle) > 0.02;
    if (glm::distance(direction, expected) > 1e-5) FAIL("ray " << i << " goes elsewhere");
    if (glm::distance(origin, middle) > (has_lens ? 0.2 : 0) + 1e-5) FAIL("ray " << i << " begins elsewhere");
  }
  CHECK(moved > 0.98 * double(count) / 2);
}

TEST_CASE("Samples lie in the middles of the grid's cells, one in the centre", "[kernel]") {
  NEEDS_OPENCL_DEVICE();
  ProbeProgram const program("camera.cl");
  for (device::uint const side : {1u, 2u, 3u, 7u, 64u, 1000u}) {
    std::vector<device::uint> const samples = {0u, side - 1, side * side / 2, side * side - 1};
    std::vector<device::PixelOffset> offsets(samples.size());
    program.run("probe_sample_in_grid", samples.size(), {value(side * side), in(samples), out(offsets)});
    for (std::size_t i = 0; i < samples.size(); ++i) {
      CHECK(offsets[i].x == Approx((samples[i] % side + 0.5) / side).epsilon(1e-6));
      CHECK(offsets[i].y == Approx((samples[i] / side + 0.5) / side).epsilon(1e-6));
    }
  }
}

TEST_CASE("Seeded samples are the host's, to the bit", "[kernel]") {
  NEEDS_OPENCL_DEVICE();
  Random random(2);
  std::size_t const count = scaled_count(100000);
  std::vector<device::FrameParameters> frame(1);
  frame[0].seed_low = 0xdeadbeef;
  frame[0].seed_high = 17;
  std::vector<PixelSample> samples(count);
  for (auto& s : samples) {
    s = {device::uint(random.index(100000)), device::uint(random.index(100000)), device::uint(random.index(5000)), 0};
  }
  std::vector<device::PixelOffset> offsets(count);
  ProbeProgram("camera.cl").run("probe_seeded_sample", count, {in(frame), in(samples), out(offsets)});
  std::size_t different = 0;
  for (std::size_t i = 0; i < count; ++i) {
    auto const expected = device::seeded_pixel_offset(samples[i].x, samples[i].y, samples[i].sample, 0xdeadbeef, 17);
    different += expected.x != offsets[i].x || expected.y != offsets[i].y;
  }
  CHECK(different == 0);
}
