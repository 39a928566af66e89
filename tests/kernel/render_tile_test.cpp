#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "compile/material_table.hpp"
#include "lichtraum/film.hpp"
#include "random_scene.hpp"
#include "scene/device_light.hpp"
#include "shared/frame.h"
#include "support/catch.hpp"
#include "support/skip.hpp"

using namespace lichtraum;
using namespace lichtraum::test;

namespace {

constexpr device::uint untouched = 0xffffffffu;

/// A small picture of every kind of shape, with mirrors, glass, an instance and two lights.
struct SmallPicture {
  SceneArrays scene;
  std::vector<device::FrameParameters> frame = std::vector<device::FrameParameters>(1);
  Film film;

  explicit SmallPicture(device::uint sample_count, PlaneSet const& planes = {FilmPlane::radiance}) {
    for (auto const& [reflect, transmit] : {std::pair{0., 0.}, {0.5, 0.}, {0.1, 0.8}}) {
      scene.materials.push_back(phong_material({"", PhongModel{.ka = {0.1, 0.2, 0.1},
                                                               .kd = {0.5, 0.6, 0.7},
                                                               .ks = Rgb(0.3),
                                                               .m = 20,
                                                               .reflect = reflect,
                                                               .transmit = transmit,
                                                               .ior = 1.5}}));
    }
    scene.lights.push_back(*device_light(Light::point("", {3, 5, 4}, {1, 0.9, 0.8})));
    scene.lights.push_back(*device_light(Light::point("", {-3, 2, 4}, {0.2, 0.3, 0.4})));
    scene.add(make_box({}, Vec3(-0.3), Vec3(0.3), 1));
    scene.add(make_sphere({0, 0.5, 0}, 0.3, 2));
    auto const [object, bounds] = scene.close_object();
    scene.add(make_triangle({-9, -1, -9}, {9, -1, -9}, {0, -1, 9}));
    scene.add(make_ellipsoid({Mat3(0.5, 0, 0, 0, 0.8, 0, 0, 0, 0.5), {0, 0, -2}}, 1));
    scene.add_instance({Mat3(1), {-1.2, 0, -3}}, object, bounds);
    scene.add_instance({Mat3(1, 0, 0, 0, -2, 0, 0, 0, 1), {1.2, 0.5, -3}}, object, bounds);
    scene.close_object();
    auto& f = frame[0];
    bool const interpreted = scaled_count(100) < 100;
    device::uint const width = interpreted ? 10 : 20, height = interpreted ? 7 : 14;
    f.region_width = width;
    f.region_height = height;
    f.camera.corner = {-0.5f, 0.35f, -1, 0};
    f.camera.step_x = {1.f / float(width), 0, 0, 0};
    f.camera.step_y = {0, -0.7f / float(height), 0, 0};
    f.ambient = {0.3f, 0.3f, 0.3f, 0};
    f.background = f.background_top = {0.1f, 0.1f, 0.2f, 0};
    f.sampling = SAMPLING_SEEDED;
    f.sample_count = sample_count;
    f.seed_low = 7;
    f.max_depth = interpreted ? 2 : 5;
    film = Film({0, 0, int(width), int(height)}, planes);
    for (FilmPlane const plane : planes.list()) {
      std::ranges::fill(film.floats(plane), -1.f);
      std::ranges::fill(film.numbers(plane), untouched);
    }
  }

  std::vector<float> radiance() {
    auto const sums = film.floats(FilmPlane::radiance);
    return {sums.begin(), sums.end()};
  }
  device::uint width() const { return frame[0].region_width; }
  device::uint height() const { return frame[0].region_height; }

  std::vector<device::WorkItemRays> render(ProbeProgram const& program, device::Tile const& tile) {
    std::vector<device::WorkItemRays> rays(tile.width * tile.height);
    std::vector<std::vector<float>> floats;
    std::vector<std::vector<device::uint>> numbers;
    floats.reserve(plane_count);
    numbers.reserve(plane_count);
    std::vector<ProbeArgument> arguments;
    for (std::size_t i = 0; i < plane_count; ++i) {
      auto const plane = FilmPlane(i);
      if (info_of(plane).is_number) {
        auto& values = numbers.emplace_back(film.numbers(plane).begin(), film.numbers(plane).end());
        values.resize(std::max<std::size_t>(values.size(), 1));
        arguments.push_back(updated(values));
      } else {
        auto& values = floats.emplace_back(film.floats(plane).begin(), film.floats(plane).end());
        values.resize(std::max<std::size_t>(values.size(), 1));
        arguments.push_back(updated(values));
      }
    }
    for (ProbeArgument const& argument : {value(film.planes().bits()), in(frame), value(tile), out(rays)}) {
      arguments.push_back(argument);
    }
    program.run("render_tile", tile.width, scene.arguments(arguments), tile.height, 8, 8);
    auto next_floats = floats.begin();
    auto next_numbers = numbers.begin();
    for (std::size_t i = 0; i < plane_count; ++i) {
      auto const plane = FilmPlane(i);
      if (info_of(plane).is_number) {
        std::copy_n(next_numbers++->begin(), film.numbers(plane).size(), film.numbers(plane).begin());
      } else {
        std::copy_n(next_floats++->begin(), film.floats(plane).size(), film.floats(plane).begin());
      }
    }
    return rays;
  }
};

}  // namespace

TEST_CASE("A picture is the same bytes however it is cut into tiles and samples", "[kernel]") {
  NEEDS_OPENCL_DEVICE();
  ProbeProgram const program("render.cl");
  SmallPicture whole(4);
  auto const rays = whole.render(program, {0, 0, whole.width(), whole.height(), 0, 4, {}});
  device::WorkItemRays sum{};
  for (auto const& r : rays) {
    sum.camera_hits += r.camera_hits;
    sum.shadow += r.shadow;
    sum.secondary += r.secondary;
  }
  device::uint const samples = whole.width() * whole.height() * 4;
  CHECK(sum.camera_hits > samples / 4);
  CHECK(sum.camera_hits < samples);
  CHECK(sum.shadow > sum.camera_hits);
  CHECK(sum.secondary > samples / 10);
  for (float const c : whole.film.floats(FilmPlane::radiance)) {
    if (!(c >= 0 && c < 100)) FAIL("not a sum of radiance: " << c);
  }

  SmallPicture cut(4);
  for (auto const& [first, count] : {std::pair{0u, 1u}, {1u, 2u}, {3u, 1u}}) {
    device::uint const right = cut.width() - 3, below = cut.height() - 2;
    cut.render(program, {0, 0, 3, cut.height(), first, count, {}});
    cut.render(program, {3, 0, right, 2, first, count, {}});
    cut.render(program, {3, 2, right, below, first, count, {}});
  }
  CHECK(cut.radiance() == whole.radiance());
}

TEST_CASE("Only the tile's pixels are written", "[kernel]") {
  NEEDS_OPENCL_DEVICE();
  SmallPicture picture(1);
  picture.render(ProbeProgram("render.cl"), {3, 4, 5, 2, 0, 1, {}});
  std::size_t wrong = 0;
  auto const radiance = picture.radiance();
  for (std::size_t i = 0; i < radiance.size(); ++i) {
    std::size_t const x = i / 3 % picture.width(), y = i / 3 / picture.width();
    bool const inside = x >= 3 && x < 8 && y >= 4 && y < 6;
    wrong += inside != (radiance[i] != -1.f);
  }
  CHECK(wrong == 0);
}

TEST_CASE("One launch writes all planes, and only those that are wanted", "[kernel]") {
  NEEDS_OPENCL_DEVICE();
  ProbeProgram const program("render.cl");
  PlaneSet all;
  for (std::size_t i = 0; i < plane_count; ++i) all.add(FilmPlane(i));
  SmallPicture picture(2, all);
  device::Tile const tile{0, 0, picture.width(), picture.height(), 0, 2, {}};
  picture.render(program, tile);
  for (FilmPlane const plane : all.list()) {
    INFO("plane " << info_of(plane).name);
    PlaneSet wanted{plane};
    if (plane == FilmPlane::radiance) wanted.add(FilmPlane::alpha);  // which leaves out the background
    SmallPicture alone(2, wanted);
    alone.render(program, tile);
    CHECK(std::ranges::equal(alone.film.floats(plane), picture.film.floats(plane)));
    CHECK(std::ranges::equal(alone.film.numbers(plane), picture.film.numbers(plane)));
  }
  Film& film = picture.film;
  std::size_t hits = 0;
  std::set<device::uint> instances;
  for (std::size_t i = 0; i < film.floats(FilmPlane::depth).size(); ++i) {
    INFO("pixel " << i);
    float const depth = film.floats(FilmPlane::depth)[i];
    bool const is_hit = std::isfinite(depth);
    CHECK(is_hit == (film.numbers(FilmPlane::object)[i] != untouched));
    CHECK(is_hit == (film.numbers(FilmPlane::material)[i] != untouched));
    float const* const position = &film.floats(FilmPlane::position)[3 * i];
    float const* const normal = &film.floats(FilmPlane::normal)[3 * i];
    float const alpha = film.floats(FilmPlane::alpha)[i];
    CHECK((alpha == 0 || alpha == 1 || alpha == 2));
    CHECK(std::hypot(normal[0], normal[1], normal[2]) <= alpha * 1.0001f);
    if (!is_hit) continue;
    ++hits;
    CHECK((depth > 1 && depth < 20));
    CHECK(std::hypot(position[0], position[1], position[2]) == Approx(depth));  // the camera is at the origin
    CHECK(film.numbers(FilmPlane::material)[i] < 3);
    instances.insert(film.numbers(FilmPlane::instance)[i]);
  }
  CHECK((hits > 0 && hits < film.floats(FilmPlane::depth).size()));
  CHECK(instances == std::set<device::uint>{0, 1, untouched});  // the last: the world itself
}

TEST_CASE("Radiance that is not finite is counted, and not in the sums", "[kernel]") {
  NEEDS_OPENCL_DEVICE();
  SmallPicture picture(2);
  picture.frame[0].background.y = picture.frame[0].background_top.y = INFINITY;
  device::uint not_finite = 0;
  for (auto const& rays :
       picture.render(ProbeProgram("render.cl"), {0, 0, picture.width(), picture.height(), 0, 2, {}})) {
    not_finite += rays.not_finite;
  }
  CHECK(not_finite > 0);
  CHECK(not_finite < 2 * picture.width() * picture.height());
  for (float const c : picture.radiance()) REQUIRE(std::isfinite(c));
}

TEST_CASE("A ray stack of max_depth + 1 holds the whole tree of rays", "[kernel]") {
  NEEDS_OPENCL_DEVICE();
  SmallPicture enough(1), plenty(1);
  device::uint const depth = std::min(3u, enough.frame[0].max_depth);
  for (auto* picture : {&enough, &plenty}) {
    picture->frame[0].max_depth = depth;
    picture->scene.materials.assign(3, picture->scene.materials[2]);  // glass that mirrors, everywhere
    picture->scene.materials[0].reflect = picture->scene.materials[1].reflect = 0.4f;
    picture->scene.materials[0].transmit = picture->scene.materials[1].transmit = 0.5f;
  }
  enough.render(ProbeProgram("render.cl", fmt::format("-D RAY_STACK_SIZE={}", depth + 1)),
                {0, 0, enough.width(), enough.height(), 0, 1, {}});
  plenty.render(ProbeProgram("render.cl", "-D RAY_STACK_SIZE=32"), {0, 0, enough.width(), enough.height(), 0, 1, {}});
  CHECK(enough.radiance() == plenty.radiance());
}
