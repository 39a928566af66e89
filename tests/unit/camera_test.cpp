#include "lichtraum/camera.hpp"

#include <utility>

#include "support/catch.hpp"

using namespace lichtraum;

TEST_CASE("rays begin on the lens' disc, which faces ahead, and meet in focus", "[unit][camera]") {
  Transform const world_from_camera =
      Transform::translation({3, -2, 5}) * Transform::rotation(40, {0, 1, 0}) * Transform::rotation(-25, {1, 0, 0});
  Camera camera("c", 60, world_from_camera);
  camera.set_lens({.aperture = 0.5, .focus_distance = 4});
  Vec3 const center = world_from_camera.point(Vec3(0)), ahead = world_from_camera.vector({0, 0, -1});
  Camera pinhole = camera;
  pinhole.set_lens({});
  Resolution const size{64, 48};
  for (double const x : {0.5, 20., 63.5}) {
    for (double const y : {0.5, 24., 40.}) {
      Ray const chief = pinhole.generate_ray(x, y, size);
      Vec3 const sharp = chief.origin + 4 / glm::dot(chief.direction, ahead) * chief.direction;
      for (auto const& [lens_x, lens_y] : {std::pair(1., 0.), std::pair(0., 1.), std::pair(-0.6, -0.8)}) {
        Ray const ray = camera.generate_ray(x, y, size, lens_x, lens_y);
        Vec3 const expected = center + 0.25 * world_from_camera.vector({lens_x, lens_y, 0});
        CHECK(glm::length(ray.origin - expected) < 1e-12);
        CHECK(glm::length(glm::cross(ray.direction, sharp - ray.origin)) < 1e-12);
        CHECK(glm::dot(ray.direction, ahead) > 0);
      }
    }
  }
}
