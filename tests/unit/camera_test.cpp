#include "lichtraum/camera.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <stdexcept>
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

TEST_CASE("an orthographic camera's rays are parallel and begin in its plane", "[unit][camera]") {
  Transform const world_from_camera = Transform::translation({3, -2, 5}) * Transform::rotation(40, {0, 1, 0}) *
                                      Transform::rotation(-25, {1, 0, 0}) * Transform::scaling(Vec3(2));
  Camera camera = Camera::orthographic("c", 6, world_from_camera);
  Resolution const size{64, 48};
  Vec3 const ahead = glm::normalize(world_from_camera.vector({0, 0, -1}));
  for (double const x : {0., 32., 63.5}) {
    for (double const y : {0., 24., 40.}) {
      Ray const ray = camera.generate_ray(x, y, size);
      CHECK(glm::distance(ray.direction, ahead) < 1e-12);
      Vec3 const expected = world_from_camera.point({6 * (x / 64 - 0.5), 6 * 48 / 64. * (0.5 - y / 48), 0});
      CHECK(glm::distance(ray.origin, expected) < 1e-12);
    }
  }

  camera.set_lens({.aperture = 0.5, .focus_distance = 4});
  Ray const ray = camera.generate_ray(10, 20, size, 0.6, -0.8);
  Camera sharp = camera;
  sharp.set_lens({});
  Ray const chief = sharp.generate_ray(10, 20, size);
  CHECK(glm::distance(ray.origin, chief.origin) == Approx(0.25));
  CHECK(glm::length(glm::cross(ray.direction, chief.origin + 4.0 * ahead - ray.origin)) < 1e-12);
}

TEST_CASE("how much a camera sees across grows with the distance, unless its rays are parallel", "[unit][camera]") {
  CHECK(Camera("c", 90).width_at(3) == Approx(6));
  CHECK(Camera::orthographic("c", 5).width_at(3) == 5);
  CHECK(Camera::orthographic("c", 5).fov_x_degrees() == 0);
  CHECK(!Camera("c", 90).is_orthographic());
  CHECK(Camera("c", 90).width() == 0);
  for (double const wrong : {0.0, -1.0, std::nan(""), std::numeric_limits<double>::infinity()}) {
    CHECK_THROWS_AS(Camera::orthographic("c", wrong), std::invalid_argument);
    if (wrong != 0) CHECK_THROWS_AS(Camera().set_fit({CameraFit::Side::width, 45, {}, wrong}), std::invalid_argument);
  }
}

TEST_CASE("an orthographic camera keeps its width, its height or the longer of them", "[unit][camera]") {
  Camera camera = Camera::orthographic("c", 5);
  auto const width = [&](CameraFit::Side side, Resolution const& size) {
    camera.set_fit({side, 45, {}, 4});
    Camera const fitted = camera.fitted(size);
    CHECK(!fitted.fit());
    return fitted.width();
  };
  CHECK(width(CameraFit::Side::width, {200, 100}) == 4);
  CHECK(width(CameraFit::Side::height, {200, 100}) == 8);
  CHECK(width(CameraFit::Side::longer, {200, 100}) == 4);
  CHECK(width(CameraFit::Side::longer, {100, 200}) == 2);
  CHECK(Camera("c", 60).fitted({100, 100}).fov_x_degrees() == 60);
}

TEST_CASE("an orthographic camera that frames a box shows all of it, and little else", "[unit][camera]") {
  Bounds const box{{1, 2, 3}, {4, 9, 5}};
  Transform const rotation = Transform::rotation(35, {0, 1, 0}) * Transform::rotation(-30, {1, 0, 0});
  for (Vec3 const& turn_axis : {Vec3(0), Vec3(0, 1, 0)}) {
    for (Resolution const& size : {Resolution{200, 100}, Resolution{100, 200}}) {
      Camera camera = Camera::orthographic("c", 1, rotation);
      camera.set_fit({CameraFit::Side::longer, 45, CameraFit::Framed{box, {}, turn_axis}, 1});
      Camera const fitted = camera.fitted(size);
      double greatest = 0;
      for (int turn = 0; turn < (turn_axis == Vec3(0) ? 1 : 360); ++turn) {
        Transform const turned = Transform::translation(box.center()) * Transform::rotation(turn, {0, 1, 0}) *
                                 Transform::translation(-box.center());
        for (int i = 0; i < 8; ++i) {
          Vec3 const corner((i & 1) != 0 ? box.max.x : box.min.x, (i & 2) != 0 ? box.max.y : box.min.y,
                            (i & 4) != 0 ? box.max.z : box.min.z);
          Vec3 const p = fitted.world_from_camera().inverse().point(turned.point(corner));
          double const half_height = 0.5 * fitted.width() * size.height / size.width;
          greatest = std::max({greatest, std::abs(p.x) / (0.5 * fitted.width()), std::abs(p.y) / half_height});
          CHECK(p.z < 0);
        }
      }
      CHECK(greatest < 1);
      CHECK(greatest > 0.94);
    }
  }
}
