#include <fmt/format.h>

#include <cmath>
#include <set>

#include "compile/material_table.hpp"
#include "random_scene.hpp"
#include "scene/device_light.hpp"
#include "shared/frame.h"
#include "support/catch.hpp"
#include "support/skip.hpp"

using namespace lichtraum;
using namespace lichtraum::test;

namespace {

/// A small picture of every kind of shape, with mirrors, glass, an instance and two lights.
struct SmallPicture {
  SceneArrays scene;
  std::vector<device::FrameParameters> frame = std::vector<device::FrameParameters>(1);
  std::vector<float> film;

  explicit SmallPicture(device::uint sample_count) {
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
    f.width = interpreted ? 10 : 20;
    f.height = interpreted ? 7 : 14;
    f.camera.corner = {-0.5f, 0.35f, -1, 0};
    f.camera.step_x = {1.f / float(f.width), 0, 0, 0};
    f.camera.step_y = {0, -0.7f / float(f.height), 0, 0};
    f.ambient = {0.3f, 0.3f, 0.3f, 0};
    f.background = {0.1f, 0.1f, 0.2f, 0};
    f.sampling = SAMPLING_SEEDED;
    f.sample_count = sample_count;
    f.seed_low = 7;
    f.max_depth = interpreted ? 2 : 5;
    f.tone_map = TONE_MAP_REINHARD;
    f.transfer = TRANSFER_SRGB;
    film.assign(std::size_t(f.width * f.height * 3), -1.f);
  }

  device::uint width() const { return frame[0].width; }
  device::uint height() const { return frame[0].height; }

  std::vector<device::WorkItemRays> render(ProbeProgram const& program, device::Tile const& tile) {
    std::vector<device::WorkItemRays> rays(tile.width * tile.height);
    program.run("render_tile", tile.width, scene.arguments({in(frame), value(tile), updated(film), out(rays)}),
                tile.height, 8, 8);
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
  for (float c : whole.film) {
    if (!(c >= 0 && c < 1)) FAIL("not a tone-mapped value: " << c);
  }

  SmallPicture cut(4);
  for (auto const& [first, count] : {std::pair{0u, 1u}, {1u, 2u}, {3u, 1u}}) {
    device::uint const right = cut.width() - 3, below = cut.height() - 2;
    cut.render(program, {0, 0, 3, cut.height(), first, count, {}});
    cut.render(program, {3, 0, right, 2, first, count, {}});
    cut.render(program, {3, 2, right, below, first, count, {}});
  }
  CHECK(cut.film == whole.film);
}

TEST_CASE("Only the tile's pixels are written", "[kernel]") {
  NEEDS_OPENCL_DEVICE();
  SmallPicture picture(1);
  picture.render(ProbeProgram("render.cl"), {3, 4, 5, 2, 0, 1, {}});
  std::size_t wrong = 0;
  for (std::size_t i = 0; i < picture.film.size(); ++i) {
    std::size_t const x = i / 3 % picture.width(), y = i / 3 / picture.width();
    bool const inside = x >= 3 && x < 8 && y >= 4 && y < 6;
    wrong += inside != (picture.film[i] != -1.f);
  }
  CHECK(wrong == 0);
}

TEST_CASE("A program for first surfaces writes what is asked for, whatever the samples", "[kernel]") {
  NEEDS_OPENCL_DEVICE();
  ProbeProgram const program("render.cl", "-D FIRST_SURFACE");
  auto const rendered = [&](device::uint aov) {
    SmallPicture picture(1);
    picture.frame[0].aov = aov;
    picture.frame[0].tone_map = TONE_MAP_NONE;
    picture.frame[0].transfer = TRANSFER_LINEAR;
    auto const rays = picture.render(program, {0, 0, picture.width(), picture.height(), 0, 1, {}});
    for (device::WorkItemRays const& counts : rays) CHECK((counts.shadow == 0 && counts.secondary == 0));
    return picture;
  };
  SmallPicture const depth = rendered(AOV_DEPTH), normal = rendered(AOV_NORMAL), object = rendered(AOV_OBJECT_ID);
  std::size_t hits = 0;
  std::set<float> instances;
  for (std::size_t i = 0; i < depth.film.size(); i += 3) {
    INFO("pixel " << i / 3);
    bool const is_hit = std::isfinite(depth.film[i]);
    CHECK((depth.film[i + 1] == depth.film[i] && depth.film[i + 2] == depth.film[i]));
    CHECK(is_hit == (object.film[i + 2] != -1.f));
    float const length = std::hypot(normal.film[i], normal.film[i + 1], normal.film[i + 2]);
    CHECK(length == Approx(is_hit ? 1 : 0).margin(1e-4));
    if (!is_hit) continue;
    ++hits;
    CHECK((depth.film[i] > 1 && depth.film[i] < 20));
    // The world's own shapes have all bits of the instance's number, the others one of the two instances'.
    bool const is_in_world = object.film[i + 1] == float(0xffffff) && object.film[i + 2] == float(0xff00);
    CHECK((is_in_world || (object.film[i + 1] < 2 && object.film[i + 2] == 0)));
    instances.insert(object.film[i + 1]);
  }
  CHECK((hits > 0 && 3 * hits < depth.film.size()));
  CHECK(instances.size() == 3);
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
  CHECK(enough.film == plenty.film);
}
