/// The ground that scenes stand on, where analysis says what it must show. Whether it shows the right shades of all
/// else is for path_oracle_test.cpp.

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include <cmath>

#include "lichtraum/error.hpp"
#include "support/catch.hpp"
#include "support/esdf.hpp"
#include "support/picture_check.hpp"
#include "support/skip.hpp"

using namespace lichtraum;
using namespace lichtraum::test;

namespace {

constexpr Resolution size{48, 32};
Rgb const background(0.5, 0.25, 0.125);

RenderRequest ground_request(Scene const& scene, Ground ground, int samples = 1) {
  RenderRequest request = whole_picture(scene.cameras.front(), size);
  request.integrator = Integrator::path;
  request.sampling = {samples == 1 ? Sampling::Pattern::grid : Sampling::Pattern::seeded, samples};
  request.max_depth = 4;
  request.ground = ground;
  request.background = background;
  return request;
}

std::string const camera =
    "define material grey 0 0 0  0.5 0.5 0.5  0 0 0 1\ndefine camera eye 50\ntransform eye rotate -15 1 0 0\ntransform "
    "eye translate 0 1.6 5\n";

/// Whether a ray meets the unit ball about the origin, and how near its line comes to the ball's surface.
struct BallView {
  bool is_hit;
  double margin;
};
BallView view_of_ball(Ray const& ray, double t_max) {
  double const t = glm::clamp(-glm::dot(ray.origin, ray.direction), 0.0, t_max);
  double const distance = glm::length(ray.origin + t * ray.direction);
  return {distance < 1, std::abs(distance - 1)};
}

}  // namespace

TEST_CASE("ground: a lamp's shadow has its shape, and all else is the background", "[image][path][ground]") {
  REQUIRE_OPENCL_DEVICE();
  Scene const scene = scene_of(
      "define material black 0 0 0  0 0 0  0 0 0 1\ndefine shape sphere ball 0 0 0 1 black\n"
      "define light lamp -4 6 2  1 1 1  3\n" +
      camera);
  Vec3 const lamp(-4, 6, 2);
  bool const is_transparent = GENERATE(false, true);
  RenderRequest request = ground_request(scene, Ground::matt);
  if (is_transparent) request.planes.add(FilmPlane::alpha);
  for (DeviceInfo const& device : {reference_device(), opencl_devices().front()}) {
    Film const film = film_on(device, scene, request);
    auto const radiance = film.values(FilmPlane::radiance);
    auto const alpha = is_transparent ? film.values(FilmPlane::alpha) : std::vector<float>();
    int shadows = 0, open = 0;
    for (int y = 0; y < size.height; ++y) {
      for (int x = 0; x < size.width; ++x) {
        Ray ray = request.camera.generate_ray(x + 0.5, y + 0.5, size);
        ray.direction = glm::normalize(ray.direction);
        double const t = ray.direction.y < 0 ? (-1 - ray.origin.y) / ray.direction.y : 1e9;
        auto const [is_ball, margin] = view_of_ball(ray, t);
        if (is_ball || margin < 0.05) continue;
        Vec3 const point = ray.origin + t * ray.direction;
        auto const [is_shadow, edge] = view_of_ball({point, glm::normalize(lamp - point)}, 1e9);
        if (edge < 0.02) continue;
        INFO(device.name << ", x " << x << ", y " << y);
        ++(is_shadow && t < 1e9 ? shadows : open);
        double const darkness = is_shadow && t < 1e9 ? 1 : 0;
        std::size_t const i = std::size_t(y * size.width + x);
        for (int c = 0; c < 3; ++c) {
          double const shown = is_transparent ? 0 : (1 - darkness) * background[c];
          CHECK(radiance[3 * i + std::size_t(c)] == Approx(shown).margin(1e-6));
        }
        if (is_transparent) CHECK(alpha[i] == Approx(darkness).margin(1e-6));
      }
    }
    CHECK(shadows > 60);
    CHECK(open > 600);
  }
}

TEST_CASE("ground: nothing is darker than where a large lamp is hidden, on a glossy one as well",
          "[image][path][ground]") {
  REQUIRE_OPENCL_DEVICE();
  // The ball hides the lamp, which is larger, from all of the ground that is looked at, between the ball and that.
  Scene const scene = scene_of(
      "define material black 0 0 0  0 0 0  0 0 0 1\ndefine shape sphere ball 0 0 0 1 black\n"
      "define shape sphere low 50 -1.5 0 0.05 black\ndefine light lamp 0 2 0  1 1 1  3 radius=1.5\n"
      "define camera eye 3\ntransform eye rotate -10 1 0 0\ntransform eye translate 0 -1.2 2.2\n");
  Ground const ground = GENERATE(Ground::matt, Ground::glossy);
  RenderRequest const request = ground_request(scene, ground, 1024);
  for (DeviceInfo const& device : {reference_device(), opencl_devices().front()}) {
    auto const radiance = film_on(device, scene, request).values(FilmPlane::radiance);
    Rgb sum(0);
    for (std::size_t i = 0; i < radiance.size(); ++i) sum[int(i % 3)] += radiance[i] / (48 * 32);
    INFO(device.name << ", ground " << int(ground));
    // What the gloss mirrors is the background below the ball, as in the open.
    for (int c = 0; c < 3; ++c) CHECK(sum[c] / background[c] == Approx(0).margin(0.02));
  }
}

TEST_CASE("ground: without light there is nothing that it could be darker than", "[image][path][ground]") {
  REQUIRE_OPENCL_DEVICE();
  Scene const scene = scene_of(camera + "define shape sphere ball 0 50 0 1 grey\n");
  for (DeviceInfo const& device : {reference_device(), opencl_devices().front()}) {
    // Far below the ball, and the camera above: nothing of the picture but the ground.
    Film const film = film_on(device, scene, ground_request(scene, Ground::matt));
    auto const radiance = film.values(FilmPlane::radiance);
    for (std::size_t i = 0; i < radiance.size(); ++i) CHECK(radiance[i] == float(background[int(i % 3)]));
  }
}

TEST_CASE("ground: gloss mirrors what stands over it, by Fresnel's factor", "[image][path][ground]") {
  REQUIRE_OPENCL_DEVICE();
  // A wall of light behind it all, as far as rays from the picture's middle could go.
  Scene scene = scene_of(
      "define material wall 0 0 0  0 0 0  0 0 0 1  emission 2 3 4\n"
      "define shape box wall -500 -1 -21  500 500 -20 wall\n" +
      camera);
  RenderRequest request = ground_request(scene, Ground::glossy, 256);
  Rgb const emission(2, 3, 4);
  Vec3 const direction = glm::normalize(request.camera.generate_ray(24, 26, size).direction);
  double const fresnel = 0.04 + 0.96 * std::pow(1 + direction.y, 5);
  for (DeviceInfo const& device : {reference_device(), opencl_devices().front()}) {
    if (device.kind == DeviceKind::reference) request.sampling.count = 4096;
    request.region = {22, 24, 4, 4};
    auto const radiance = film_on(device, scene, request).values(FilmPlane::radiance);
    Rgb sum(0);
    for (std::size_t i = 0; i < radiance.size(); ++i) sum[int(i % 3)] += radiance[i] / 16;
    INFO(device.name);
    // In the open it mirrors the background. Other light it has none.
    double const tolerance = device.kind == DeviceKind::reference ? 0.4 : 0.03;
    for (int c = 0; c < 3; ++c)
      CHECK(sum[c] - background[c] == Approx(fresnel * (emission[c] - background[c])).epsilon(tolerance));
  }
}

TEST_CASE("ground: nobody but the camera sees it", "[image][path][ground]") {
  REQUIRE_OPENCL_DEVICE();
  // The mirror shows the environment below it, and the black ball, but not how dark that makes the ground.
  Scene const scene = scene_of(
      "define material mirror 0 0 0  0 0 0  0 0 0 1 reflect=1\n"
      "define material black 0 0 0  0 0 0  0 0 0 1\n"
      "define shape sphere ball 0 1 0 1 mirror\ndefine shape sphere low 0 -1 0 0.9 black\n"
      "define light environment sky 0.6 0.7 0.9\n" +
      camera);
  RenderRequest request = ground_request(scene, Ground::none, 16);
  for (DeviceInfo const& device : {reference_device(), opencl_devices().front()}) {
    request.ground = Ground::none;
    auto const without = film_on(device, scene, request).values(FilmPlane::radiance);
    request.ground = Ground::matt;
    auto const with = film_on(device, scene, request).values(FilmPlane::radiance);
    for (int y = 6; y < 16; ++y) {
      for (int c = 0; c < 3; ++c) {
        auto const i = std::size_t(3 * (y * size.width + size.width / 2) + c);
        CHECK(without[i] != float(background[c]));
        CHECK(with[i] == without[i]);
      }
    }
    CHECK(with != without);
  }
}

TEST_CASE("ground: what white panes and prisms throw on it is missing nowhere", "[image][path][ground]") {
  REQUIRE_OPENCL_DEVICE();
  PbrModel glass;
  glass.base_color = Rgb(1);
  glass.metallic = glass.roughness = 0;
  glass.transmission = 1;
  std::string shape;
  SECTION("a pane") {
    glass.ior = 2.4;
    shape =
        "define shape triangle a -1 -1 0  1 -1 0  1 1 0 glass\ndefine shape triangle b -1 -1 0  1 1 0  -1 1 0 glass\n";
  }
  SECTION("a prism") {
    glass.thickness = 1;
    glass.dispersion = 5;
    shape = "define shape sphere ball 0 0 0 1 glass\n";
  }
  Scene scene = scene_of(camera + "define material glass 0 0 0  0 0 0  0 0 0 1\n" + shape);
  **scene.materials.find("glass") = Material("glass", glass);
  scene.environment = EnvironmentLight{"made here", uniform_environment(1, 1, 1), 0, 1};
  RenderRequest request = ground_request(scene, GENERATE(Ground::matt, Ground::glossy), 256);
  request.background = Background::environment();
  request.max_depth = 16;
  auto const radiance = film_on(opencl_devices().front(), scene, request).values(FilmPlane::radiance);
  double sum = 0;
  for (float const value : radiance) sum += double(value) / double(radiance.size());
  CHECK(sum == Approx(1).margin(0.003));
}

TEST_CASE("ground: with the environment it is where the scene has its up", "[image][path][ground]") {
  REQUIRE_OPENCL_DEVICE();
  EnvironmentMap map{8, 4, {}};
  for (int i = 0; i < 32; ++i) map.radiance.insert(map.radiance.end(), {0.1f * float(i % 5), 0.02f * float(i), 0.5f});
  auto const drawn = [&](std::string const& more, Vec3 const& up, Vec3 const& lamp) {
    Scene scene = scene_of(camera + R"(
define shape sphere ball 0.3 0 0 1 grey
define shape box tower -1.5 -1 -1  -1 1.5 -0.4 grey
define shape triangle leaf 1 -0.5 1  2 -0.8 1  1.5 0.5 1.5 grey
define shape composite all ball tower leaf
)" + more);
    scene.environment = EnvironmentLight{"made here", std::make_shared<EnvironmentMap const>(map), 50, 1};
    scene.lights.insert(Light::point("lamp", lamp, Rgb(2)));
    scene.up = up;
    RenderRequest request = ground_request(scene, Ground::matt, 256);
    request.background = Background::environment();
    Film const film = film_on(opencl_devices().front(), scene, request);
    auto const values = film.values(FilmPlane::radiance);
    return std::vector<float>(values.begin(), values.end());
  };
  std::vector<float> const usual = drawn("", {0, 1, 0}, {-3, 4, 2});
  auto const difference = [&](std::vector<float> const& values) {
    double sum = 0;
    for (std::size_t i = 0; i < values.size(); ++i) sum += std::abs(double(values[i]) - usual[i]);
    return sum / double(values.size());
  };
  double const sine = std::sin(glm::radians(40.)), cosine = std::cos(glm::radians(40.));
  // The same, turned as a whole. Noise is what they differ by.
  std::string const forward = "transform all rotate 90 1 0 0\ntransform eye rotate 90 1 0 0\n";
  CHECK(difference(drawn(forward, {0, 0, 2}, {-3, -2, 4})) < 0.002);
  CHECK(difference(drawn("transform all rotate 180 0 0 1\ntransform eye rotate 180 0 0 1\n", {0, -1, 0}, {3, -4, 2})) <
        0.002);
  CHECK(difference(drawn("transform all rotate 40 0 0 1\ntransform eye rotate 40 0 0 1\n", {-sine, cosine, 0},
                         {-3 * cosine - 4 * sine, -3 * sine + 4 * cosine, 2})) < 0.002);
  CHECK(difference(drawn(forward, {0, 1, 0}, {-3, -2, 4})) > 0.05);
}

TEST_CASE("ground: it takes paths, and a picture that keeps what it shows", "[image][path][ground]") {
  REQUIRE_OPENCL_DEVICE();
  Scene const scene = scene_of(camera + "define shape sphere ball 0 0 0 1 grey\n");
  for (DeviceInfo const& device : {reference_device(), opencl_devices().front()}) {
    auto const error_of = [&](RenderRequest const& request) -> std::string {
      auto const renderer = make_renderer(device);
      renderer->set_scene(scene);
      Film film;
      try {
        renderer->render(request, film);
      } catch (Error const& error) {
        return error.what();
      }
      return "";
    };
    RenderRequest request = ground_request(scene, Ground::glossy);
    CHECK(error_of(request).empty());
    request.planes.add(FilmPlane::alpha);
    CHECK_THAT(error_of(request), contains_text("--ground alone keeps shadows"));
    request.ground = Ground::matt;
    CHECK(error_of(request).empty());
    request.max_depth = 0;
    CHECK_THAT(error_of(request), contains_text("depth of 0"));
    request.max_depth = 5;
    request.integrator = Integrator::whitted;
    CHECK_THAT(error_of(request), contains_text("--integrator path does"));
  }
}
