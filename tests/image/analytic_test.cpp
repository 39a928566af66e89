#include <cmath>

#include "reference/renderer.hpp"
#include "support/catch.hpp"
#include "support/esdf.hpp"
#include "support/picture_check.hpp"

using namespace lichtraum;
using namespace lichtraum::test;

// Pictures that a formula describes pixel by pixel, without any tracer.

namespace {

Resolution const size{120, 90};

/// The OpenCL devices, and the reference tracer itself.
std::vector<DeviceInfo> all_devices() {
  std::vector<DeviceInfo> devices = opencl_devices();
  devices.push_back(reference_device());
  return devices;
}

/// The direction of a pixel's ray for a camera at the origin that looks along -z, 60 degrees wide.
Vec3 pixel_direction(int x, int y) {
  double const pixel = 2 * std::tan(M_PI / 6) / size.width;
  return glm::normalize(Vec3((x + 0.5 - size.width / 2.0) * pixel, (size.height / 2.0 - y - 0.5) * pixel, -1));
}

/// Counts the pixels where the picture is off by more than single precision explains.
template <class Formula>
int count_wrong(Image const& image, Formula const& expected_at) {
  int wrong = 0;
  for (int y = 0; y < size.height; ++y) {
    for (int x = 0; x < size.width; ++x) {
      auto const expected = expected_at(pixel_direction(x, y));
      if (expected && !(std::abs(image.pixel(x, y)[0] - *expected) <= 2e-4)) ++wrong;
    }
  }
  return wrong;
}

}  // namespace

TEST_CASE("a ball lit from the eye is as bright as its angle", "[image]") {
  // Distance d, radius r: a ray at the angle a from the axis meets the ball under the sine d sin(a) / r.
  double const distance = 5, radius = 1.5;
  Scene const scene = scene_of(
      "define material white 0 0 0 1 1 1 0 0 0 1\n"
      "define shape sphere ball 0 0 -5 1.5 white\n"
      "define light diffuse lamp 0 0 0 1 1 1\n"
      "define background 0.25 0.25 0.25\n"
      "define camera eye 60\n");
  for (DeviceInfo const& device : all_devices()) {
    INFO(device.name);
    Image const image = render_on(device, scene, whole_picture(scene.cameras.front(), size));
    int inside = 0;
    int const wrong = count_wrong(image, [&](Vec3 const& direction) -> std::optional<double> {
      double const sine = distance * std::hypot(direction.x, direction.y) / radius;
      if (std::abs(sine - 1) < 1e-3) return std::nullopt;  // the silhouette, where the slope is infinite
      inside += sine < 1;
      return sine < 1 ? std::sqrt(1 - sine * sine) : 0.25;
    });
    CHECK(wrong == 0);
    CHECK(inside > 1500);
  }
}

TEST_CASE("a ball's shadow on the ground is a cone's section", "[image]") {
  // Lamp straight above the ball: a point of the ground is dark when it is seen from the lamp within the ball's angle.
  Vec3 const lamp(0, 3, -6), center(0, 0.5, -6);
  double const radius = 0.8, ground = -1;
  Scene const scene = scene_of(
      "define material white 0 0 0 1 1 1 0 0 0 1\n"
      "define material black 0 0 0 0 0 0 0 0 0 1\n"
      "define shape sphere ball 0 0.5 -6 0.8 black\n"
      "define shape box ground -100 -2 -100 100 -1 100 white\n"
      "define light diffuse lamp 0 3 -6 1 1 1\n"
      "define camera eye 60\n");
  for (DeviceInfo const& device : all_devices()) {
    INFO(device.name);
    Image const image = render_on(device, scene, whole_picture(scene.cameras.front(), size));
    int dark = 0, lit = 0;
    int const wrong = count_wrong(image, [&](Vec3 const& direction) -> std::optional<double> {
      if (direction.y >= -0.015) return std::nullopt;  // sky, or beyond the ground's end
      double const nearest = glm::length(center - glm::dot(center, direction) * direction);
      if (nearest < radius) return std::nullopt;  // the ball itself
      Vec3 const point = direction * (ground / direction.y);
      Vec3 const from_lamp = glm::normalize(point - lamp);
      double const sine = glm::length(glm::cross(from_lamp, center - lamp)) / radius;
      if (std::abs(sine - 1) < 1e-3) return std::nullopt;  // the shadow's edge
      ++(sine < 1 ? dark : lit);
      return sine < 1 ? 0 : -from_lamp.y;
    });
    CHECK(wrong == 0);
    CHECK(dark > 200);
    CHECK(lit > 1500);
  }
}
