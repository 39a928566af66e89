#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "scene/flatten.hpp"
#include "support/catch.hpp"
#include "support/esdf.hpp"
#include "support/picture_check.hpp"
#include "support/skip.hpp"
#include "support/temporary_folder.hpp"

using namespace lichtraum;
using namespace lichtraum::test;

// A model that a scene includes has a hierarchy of its own when it is large: no picture may show that.

namespace {

/// A torus around z of 2 * 72 * 36 triangles, with normals.
std::string torus_obj() {
  constexpr int around = 72, across = 36;
  std::string text;
  for (int i = 0; i < around; ++i) {
    for (int j = 0; j < across; ++j) {
      double const u = 2 * std::numbers::pi * i / around, v = 2 * std::numbers::pi * j / across;
      Vec3 const normal(std::cos(v) * std::cos(u), std::cos(v) * std::sin(u), std::sin(v));
      Vec3 const position = Vec3(std::cos(u), std::sin(u), 0) + 0.4 * normal;
      text +=
          fmt::format("v {} {} {}\nvn {} {} {}\n", position.x, position.y, position.z, normal.x, normal.y, normal.z);
    }
  }
  for (int i = 0; i < around; ++i) {
    for (int j = 0; j < across; ++j) {
      auto const corner = [](int m, int n) { return 1 + (m % around) * across + n % across; };
      text += fmt::format("f {0}//{0} {1}//{1} {2}//{2} {3}//{3}\n", corner(i, j), corner(i + 1, j),
                          corner(i + 1, j + 1), corner(i, j + 1));
    }
  }
  return text;
}

constexpr char const* scene_text =
    "define material red    0.4 0.1 0.1  0.8 0.2 0.1  0.5 0.5 0.5  30\n"
    "define material white  0.4 0.4 0.4  0.8 0.8 0.8  0 0 0  1\n"
    "define material mirror 0.1 0.1 0.1  0.1 0.1 0.1  0.8 0.8 0.8  100 reflect=0.8\n"
    "define light ambient sky 0.3 0.3 0.3\n"
    "define light diffuse key -4 6 8  0.7 0.6 0.5\n"
    "define shape mesh torus torus.obj red\n"
    "transform torus scale 1.2 0.8 -1\ntransform torus rotate 50 1 0.5 0\ntransform torus translate -0.3 0.4 0\n"
    "define shape sphere ball 0.6 0.3 0.8 0.4 mirror\n"
    "define shape box wall -20 -20 -3 20 20 -1.5 white\n"
    "define camera eye 45\ntransform eye translate 0 0 5\n";

}  // namespace

TEST_CASE("a large model that a scene includes looks as the reference tracer sees it", "[image]") {
  REQUIRE_OPENCL_DEVICE();
  TemporaryFolder const folder;
  folder.write("torus.obj", torus_obj());
  EsdfScript const script = EsdfScript::from_file(folder.write("scene.sdf", scene_text));
  Scene const& scene = script.scene();
  FlatScene const flat = flatten(scene.roots());
  REQUIRE(flat.instances.size() == 1);
  CHECK(flat.objects[1].triangles.size() == 2 * 72 * 36);
  CHECK(flat.objects[0].primitive_count() == 2);

  RenderRequest request = whole_picture(scene.cameras.front(), {96, 72});
  check_layouts(scene, request, "included model");
  request.planes = {FilmPlane::object};
  Film const expected_ids = film_on(reference_device(), scene, request);
  for (DeviceInfo const& device : opencl_devices()) {
    for (auto const& [name, traversal] : layouts_of(device)) {
      INFO("device " << device.index << ", " << name);
      Film const ids = film_on(device, scene, request, traversal);
      auto const actual = ids.numbers(FilmPlane::object), wanted = expected_ids.numbers(FilmPlane::object);
      std::size_t differing = 0;
      for (std::size_t i = 0; i < wanted.size(); ++i) differing += actual[i] != wanted[i];
      CHECK(double(differing) <= differing_share * 96 * 72);
    }
  }
}
