/// What paths do in bodies that light gets into (KHR_materials_volume).

#include <fmt/format.h>

#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "support/catch.hpp"
#include "support/esdf.hpp"
#include "support/path_pictures.hpp"
#include "support/pbr.hpp"
#include "support/picture_check.hpp"
#include "support/skip.hpp"

using namespace lichtraum;
using namespace lichtraum::test;

namespace {

/// Of this index, without reflections.
PbrModel clear_body(double ior) {
  PbrModel body = pbr(Rgb(1), 0, 0);
  body.transmission = body.thickness = 1;
  body.specular = 0;
  body.ior = ior;
  return body;
}

/// A square across z, around the z axis, that faces -z or +z.
std::string square(std::string const& name, double z, bool faces_up, double half, std::string const& material) {
  double const x = faces_up ? half : -half;  // the order of the corners decides
  return fmt::format(
      "define shape triangle {0}a {1} {2} {3}  {4} {2} {3}  {4} {5} {3} {6}\n"
      "define shape triangle {0}b {4} {5} {3}  {1} {5} {3}  {1} {2} {3} {6}\n",
      name, -x, -half, z, x, half, material);
}

double mean_difference(Image const& a, Image const& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.data().size(); ++i) sum += std::abs(double(a.data()[i]) - double(b.data()[i]));
  return sum / double(a.data().size());
}

}  // namespace

TEST_CASE("paths: bodies that overlap, or lie within another, each keep their own light", "[image][path]") {
  REQUIRE_OPENCL_DEVICE();
  // Along the camera's axis, in a body a that lets half of the light through a unit, and b that lets 0.8 through.
  struct Slab {
    double from, to;
    char const* material;
  };
  struct Case {
    char const* name;
    std::vector<Slab> slabs;
    double way_in_a, way_in_b;
  };
  Case const cases[] = {
      // What was entered last counts where both are.
      {"a drink that reaches into its glass", {{0, 1, "b"}, {0.9, 3.1, "a"}, {3, 4, "b"}}, 2.1, 1.9},
      {"amber with two inclusions", {{0, 4, "a"}, {1, 1.2, "b"}, {2.8, 3, "b"}}, 3.6, 0.4},
      {"one body after the other", {{0, 1, "a"}, {1, 2, "b"}, {2.5, 3, "a"}}, 1.5, 1},
  };
  for (Case const& c : cases) {
    std::string text =
        "define material a 0 0 0  0 0 0  0 0 0 1\ndefine material b 0 0 0  0 0 0  0 0 0 1\n"
        "define camera eye 4\ntransform eye translate 0 0 20\n";
    int number = 0;
    for (Slab const& slab : c.slabs) {
      text += fmt::format("define shape box slab{} -5 -5 {}  5 5 {} {}\n", number++, slab.from, slab.to, slab.material);
    }
    Scene scene = scene_of(text);
    PbrModel body = clear_body(1);
    body.attenuation_distance = 1;
    body.attenuation_color = Rgb(0.5);
    **scene.materials.find("a") = Material("a", body);
    body.attenuation_color = Rgb(0.8);
    **scene.materials.find("b") = Material("b", body);
    scene.environment = EnvironmentLight{"made here", uniform_environment(1, 1, 1), 0, 1};
    RenderRequest request = path_request(scene, {16, 16}, 256, 16);
    request.background = Background::environment();
    INFO(c.name);
    double const expected = std::pow(0.5, c.way_in_a) * std::pow(0.8, c.way_in_b);
    CHECK(mean_of(trace(scene, request)).value == Approx(expected).epsilon(0.01));
    RenderRequest fewer = path_request(scene, {8, 8}, 64, 16);
    fewer.background = Background::environment();
    Film film;
    auto const reference = make_renderer(reference_device());
    reference->set_scene(scene);
    reference->render(fewer, film);
    double sum = 0;
    for (float const value : film.values(FilmPlane::radiance)) sum += double(value) / (3 * 8 * 8);
    CHECK(sum == Approx(expected).epsilon(0.05));
  }
}

TEST_CASE("paths: a body within another refracts by the ratio of their indices", "[image][path]") {
  REQUIRE_OPENCL_DEVICE();
  // Before a backdrop that is in the outer body as well, as are all of a path's ways but the first.
  Scene scene = scene_of(R"(
define material around 0 0 0  0 0 0  0 0 0 1
define material ball 0 0 0  0 0 0  0 0 0 1
define material shining 0 0 0  0 0 0  0 0 0 1
define shape box outside -9 -9 -9  9 9 3 around
define shape sphere lens 0 0 0 1 ball
define shape box left -8 -8 -5  -0.2 8 -4 shining
define camera eye 40
transform eye translate 0 0 6
)");
  auto const drawn = [&](double around, double ball, bool by_reference) {
    for (auto const& [name, ior] : {std::pair("around", around), std::pair("ball", ball)}) {
      PbrModel body = clear_body(ior);
      body.attenuation_distance = 1;  // white: a body also of the index 1
      **scene.materials.find(name) = Material(name, body);
    }
    PbrModel shining = pbr(Rgb(0), 0, 1);
    shining.specular = 0;
    shining.emissive = Rgb(around * around);  // see the lamps above
    **scene.materials.find("shining") = Material("shining", shining);
    RenderRequest request = path_request(scene, {24, 24}, 16, 8);
    request.camera = Camera::orthographic("eye", 2.6, Transform::translation({0, 0, 6}));
    return by_reference ? render_reference(scene, request) : trace(scene, request);
  };
  for (bool const by_reference : {false, true}) {
    INFO((by_reference ? "reference" : "device"));
    Image const in_air = drawn(1, 1.25, by_reference), in_water = drawn(1.4, 1.4 * 1.25, by_reference);
    CHECK(mean_difference(in_air, in_water) < 0.02);
    CHECK(mean_difference(in_air, drawn(1, 1.4 * 1.25, by_reference)) > 0.03);  // which a difference would look like
    // What has the index of its surroundings is not seen, nor does it reflect anything.
    Image const same = drawn(1.4, 1.4, by_reference), nothing = drawn(1.0001, 1.0001, by_reference);
    CHECK(mean_difference(same, nothing) < 0.02);
  }
}

TEST_CASE("paths: a body that only scatters light does so in another one as in air", "[image][path]") {
  REQUIRE_OPENCL_DEVICE();
  Scene scene = scene_of(R"(
define material around 0 0 0  0 0 0  0 0 0 1
define material wax 0 0 0  0 0 0  0 0 0 1
define material shining 0 0 0  0 0 0  0 0 0 1
define shape box outside -9 -9 -9  9 9 3 around
define shape sphere ball 0 0 0 1 wax
define shape box panel -8 -8 -2  8 8 -1.2 shining
define camera eye 40
)");
  auto const brightness = [&](double around) {
    PbrModel body = clear_body(around);
    body.attenuation_distance = 1;
    body.attenuation_color = Rgb(0.3);  // little is left of what its own faces mirror
    **scene.materials.find("around") = Material("around", body);
    PbrModel wax = pbr(Rgb(1), 0, 0.5);
    wax.diffuse_transmission = wax.thickness = 1;
    wax.attenuation_distance = 2;
    wax.attenuation_color = Rgb(0.7);
    **scene.materials.find("wax") = Material("wax", wax);
    PbrModel shining = pbr(Rgb(0), 0, 1);
    shining.specular = 0;
    shining.emissive = Rgb(around * around);
    **scene.materials.find("shining") = Material("shining", shining);
    RenderRequest request = path_request(scene, {16, 16}, 256, 12);
    request.camera = Camera::orthographic("eye", 1.4, Transform::translation({0, 0, 6}));
    return mean_of(trace(scene, request)).value;
  };
  CHECK(brightness(1.4) == Approx(brightness(1)).epsilon(0.01));
}

TEST_CASE("paths: a hollow body may have another material inside", "[image][path]") {
  REQUIRE_OPENCL_DEVICE();
  Scene scene = scene_of(
      "define material a 0 0 0  0 0 0  0 0 0 1\ndefine material b 0 0 0  0 0 0  0 0 0 1\n"
      "define shape box outside -5 -5 0  5 5 4 a\n" +
      square("upper", 3, false, 4.5, "b") + square("lower", 1, true, 4.5, "b") +
      "define camera eye 4\ntransform eye translate 0 0 20\n");
  PbrModel body = clear_body(1);
  body.attenuation_distance = 1;
  body.attenuation_color = Rgb(0.5);
  **scene.materials.find("a") = Material("a", body);
  body.attenuation_color = Rgb(0.8);
  **scene.materials.find("b") = Material("b", body);
  scene.environment = EnvironmentLight{"made here", uniform_environment(1, 1, 1), 0, 1};
  RenderRequest request = path_request(scene, {8, 8}, 16, 16);
  request.background = Background::environment();
  // From 4 to 3 in a, as it is entered there, and from 1 to 0 in b.
  double const expected = 0.5 * 0.8;
  CHECK(mean_of(trace(scene, request)).value == Approx(expected).epsilon(0.01));
  CHECK(mean_of(render_reference(scene, request)).value == Approx(expected).epsilon(0.01));
}

TEST_CASE("paths: a light without a size shines out of hollow glass", "[image][path]") {
  REQUIRE_OPENCL_DEVICE();
  std::string const floor = R"(
define material matt 0 0 0  0.8 0.8 0.8  0 0 0 1
define material glass 0 0 0  0 0 0  0 0 0 1
define shape box floor -9 -9 -3  9 9 -2 matt
define camera eye 60
transform eye translate 0 0 -1.8
)";
  std::string const bulb = "define shape box outside -3 -3 -1  3 3 1 glass\n" +
                           square("upper", 0.8, false, 2.8, "glass") + square("lower", -0.8, true, 2.8, "glass");
  // The camera is between the glass and the floor that it lights.
  auto const lit = [](Scene scene) {
    scene.lights.insert(Light::falling_off("lamp", Vec3(0), Rgb(2)));
    return mean_of(trace(scene, path_request(scene, {8, 8}, 512, 4))).value;
  };
  Scene behind_glass = scene_of(floor + bulb);
  **behind_glass.materials.find("glass") = Material("glass", clear_body(1.5));
  double const in_the_open = lit(scene_of(floor));
  // Caustics of such lights are blurred, and some of the light goes astray.
  CHECK(lit(std::move(behind_glass)) == Approx(in_the_open).epsilon(0.25));
}

TEST_CASE("paths: a body that lets light through to all sides absorbs it on its way", "[image][path]") {
  REQUIRE_OPENCL_DEVICE();
  Scene scene = scene_of(
      "define material wax 0 0 0  0 0 0  0 0 0 1\ndefine shape sphere ball 0 0 0 1 wax\n"
      "define camera eye 6\ntransform eye translate 0 0 10\n");
  PbrModel wax = pbr(Rgb(1), 0, 1);
  wax.diffuse_transmission = wax.thickness = 1;
  wax.specular = 0;
  wax.attenuation_distance = 0.5;
  wax.attenuation_color = {0.1, 0.5, 0.9};
  **scene.materials.find("wax") = Material("wax", wax);
  scene.environment = EnvironmentLight{"made here", uniform_environment(1, 1, 1), 0, 1};
  Image const image = trace(scene, path_request(scene, {16, 16}, 256, 8));
  for (int c = 0; c < 3; ++c) {
    double sum = 0;
    for (int y = 0; y < 16; ++y) {
      for (int x = 0; x < 16; ++x) sum += double(image.pixel(x, y)[c]) / 256;
    }
    // Of the ways through a ball, 2 cos long, with the density 2 cos of Lambert's law.
    double const k = -2 * std::log(wax.attenuation_color[c]) / wax.attenuation_distance;
    CHECK(sum == Approx(2 * (1 - std::exp(-k) * (1 + k)) / (k * k)).epsilon(0.01));
  }
}

TEST_CASE("paths: a lamp gives no more light in glass than in the open", "[image][path]") {
  REQUIRE_OPENCL_DEVICE();
  // In the middle of a room that is a ball.
  Scene scene = scene_of(R"(
define material wall 0 0 0  0.5 0.5 0.5  0 0 0 1
define material shining 0 0 0  0 0 0  0 0 0 1
define material glass 0 0 0  0 0 0  0 0 0 1
define shape sphere room 0 0 0 2 wall
define shape sphere body 0 0 0 0.6 glass
define shape sphere lamp 0 0 0 0.3 shining
define camera eye 30
transform eye rotate 180 0 1 0
transform eye translate 0 0 1
)");
  PbrModel shining = pbr(Rgb(0), 0, 1);
  shining.specular = 0;
  shining.emissive = Rgb(4);
  **scene.materials.find("shining") = Material("shining", shining);
  for (double const ior : {1.2, 1.5, 1.9}) {
    **scene.materials.find("glass") = Material("glass", clear_body(ior));
    INFO("index " << ior);
    RenderRequest const request = path_request(scene, {32, 32}, 256, 2);
    double const lit_by_the_lamp = 0.5 * 4 * (0.3 * 0.3) / (2 * 2);
    // One path in 12 to 36 meets the lamp: 1 % is the standard deviation.
    CHECK(mean_of(trace(scene, request)).value == Approx(lit_by_the_lamp).epsilon(0.04));
  }
}

TEST_CASE("paths: a light without a size gives no more light in glass than in the open", "[image][path]") {
  REQUIRE_OPENCL_DEVICE();
  Scene scene = scene_of(R"(
define material matt 0 0 0  0.8 0.8 0.8  0 0 0 1
define material glass 0 0 0  0 0 0  0 0 0 1
define shape box body -2 -2 -2  2 2 0 glass
define shape box plate -1 -1 -1.5  1 1 -1 matt
define light diffuse lamp 0.5 0 -0.5  0.5 0.5 0.5
define camera eye 1
transform eye translate 0 0 5
)");
  for (double const ior : {1.0, 1.5, 2.0}) {
    PbrModel body = clear_body(ior);
    body.attenuation_distance = 1;
    body.attenuation_color = Rgb(0.7);
    **scene.materials.find("glass") = Material("glass", body);
    INFO("index " << ior);
    // At 45 degrees, and what is left after the ways to the plate and to the front, where rays spread.
    double const expected = 0.8 * 0.5 * std::sqrt(0.5) * std::pow(0.7, std::sqrt(0.5) + 1) / (ior * ior);
    RenderRequest const request = path_request(scene, {4, 4}, 4, 2);
    CHECK(mean_of(trace(scene, request)).value == Approx(expected).epsilon(1e-3));
    CHECK(mean_of(render_reference(scene, request)).value == Approx(expected).epsilon(1e-3));
  }
}
