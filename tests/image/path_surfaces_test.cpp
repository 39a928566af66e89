/// What integrators, most of all paths, do where surfaces are not what they seem: smooth by their normals only, or
/// there in part.

#include <fmt/format.h>

#include <glm/trigonometric.hpp>

#include <cmath>

#include "support/catch.hpp"
#include "support/esdf.hpp"
#include "support/path_pictures.hpp"
#include "support/pbr.hpp"
#include "support/picture_check.hpp"
#include "support/skip.hpp"

using namespace lichtraum;
using namespace lichtraum::test;

namespace {

constexpr double pi = 3.14159265358979;

/// An octahedron that its normals make a ball.
std::shared_ptr<MeshGeometry const> rough_ball() {
  auto geometry = std::make_shared<MeshGeometry>();
  geometry->positions = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
  geometry->normals = geometry->positions;
  geometry->indices = {0, 2, 4, 2, 1, 4, 1, 3, 4, 3, 0, 4, 2, 0, 5, 1, 2, 5, 3, 1, 5, 0, 3, 5};
  return geometry;
}

/// A ball of twice as many columns of triangles as rows, with the ball's normals.
std::shared_ptr<MeshGeometry const> facets_of_ball(std::uint32_t rows) {
  auto geometry = std::make_shared<MeshGeometry>();
  std::uint32_t const columns = 2 * rows;
  for (std::uint32_t row = 0; row <= rows; ++row) {
    for (std::uint32_t column = 0; column <= columns; ++column) {
      double const theta = pi * row / rows, phi = 2 * pi * column / columns;
      geometry->positions.push_back(
          {float(std::sin(theta) * std::cos(phi)), float(std::cos(theta)), float(-std::sin(theta) * std::sin(phi))});
    }
  }
  geometry->normals = geometry->positions;
  for (std::uint32_t row = 0; row < rows; ++row) {
    for (std::uint32_t column = 0; column < columns; ++column) {
      std::uint32_t const a = row * (columns + 1) + column, b = a + columns + 1;
      for (std::uint32_t const i : {a, b, a + 1, a + 1, b, b + 1}) geometry->indices.push_back(i);
    }
  }
  return geometry;
}

/// A matt square around the origin that faces z, with a normal map whose only texel turns it 45 degrees towards x, by
/// more or less than that for another scale.
std::shared_ptr<Mesh> slanting_square(double map_scale, bool has_normals) {
  MeshGeometry square;
  square.positions = {{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}};
  if (has_normals) square.normals.assign(4, {0, 0, 1});
  square.texcoords = {{{0, 1}, {1, 1}, {1, 0}, {0, 0}}};
  square.indices = {0, 1, 2, 0, 2, 3};
  PbrModel model = pbr(Rgb(0.8), 0, 1);
  model.specular = 0;
  auto const image = std::make_shared<TextureImage const>(TextureImage{"slant", 1, 1, {218, 128, 218, 255}});
  model.normal_texture.texture = std::make_shared<Texture const>(Texture{image});
  model.normal_scale = map_scale;
  return std::make_shared<Mesh>("square", std::make_shared<MeshGeometry>(square),
                                std::make_shared<Material>("m", model));
}

/// What a shape at the origin shows on +z of a lamp that is far away.
double brightness_of(std::shared_ptr<Shape> const& shape, Vec3 const& to_lamp, Integrator integrator,
                     bool by_reference) {
  Scene scene =
      scene_of(fmt::format("define light diffuse lamp {} {} {}  1 1 1\ndefine camera eye 2\n"
                           "transform eye translate 0 0 5\n",
                           1e4 * to_lamp.x, 1e4 * to_lamp.y, 1e4 * to_lamp.z));
  scene.shapes.insert(shape);
  RenderRequest request = path_request(scene, {4, 4}, 4, 1);
  request.integrator = integrator;
  Image const picture = by_reference ? render_reference(scene, request) : trace(scene, request);
  return double(picture.pixel(1, 1)[0]);
}

}  // namespace

TEST_CASE("a smooth ball of few triangles is lit by lamps as a round one", "[image][path]") {
  REQUIRE_OPENCL_DEVICE();
  constexpr Resolution size{96, 96};
  // Lit from the side and a little from behind: the border of the shadow lies across what is seen.
  std::string const empty =
      "define material m 0 0 0  0.8 0.8 0.8  0 0 0 1\ndefine light diffuse lamp 300 40 -60  1 1 1\n"
      "define camera eye 22\ntransform eye translate 0 0 6\n";
  auto const material = *scene_of(empty).materials.find("m");
  Vec3 const stretch = GENERATE(Vec3(1), Vec3(-1.1, 0.7, 0.9));
  bool const is_instance = GENERATE(false, true);
  Integrator const integrator = GENERATE(Integrator::path, Integrator::whitted);
  CAPTURE(stretch.x, is_instance, int(integrator));
  auto const draw = [&](std::shared_ptr<Shape> const& ball, RenderRequest request, bool by_reference) {
    ball->scale(stretch);
    auto const root = std::make_shared<Composite>("root", Composite::Children{ball});
    if (is_instance) {
      auto const copy = std::make_shared<Composite>("copy", Composite::Children{ball});
      copy->translate({0, 0, -100});
      root->add(copy);
    }
    Scene scene = scene_of(empty);
    scene.shapes.insert(root);
    return by_reference ? render_reference(scene, request) : trace(scene, request);
  };
  RenderRequest request = path_request(scene_of(empty), size, 16, 1);
  request.integrator = integrator;
  Image const round = draw(std::make_shared<Sphere>("ball", Vec3(0), 1, material), request, false);
  CHECK(round.pixel(80, 48)[0] > 0.3f);
  CHECK(round.pixel(40, 48)[0] == 0);
  for (bool const by_reference : {false, true}) {
    CAPTURE(by_reference);
    auto const facets = std::make_shared<Mesh>("ball", facets_of_ball(8), material);
    Image const actual = draw(facets, request, by_reference);
    int differing = 0;
    for (int y = 0; y < size.height; ++y) {
      for (int x = 0; x < size.width; ++x) {
        double const from_middle = std::hypot((x - 47.5) / stretch.x, (y - 47.5) / stretch.y);
        if (from_middle > 36) continue;  // the outline has corners
        differing += std::abs(actual.pixel(x, y)[0] - round.pixel(x, y)[0]) > 0.05 ? 1 : 0;
      }
    }
    CHECK(differing <= 4);
  }
}

TEST_CASE("bumps that face a lamp fade out towards the horizon of the surface that they are on", "[image][path]") {
  REQUIRE_OPENCL_DEVICE();
  Integrator const integrator = GENERATE(Integrator::path, Integrator::whitted);
  bool const by_reference = GENERATE(false, true);
  bool const has_normals = GENERATE(false, true);
  auto const brightness = [&](double lamp_degrees, double map_scale) {
    double const angle = glm::radians(lamp_degrees);
    return brightness_of(slanting_square(map_scale, has_normals), Vec3(std::cos(angle), 0, std::sin(angle)), integrator,
                         by_reference);
  };
  double const unit = brightness(90, 0);
  REQUIRE(unit > 0.5);
  for (double const degrees : {-10., -1., 1., 5., 15., 30., 44., 46., 80., 130.}) {
    CAPTURE(int(integrator), by_reference, has_normals, degrees);
    double const angle = glm::radians(degrees), bumpy = std::cos(angle - pi / 4);
    double const g = std::clamp(std::sin(angle) / (bumpy * std::cos(pi / 4)), 0.0, 1.0);
    CHECK(brightness(degrees, 1) / unit == Approx(bumpy * (g + g * g - g * g * g)).margin(0.004));
  }
}

TEST_CASE("paths: bumps that face away are turned to the viewer, half as much as the surface", "[image][path]") {
  REQUIRE_OPENCL_DEVICE();
  bool const by_reference = GENERATE(false, true);
  auto const brightness = [&](double degrees, double map_scale) {
    auto const square = slanting_square(map_scale, true);
    square->rotate(degrees, {0, 1, 0});
    double const angle = glm::radians(degrees);
    return brightness_of(square, Vec3(std::sin(angle), 0, std::cos(angle)), Integrator::path, by_reference);
  };
  double const unit = brightness(0, 0);
  for (double const degrees : {0., 15., 18., 19., 25., 44., 46., 70., 85.}) {
    CAPTURE(by_reference, degrees);
    double const angle = glm::radians(degrees);
    Vec3 const surface(std::sin(angle), 0, std::cos(angle));  // the viewer is at +z
    Vec3 normal(std::sin(angle + pi / 4), 0, std::cos(angle + pi / 4));
    if (normal.z < surface.z / 2) normal = {std::sqrt(1 - surface.z * surface.z / 4), 0, surface.z / 2};
    CHECK(brightness(degrees, 1) / unit == Approx(glm::dot(normal, surface)).margin(0.006));
  }
}

TEST_CASE("paths: mirrors and glass of few triangles lose no light to their smooth normals", "[image][path]") {
  REQUIRE_OPENCL_DEVICE();
  PbrModel model = pbr(Rgb(1), 0, 0);
  double lost = 0.005;
  SECTION("metal") { model.metallic = 1; }
  SECTION("glass") {
    model.transmission = model.thickness = 1;
    lost = 0.02;  // some light is mirrored within more often than paths are long
  }
  Scene scene = scene_of("define camera eye 30\ntransform eye translate 0 0 4\n");
  auto const material = std::make_shared<Material>("m", model);
  auto const ball = std::make_shared<Mesh>("ball", rough_ball(), material);
  ball->rotate(25, {1, 2, 0.5});
  scene.materials.insert(material);
  scene.shapes.insert(ball);
  scene.environment = EnvironmentLight{"made here", uniform_environment(1, 1, 1), 0, 1};
  RenderRequest request = path_request(scene, {32, 32}, 64, 64);
  request.background = Background::environment();
  CHECK(mean_of(trace(scene, request)).value == Approx(1).margin(lost));
}

TEST_CASE("paths: what blends and is no triangle lets its share of light through each time", "[image][path]") {
  REQUIRE_OPENCL_DEVICE();
  // Below a ball, in whose shadow the floor lies.
  Scene scene = scene_of(R"(
define material grey 0 0 0  0.5 0.5 0.5  0 0 0 1
define material m 0 0 0  0 0 0  0 0 0 1
define shape plane floor 0 -1 0  0 1 0 grey
define shape sphere ball 0 1 0 0.5 m
define light diffuse sun 0 1e6 0  0.8 0.8 0.8
define camera eye 10
transform eye rotate -90 1 0 0
)");
  for (auto const& [alpha, share] : {std::pair(0.5, 0.25), std::pair(0.25, 0.5625), std::pair(1.0, 0.0)}) {
    PbrModel model = pbr(Rgb(1), 0, 1);
    model.alpha = alpha;
    model.alpha_mode = AlphaMode::blend;
    **scene.materials.find("m") = Material("m", model);
    Image const picture = trace(scene, path_request(scene, {8, 8}, 1, 1));
    CHECK(picture.pixel(4, 4)[0] == Approx(0.5 * 0.8 * share).epsilon(1e-4).margin(1e-6));
  }
}

TEST_CASE("paths: what lies behind a hundred sheets is seen", "[image][path]") {
  REQUIRE_OPENCL_DEVICE();
  std::string text = "define material m 0 0 0  0 0 0  0 0 0 1\ndefine camera eye 20\n";
  for (int i = 0; i < 100; ++i) {
    text += fmt::format("define shape triangle t{0} -9 -9 -{1}  9 -9 -{1}  0 9 -{1} m\n", i, 2 + 0.01 * i);
  }
  Scene scene = scene_of(text + "define background 1 1 1\n");
  PbrModel sheet = pbr(Rgb(0), 0, 1);
  sheet.alpha = 0.001;
  sheet.alpha_mode = AlphaMode::blend;
  sheet.specular = 0;
  sheet.double_sided = true;
  **scene.materials.find("m") = Material("m", sheet);
  CHECK(mean_of(trace(scene, path_request(scene, {16, 16}, 64, 4))).value == Approx(std::pow(0.999, 100)).margin(0.01));
}
