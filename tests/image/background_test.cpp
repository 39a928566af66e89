#include <vector>

#include "support/catch.hpp"
#include "support/esdf.hpp"
#include "support/picture_check.hpp"
#include "support/skip.hpp"

// What rays show that hit nothing.

using namespace lichtraum;
using namespace lichtraum::test;

namespace {

/// A ball in the middle that shows nothing but what it mirrors.
Scene mirror_ball() {
  return scene_of(
      "define material mirror 0 0 0  0 0 0  0 0 0  1 reflect=1\ndefine shape sphere ball 0 0 -5 1 mirror\n"
      "define background 0.5 0.25 1\ndefine camera eye 60\n");
}

Rgb pixel(Image const& image, int x, int y) {
  std::size_t const i = 3 * (std::size_t(y) * std::size_t(image.width()) + std::size_t(x));
  return {double(image.data()[i]), double(image.data()[i + 1]), double(image.data()[i + 2])};
}

std::vector<DeviceInfo> all_devices() {
  std::vector<DeviceInfo> devices = opencl_devices();
  devices.push_back(reference_device());
  return devices;
}

}  // namespace

TEST_CASE("a gradient goes from the upper edge to the lower one, and mirrors show its mean", "[image][background]") {
  Scene const scene = mirror_ball();
  constexpr Resolution size{30, 20};
  Rgb const top(1, 0, 0.25), bottom(0, 4, 0.25);
  for (DeviceInfo const& device : all_devices()) {
    INFO(device.name);
    for (int const count : {1, 16}) {
      RenderRequest request = whole_picture(scene.cameras.front(), size);
      request.sampling = {Sampling::Pattern::seeded, count};
      request.background = Background(top, bottom);
      Image const image = render_on(device, scene, request);
      for (int y = 0; y < size.height; ++y) {
        // The middle of the row, whatever the samples.
        Rgb const expected = glm::mix(top, bottom, (y + 0.5) / size.height);
        CHECK(glm::distance(pixel(image, 0, y), expected) < 1e-6);
        CHECK(pixel(image, 29, y) == pixel(image, 0, y));
      }
      CHECK(glm::distance(pixel(image, 15, 10), 0.5 * (top + bottom)) < 1e-6);
    }
  }
}

TEST_CASE("regions of a gradient are the picture's to the bit", "[image][background]") {
  Scene const scene = mirror_ball();
  RenderRequest request = whole_picture(scene.cameras.front(), {61, 47});
  request.background = Background(Rgb(0.7, 0.1, 0.3), Rgb(0.123, 0.9, 3));
  for (DeviceInfo const& device : all_devices()) {
    INFO(device.name);
    Image const whole = render_on(device, scene, request);
    RenderRequest part = request;
    part.region = {13, 9, 31, 27};
    Image const cut = render_on(device, scene, part);
    for (int y = 0; y < part.region.height; ++y) {
      for (int x = 0; x < part.region.width; ++x) {
        if (pixel(cut, x, y) != pixel(whole, x + part.region.x, y + part.region.y)) FAIL("pixel " << x << ", " << y);
      }
    }
  }
}

TEST_CASE("one colour twice is that colour", "[image][background]") {
  Scene scene = mirror_ball();
  scene.background = Rgb(0.1, 1.0 / 3, 7);
  RenderRequest request = whole_picture(scene.cameras.front(), {33, 33});
  for (DeviceInfo const& device : all_devices()) {
    request.background.reset();
    Image const from_scene = render_on(device, scene, request);
    CHECK(pixel(from_scene, 0, 32) == Rgb(0.1f, double(float(1.0 / 3)), 7));
    request.background = Background(scene.background, scene.background);
    CHECK(render_on(device, scene, request).data() == from_scene.data());
    request.background = scene.background;
    CHECK(render_on(device, scene, request).data() == from_scene.data());
  }
}

TEST_CASE("an environment is shown only by who draws one", "[image][background]") {
  Scene const scene = mirror_ball();
  RenderRequest request = whole_picture(scene.cameras.front(), {3, 3});
  request.background = Background::environment();
  for (DeviceInfo const& device : all_devices()) {
    auto const renderer = make_renderer(device);
    renderer->set_scene(scene);
    Film film;
    CHECK_THROWS_AS(renderer->render(request, film), Error);
  }
}

TEST_CASE("paths: the background is seen through thin walls, however rough they are", "[image][path][background]") {
  REQUIRE_OPENCL_DEVICE();
  Scene scene = scene_of(
      "define material glass 0 0 0  0 0 0  0 0 0  1\n"
      "define shape triangle wall -90 -90 -5  90 -90 -5  0 90 -5 glass\n"
      "define light ambient sky 9 9 9\ndefine camera eye 10\n");
  bool has_alpha = false;
  SECTION("drawn") {}
  SECTION("drawn before another environment") {
    EnvironmentMap map{4, 2, std::vector<float>(24, 9)};
    for (std::size_t i = 0; i < 6; ++i) map.radiance[i] = 90;  // which is looked for
    scene.environment = EnvironmentLight{"made here", std::make_shared<EnvironmentMap const>(map), 0, 1};
  }
  SECTION("left open") { has_alpha = true; }
  RenderRequest request = whole_picture(scene.cameras.front(), {8, 8});
  request.integrator = Integrator::path;
  request.sampling = {Sampling::Pattern::seeded, 256};
  request.background = Rgb(0.5, 0.25, 1);
  for (double const roughness : {0.0, 0.05, 0.5, 1.0}) {
    PbrModel glass;
    glass.base_color = {0.5, 0.5, 0.5};
    glass.roughness = roughness;
    glass.metallic = 0;
    glass.transmission = 1;
    glass.specular = 0;  // nothing but the background comes from it
    glass.double_sided = true;
    *(*scene.materials.find("glass")) = Material("glass", glass);
    if (has_alpha) request.planes.add(FilmPlane::alpha);
    for (DeviceInfo const& device : opencl_devices()) {
      INFO(device.name << ", roughness " << roughness);
      auto const renderer = make_renderer(device);
      renderer->set_scene(scene);
      Film film;
      renderer->render(request, film);
      auto const radiance = film.values(FilmPlane::radiance);
      Rgb mean(0);
      for (std::size_t i = 0; i < radiance.size(); ++i) mean[glm::length_t(i % 3)] += double(radiance[i]) / 64;
      Rgb const expected = has_alpha ? Rgb(0) : Rgb(0.25, 0.125, 0.5);
      CHECK(glm::distance(mean, expected) < 0.005);
      if (!has_alpha) continue;
      double alpha = 0;
      for (float const value : film.values(FilmPlane::alpha)) alpha += double(value) / 64;
      CHECK(alpha == Approx(0.5).margin(0.005));
    }
  }
}
