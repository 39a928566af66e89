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
