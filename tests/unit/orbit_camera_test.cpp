#include "view/orbit_camera.hpp"

#include "lichtraum/esdf.hpp"
#include "support/catch.hpp"

using namespace lichtraum;
using namespace lichtraum::view;

namespace {

constexpr Resolution size{64, 48};

Vec3 eye_of(OrbitCamera const& camera) { return camera.camera().world_from_camera().point(Vec3(0)); }

Camera at(Vec3 const& eye, Vec3 const& target) {
  return Camera("eye", 50, Transform::look_along(eye, target - eye, {0, 1, 0}));
}

/// How far apart two cameras' rays are at most, at the picture's corners and middle.
double difference(Camera const& a, Camera const& b) {
  double largest = 0;
  for (auto const& [x, y] :
       {std::pair(0, 0), std::pair(64, 0), std::pair(0, 48), std::pair(64, 48), std::pair(32, 24)}) {
    Ray const ray_a = a.generate_ray(x, y, size), ray_b = b.generate_ray(x, y, size);
    largest =
        std::max({largest, glm::distance(ray_a.origin, ray_b.origin), glm::distance(ray_a.direction, ray_b.direction)});
  }
  return largest;
}

}  // namespace

TEST_CASE("a camera written as eSDF sees the same", "[unit][view]") {
  std::vector<Transform> const places{
      Transform(),
      Transform::translation({1e-3, -2.5, 1e4}),
      Transform::look_along({3, 4, 5}, {-1, -2, -0.5}, {0, 1, 0}),
      Transform::look_along({0, 9, 0}, {0, -1, 0}, {0, 0, -1}),
      Transform::rotation(180, {0, 1, 0}),
      Transform::rotation(40, {1, 2, 3}) * Transform::scaling({1, 2, 0.5}),
      Transform::translation({1, 2, 3}) * Transform::rotation(70, {0, 1, 0}) * Transform::scaling({-1, 1, 1}),
      Transform::scaling({2, 2, -2}),
      Transform::scaling(Vec3(7)),
      Transform::rotation(180, {1, 1, 0}),
      Transform::translation({1, 2, 3}) * Transform::rotation(77, {3, -1, 2}),
      Transform::rotation(30, {0, 0, 1}) * Transform::scaling(Vec3(2.5)),
  };
  for (Transform const& place : places) {
    Camera const camera("my_eye", 41.25, place);
    std::string const text = camera_as_esdf(camera, size);
    INFO(text);
    EsdfOptions options;
    options.strict = text.find(" scale ") == std::string::npos;  // a scale per axis is lichtraum's own
    Scene const scene = EsdfScript::from_text(text, "camera", options).take_scene();
    REQUIRE(scene.cameras.size() == 1);
    CHECK(scene.cameras.front().name() == "my_eye");
    CHECK(scene.cameras.front().resolution() == size);
    CHECK(difference(scene.cameras.front(), camera) < 1e-9);
  }
  for (Transform const& place : places) {
    Camera const camera = Camera::orthographic("parallel", 4.5, place);
    Scene const scene = EsdfScript::from_text(camera_as_esdf(camera, size), "camera", {}).take_scene();
    REQUIRE(scene.cameras.front().is_orthographic());
    CHECK(difference(scene.cameras.front(), camera) < 1e-9);
  }
  Camera lens("eye", 45);
  lens.set_lens({0.25, 7.5});
  Scene const scene = EsdfScript::from_text(camera_as_esdf(lens, size), "camera", {}).take_scene();
  CHECK(scene.cameras.front().lens() == Lens{0.25, 7.5});
  std::string const named = camera_as_esdf(Camera("My Cam #1", 45, Transform::translation({1, 2, 3})), size);
  CHECK(EsdfScript::from_text(named, "camera", {}).take_scene().cameras.front().name() == "My_Cam__1");
}

TEST_CASE("a camera orbits at its distance, and not over the zenith", "[unit][view]") {
  Camera const start = at({0, 3, 10}, {0, 0, 0});
  OrbitCamera camera(start, Vec3(0), size);
  CHECK(difference(camera.camera(), start) == 0);
  CHECK(glm::length(camera.pivot()) < 1e-12);
  camera.orbit(90, 0);
  CHECK(glm::distance(eye_of(camera), Vec3(10, 3, 0)) < 1e-9);
  camera.orbit(-90, 0);
  CHECK(difference(camera.camera(), start) < 1e-9);
  camera.orbit(0, 20);
  camera.orbit(0, -20);
  CHECK(difference(camera.camera(), start) < 1e-9);
  double const distance = camera.distance();
  for (int i = 0; i < 50; ++i) camera.orbit(7, 11);
  CHECK(eye_of(camera).y > 0.999 * distance);
  CHECK(camera.distance() == Approx(distance));
  // It is not upside down, and comes down again on its side.
  CHECK(camera.camera().world_from_camera().vector({0, 1, 0}).y > 0);
  for (int i = 0; i < 50; ++i) camera.orbit(0, -11);
  CHECK(eye_of(camera).y < -0.999 * distance);
  CHECK(glm::length(camera.pivot()) < 1e-9);
}

TEST_CASE("a camera orbits around another upward direction", "[unit][view]") {
  Camera const start("eye", 50, Transform::look_along({0, -10, 3}, {0, 10, -3}, {0, 0, 1}));
  OrbitCamera camera(start, Vec3(0), size, {0, 0, 1e300});
  camera.orbit(90, 0);
  CHECK(glm::distance(eye_of(camera), Vec3(10, 0, 3)) < 1e-9);
  for (int i = 0; i < 50; ++i) camera.orbit(7, 11);
  CHECK(eye_of(camera).z > 0.999 * camera.distance());
  CHECK(camera.camera().world_from_camera().vector({0, 1, 0}).z > 0);
}

TEST_CASE("what is little beside the middle stays where it is as a camera orbits and zooms", "[unit][view]") {
  for (bool const is_orthographic : {false, true}) {
    Transform const place = at({0, 3, 10}, {0, 0, 0}).world_from_camera();
    Camera const start = is_orthographic ? Camera::orthographic("eye", 8, place) : Camera("eye", 50, place);
    Vec3 const center(0.6, 0, 0), beside(1.2, 0, 0);  // of some nine across, or eight
    OrbitCamera camera(start, center, size);
    CHECK(camera.pivot() == center);
    CHECK(difference(camera.camera(), start) == 0);
    auto const seen = [&] {
      Vec3 const point = camera.camera().world_from_camera().inverse().point(center);
      return is_orthographic ? Vec3(point.x, point.y, 0) / camera.camera().width() : point / point.z;
    };
    Vec3 const before = seen();
    camera.orbit(50, 20);
    CHECK(glm::distance(seen(), before) < 1e-9);
    camera.zoom(0.5);
    CHECK(glm::distance(seen(), before) < 1e-9);
    CHECK(glm::length(OrbitCamera(start, beside, size).pivot()) < 1e-9);
  }
}

TEST_CASE("a camera pans, zooms and frames", "[unit][view]") {
  OrbitCamera camera(at({0, 0, 10}, {0, 0, 0}), Vec3(0), size);
  camera.zoom(0.5);
  CHECK(glm::distance(eye_of(camera), Vec3(0, 0, 5)) < 1e-12);
  camera.zoom(2);
  double const width = 20 * std::tan(25 * 3.14159265358979 / 180);
  camera.pan(0.5, 0.25);
  CHECK(glm::distance(eye_of(camera), Vec3(width / 2, width / 4, 10)) < 1e-9);
  CHECK(glm::distance(camera.pivot(), Vec3(width / 2, width / 4, 0)) < 1e-9);
  camera.frame({1, 2, 3}, 2, size);
  CHECK(glm::distance(camera.pivot(), Vec3(1, 2, 3)) < 1e-12);
  // The ball touches the picture's upper edge: the ray there passes it at its radius.
  Ray const ray = camera.camera().generate_ray(32, 0, size);
  double const passes_at = glm::length(glm::cross(Vec3(1, 2, 3) - ray.origin, ray.direction));
  CHECK(passes_at == Approx(2));
  // What is behind a camera is no reason to turn it.
  OrbitCamera const away(at({0, 0, 10}, {0, 0, 20}), Vec3(0), size);
  CHECK(difference(away.camera(), at({0, 0, 10}, {0, 0, 20})) == 0);
  CHECK(glm::distance(away.pivot(), Vec3(0, 0, 20)) < 1e-9);
}

TEST_CASE("a camera in the middle of a room is moved by what is seen", "[unit][view]") {
  constexpr double radius = 8;
  for (double const ahead : {0.0, 1e-6, -1e-6}) {
    Camera const start = at({0, 0, 0}, {0, 0, -1});
    OrbitCamera camera(start, {0, 0, -ahead}, size, {0, 1, 0}, radius);
    CHECK(difference(camera.camera(), start) == 0);
    camera.zoom(0.85);
    CHECK(eye_of(camera).z < -0.02 * radius);
    camera.zoom(1 / 0.85);
    camera.pan(0.5, 0);
    CHECK(eye_of(camera).x > 0.05 * radius);
  }
  // Who stands outside goes around the middle, however little is ahead.
  CHECK(OrbitCamera(at({0, 0, 8.5}, {0, 0, 0}), Vec3(0), size, {0, 1, 0}, radius).pivot() == Vec3(0));
}

TEST_CASE("a camera shows all that it showed in pictures of other proportions", "[unit][view]") {
  Camera const start = at({0, 0, 10}, {0, 0, 0});
  Resolution const square{100, 100};
  OrbitCamera camera(start, Vec3(0), square);
  auto const corner = [&](double x, double y, Resolution const& picture) {
    return camera.camera().generate_ray(x, y, picture).direction;
  };
  Vec3 const before = corner(0, 0, square);
  camera.fit_to({300, 100});
  CHECK(glm::distance(corner(100, 0, {300, 100}), before) < 1e-12);
  camera.fit_to({100, 200});
  CHECK(glm::distance(corner(0, 50, {100, 200}), before) < 1e-12);
  camera.fit_to(square);
  CHECK(difference(camera.camera(), start) == 0);
  CHECK(camera.camera().fov_x_degrees() == Approx(start.fov_x_degrees()));
}

TEST_CASE("an orthographic camera zooms by what it sees across", "[unit][view]") {
  Transform const world_from_camera =
      Transform::look_along({0, 0, 10}, {0, 0, -1}, {0, 1, 0}) * Transform::scaling(Vec3(2));
  OrbitCamera camera(Camera::orthographic("eye", 6, world_from_camera), Vec3(0), size);
  camera.zoom(0.5);
  CHECK(camera.camera().width() == Approx(3));
  CHECK(camera.distance() == Approx(5));
  camera.zoom(2);
  camera.pan(0.5, 0.25);
  CHECK(glm::distance(eye_of(camera), Vec3(6, 3, 10)) < 1e-9);

  // The ball touches the upper edge of a wide picture, the left edge of a high one.
  for (Resolution const& picture : {Resolution{200, 100}, Resolution{100, 200}}) {
    camera.fit_to(picture);
    camera.frame({1, 2, 3}, 2, picture);
    bool const is_wide = picture.width > picture.height;
    Ray const ray =
        is_wide ? camera.camera().generate_ray(100, 0, picture) : camera.camera().generate_ray(0, 100, picture);
    CHECK(glm::length(glm::cross(Vec3(1, 2, 3) - ray.origin, ray.direction)) == Approx(2));
    CHECK(glm::dot(Vec3(1, 2, 3) - ray.origin, ray.direction) > 2);
  }
}

TEST_CASE("an orthographic camera shows all that it showed in pictures of other proportions", "[unit][view]") {
  Camera const start = Camera::orthographic("eye", 6, Transform::translation({0, 0, 10}));
  OrbitCamera camera(start, Vec3(0), {100, 100});
  for (double const zoom : {1.0, 0.5}) {
    camera.zoom(zoom);
    camera.fit_to({300, 100});
    CHECK(camera.camera().width() == Approx(18 * zoom));
    camera.fit_to({100, 200});
    CHECK(camera.camera().width() == Approx(6 * zoom));
    camera.fit_to({100, 100});
    CHECK(camera.camera().width() == Approx(6 * zoom));
  }
}
