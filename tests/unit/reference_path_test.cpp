/// The reference tracer's paths, where analysis says what they must show; tests/image/path_oracle_test.cpp compares
/// them with the kernels'.

#include <cmath>
#include <memory>
#include <numbers>

#include "lichtraum/error.hpp"
#include "reference/environment.hpp"
#include "reference/renderer.hpp"
#include "support/catch.hpp"
#include "support/pbr.hpp"

using namespace lichtraum;
using test::pbr;

namespace {

RenderRequest path_request(int samples, int max_depth) {
  RenderRequest request;
  request.camera = Camera("eye", 18);
  request.resolution = {8, 8};
  request.region = {0, 0, 8, 8};
  request.integrator = Integrator::path;
  request.sampling = {Sampling::Pattern::seeded, samples};
  request.max_depth = max_depth;
  return request;
}

EnvironmentLight white_environment() { return {"1 1 1", uniform_environment(1, 1, 1)}; }

/// A ball that fills the picture.
Scene ball(Material::Model const& model) {
  Scene scene;
  scene.shapes.insert(
      std::make_shared<Sphere>("ball", Vec3(0, 0, -5), 1.5, std::make_shared<Material>("stuff", model)));
  return scene;
}

Film traced(Scene const& scene, RenderRequest const& request, unsigned threads = 2) {
  DeviceInfo device = reference_device();
  device.compute_units = threads;
  auto const renderer = make_reference_renderer(device);
  renderer->set_scene(scene);
  Film film;
  CHECK(renderer->render(request, film).statistics.rays.not_finite == 0);
  return film;
}

double mean_radiance(Scene const& scene, RenderRequest const& request) {
  Film const film = traced(scene, request);
  auto const values = film.values(FilmPlane::radiance);
  double sum = 0;
  for (float const value : values) sum += value;
  return sum / double(values.size());
}

}  // namespace

TEST_CASE("reference paths: a closed body that shines within shows the sum of all bounces", "[reference][path]") {
  Scene scene;
  scene.shapes.insert(std::make_shared<Sphere>(
      "hollow", Vec3(0, 0, 0), 2, std::make_shared<Material>("m", PhongModel{.kd = Rgb(0.5), .emission = Rgb(0.3)})));
  CHECK(mean_radiance(scene, path_request(16, 0)) == Approx(0.3));
  CHECK(mean_radiance(scene, path_request(256, 2)) == Approx(0.3 * 1.75).epsilon(0.01));
  CHECK(mean_radiance(scene, path_request(256, 30)) == Approx(0.6).epsilon(0.015));
}

TEST_CASE("reference paths: materials that keep all light show white in white", "[reference][path]") {
  PbrModel glass = pbr(Rgb(1), 0, 0);
  glass.transmission = 1;
  glass.thickness = 1;
  PbrModel rough_glass = glass;
  rough_glass.roughness = 1;
  rough_glass.ior = 2;
  std::tuple<char const*, Material::Model, double> const cases[] = {
      {"matt", PhongModel{.kd = Rgb(1)}, 0.005},
      {"mirror and glass", PhongModel{.kd = Rgb(0), .reflect = 0.3, .transmit = 0.7, .ior = 1.5}, 0.01},
      {"rough metal", pbr(Rgb(1), 1, 1), 0.01},
      {"smooth metal", pbr(Rgb(1), 1, 0), 0.005},
      {"dielectric", pbr(Rgb(1), 0, 0.6), 0.01},
      {"smooth glass", glass, 0.01},
      {"rough glass", rough_glass, 0.05},
  };
  for (auto const& [name, model, tolerance] : cases) {
    INFO(name);
    Scene scene = ball(model);
    scene.environment = white_environment();
    CHECK(mean_radiance(scene, path_request(512, 16)) == Approx(1).margin(tolerance));
  }
}

TEST_CASE("reference paths: lights without a size light matt surfaces as Whitted's do", "[reference][path]") {
  Scene scene = ball(PhongModel{.kd = {0.8, 0.4, 0.2}});
  scene.lights.insert(Light::point("left", {-5, 5, 0}, Rgb(0.7)));
  scene.lights.insert(Light::directional("sun", {-1, -1, -1}, Rgb(0.5)));
  RenderRequest request = path_request(4, 1);
  Film const paths = traced(scene, request);
  request.integrator = Integrator::whitted;
  Film const whitted = traced(scene, request);
  auto const a = paths.values(FilmPlane::radiance), b = whitted.values(FilmPlane::radiance);
  for (std::size_t i = 0; i < a.size(); ++i) CHECK(a[i] == Approx(b[i]).margin(1e-6));
}

TEST_CASE("reference paths: of a lamp with a radius, a floor sees what an edge leaves of a disc", "[reference][path]") {
  auto const matt = std::make_shared<Material>("matt", PhongModel{.kd = Rgb(1)});
  auto const black = std::make_shared<Material>("black", PhongModel{.kd = Rgb(0)});
  RenderRequest request = path_request(400, 1);
  request.camera =
      Camera("eye", 0.001, Transform::look_along({-1, 2, 0}, glm::normalize(Vec3(1, -2, 0)), Vec3(0, 0, 1)));
  auto const lit_share = [&](double edge) {
    Scene scene;
    scene.shapes.insert(std::make_shared<Box>("floor", Vec3(-5, -1, -5), Vec3(5, 0, 5), matt));
    scene.shapes.insert(std::make_shared<Box>("shade", Vec3(edge / 2, 5, -9), Vec3(9, 5.001, 9), black));
    scene.lights.insert(Light("lamp", PointLight{.ld = Rgb(1), .position = {0, 10, 0}, .radius = 1}));
    return mean_radiance(scene, request);
  };
  // The edge is half way up to the lamp, so its shadow on the disc is twice as far from the middle.
  for (double const edge : {-0.8, -0.3, 0.0, 0.5}) {
    double const hidden = (std::acos(edge) - edge * std::sqrt(1 - edge * edge)) / std::numbers::pi;
    CHECK(lit_share(edge) == Approx(1 - hidden).margin(0.01));  // 3 standard deviations, and slanting light
  }
  CHECK(lit_share(1.01) > 0.995);
  CHECK(lit_share(-1.01) == 0);
}

TEST_CASE("reference paths: one thread and several give the same bytes", "[reference][path]") {
  Scene scene = ball(pbr({0.9, 0.5, 0.3}, 0.5, 0.5));
  scene.environment = white_environment();
  RenderRequest const request = path_request(20, 4);
  Film const one = traced(scene, request, 1), three = traced(scene, request, 3);
  auto const a = one.values(FilmPlane::radiance), b = three.values(FilmPlane::radiance);
  CHECK(std::ranges::equal(a, b));
}

TEST_CASE("reference paths: what they do not know is refused, not drawn wrongly", "[reference][path]") {
  auto const check = [](PbrModel const& model, std::string const& word) {
    Scene const scene = ball(model);
    auto const renderer = make_reference_renderer(reference_device());
    renderer->set_scene(scene);
    Film film;
    CHECK_THROWS_WITH(renderer->render(path_request(1, 1), film),
                      contains_text("know no " + word + ", which material 'stuff' has: try another --device"));
    RenderRequest whitted = path_request(1, 1);
    whitted.integrator = Integrator::whitted;
    CHECK_NOTHROW(renderer->render(whitted, film));
  };
  PbrModel model;
  model.sheen_color = Rgb(0.5);
  check(model, "sheen");
  model = {};
  model.anisotropy = 0.5;
  check(model, "anisotropy");
  model = {};
  model.dispersion = 1;
  model.transmission = 1;
  model.thickness = 1;
  check(model, "dispersion");
  model = {};
  model.clearcoat = 1;
  auto const texel = std::make_shared<TextureImage const>(TextureImage{"flat", 1, 1, {128, 128, 255, 255}});
  model.clearcoat_normal_texture.texture = std::make_shared<Texture const>(Texture{texel});
  check(model, "clear coats with normal maps");
  std::swap(model.clearcoat_normal_texture, model.normal_texture);
  check(model, "clear coats with normal maps");
  model = {};
  model.diffuse_transmission = 1;
  check(model, "diffuse transmission");
}

TEST_CASE("reference environment: texels lie where the format says, and the map turns", "[reference][environment]") {
  // One bright texel at u = 5.5 / 8: halfway between +x (u = 0.5) and +z (u = 0.75), at the middle row.
  EnvironmentMap map{8, 3, std::vector<float>(8 * 3 * 3, 0.0f)};
  for (int c = 0; c < 3; ++c) map.radiance[3 * (8 * 1 + 5) + std::size_t(c)] = 2;
  for (int column = 0; column < 8; ++column) map.radiance[3 * std::size_t(column)] = float(column);
  EnvironmentLight light{"made here", std::make_shared<EnvironmentMap const>(map), 0, 0.5};
  double const angle = 2 * 3.141592653589793 * 1.5 / 8;
  CHECK(ReferenceEnvironment(light).radiance({std::cos(angle), 0, std::sin(angle)}).g == Approx(1));
  CHECK(ReferenceEnvironment(light).radiance({-1, 0, 0}).g == Approx(0));
  // At the pole, the mean of the first row: 0.5 * (0 + ... + 7) / 8.
  CHECK(ReferenceEnvironment(light).radiance({0, 1, 0}).r == Approx(0.5 * 3.5));
  // Counter-clockwise seen from above turns +z towards +x: what was at the angle is now 30 degrees before it.
  light.rotation_degrees = 30;
  double const turned = angle - 3.141592653589793 / 6;
  CHECK(ReferenceEnvironment(light).radiance({std::cos(turned), 0, std::sin(turned)}).g == Approx(1));
  // Where +z is up, +y is what -z was, and the pole is there.
  ReferenceEnvironment const lying(light, {0, 0, 3});
  CHECK(lying.radiance({std::cos(turned), -std::sin(turned), 0}).g == Approx(1));
  CHECK(lying.radiance({0, 0, 1}).r == Approx(0.5 * 3.5));
}
