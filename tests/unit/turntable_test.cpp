#include "lichtraum/turntable.hpp"

#include <string>

#include "lichtraum/renderer.hpp"
#include "scene/copy_graph.hpp"
#include "support/catch.hpp"

using namespace lichtraum;

TEST_CASE("the centre of interest leaves out what surrounds the camera", "[unit][turntable]") {
  Scene scene;
  Camera const camera("eye", 45, Transform::translation({0, 0, 10}));
  auto const is_at = [&](Vec3 const& expected, char const* root = "") {
    return glm::distance(center_of_interest(scene, root, camera), expected) < 1e-5;  // boxes are rounded outwards
  };
  CHECK(is_at(Vec3(0)));
  scene.shapes.insert(std::make_shared<Box>("floor", Vec3(-50, -1, -50), Vec3(70, 0, 50), nullptr));
  CHECK(is_at(Vec3(10, -0.5, 0)));
  scene.shapes.insert(std::make_shared<Sphere>("ball", Vec3(3, 2, 1), 2, nullptr));
  CHECK(is_at(Vec3(3, 2, 1)));
  auto const group =
      std::make_shared<Composite>("group", Composite::Children{std::make_shared<Sphere>("s", Vec3(0), 1, nullptr)});
  group->translate({9, 2, 1});
  scene.shapes.insert(group);
  CHECK(is_at(Vec3(5.5, 2, 1)));
  CHECK(is_at(Vec3(9, 2, 1), "group"));
}

TEST_CASE("before a camera stands anywhere, only floors and rooms are left out", "[unit][turntable]") {
  auto const interest = [](std::vector<Bounds> const& boxes) {
    Scene scene;
    for (Bounds const& box : boxes) {
      scene.shapes.insert(std::make_shared<Box>("b" + std::to_string(scene.shapes.size()), box.min, box.max, nullptr));
    }
    return bounds_of_interest(scene, "");
  };
  auto const is = [](Bounds const& a, Bounds const& b) {  // boxes are rounded outwards
    return glm::distance(a.min, b.min) < 1e-4 && glm::distance(a.max, b.max) < 1e-4;
  };
  Bounds const thing{Vec3(-1, 0, -1), Vec3(1, 2, 1)}, beside{Vec3(2, 0, 0), Vec3(3, 1, 1)};
  Bounds const both{Vec3(-1, 0, -1), Vec3(3, 2, 1)};
  Bounds const floor{Vec3(-20, -1, -20), Vec3(20, 0, 20)}, room{Vec3(-25, -2, -25), Vec3(25, 9, 25)};
  CHECK(is(interest({thing}), thing));
  CHECK(is(interest({thing, beside}), both));
  CHECK(is(interest({floor, thing, beside}), both));
  CHECK(is(interest({thing, room, beside}), both));
  CHECK(is(interest({room, thing, floor, beside}), both));
  Bounds const ceiling{Vec3(-20, 8, -20), Vec3(20, 8.1, 20)};
  CHECK(is(interest({ceiling, thing, floor, beside}), both));
  CHECK(is(interest({floor}), floor));
  CHECK(is(interest({floor, room}), room));  // hardly wider: it may be a thing
  CHECK(
      is(interest({thing, {Vec3(-1.2, -0.1, -1.2), Vec3(1.2, 0, 1.2)}}), {Vec3(-1.2, -0.1, -1.2), Vec3(1.2, 2, 1.2)}));
  Bounds const outside{Vec3(22, 0, 0), Vec3(23, 1, 1)};  // a floor that ends before it is no floor of the whole
  CHECK(is(interest({thing, floor, outside}), {Vec3(-20, -1, -20), Vec3(23, 2, 20)}));
  Bounds const pedestal{Vec3(-3, -8, -3), Vec3(3, 0, 3)};  // not flat, and no room
  CHECK(is(interest({thing, pedestal}), {Vec3(-3, -8, -3), Vec3(3, 2, 3)}));
  CHECK(interest({}).is_empty());
}

TEST_CASE("an orbited camera keeps its distance, height and what it looks at", "[unit][turntable]") {
  Camera const camera("eye", 45, Transform::look_along({0, 3, 10}, {0, -3, -10}, {0, 1, 0}));
  Camera const quarter = orbited(camera, Vec3(0), 90);
  Vec3 const eye = quarter.world_from_camera().point(Vec3(0));
  CHECK(glm::distance(eye, Vec3(10, 3, 0)) < 1e-12);
  Ray const ray = quarter.generate_ray(50, 50, {100, 100});
  CHECK(glm::distance(ray.direction, glm::normalize(Vec3(-10, -3, 0))) < 1e-12);
  Camera const beside = orbited(camera, Vec3(5, 0, 0), 180);
  CHECK(glm::distance(beside.world_from_camera().point(Vec3(0)), Vec3(10, 3, -10)) < 1e-12);
}

TEST_CASE("a prepared scene does not change with the scene", "[unit][reference]") {
  Scene scene;
  auto const ball = std::make_shared<Sphere>("ball", Vec3(0, 0, -5), 1, nullptr);
  auto const pair = std::make_shared<Composite>("pair", Composite::Children{ball, ball});
  scene.shapes.insert(ball);
  scene.shapes.insert(pair);
  auto const renderer = make_renderer(reference_device());
  auto const prepared = renderer->prepare(scene);
  CHECK(prepared->fingerprint == renderer->prepare(scene)->fingerprint);
  ball->translate({100, 0, 0});
  CHECK(prepared->fingerprint != renderer->prepare(scene)->fingerprint);

  RenderRequest request;
  request.camera = Camera("eye", 45);
  request.resolution = {9, 9};
  request.region = {0, 0, 9, 9};
  Film film, other;
  renderer->set_scene(prepared);
  CHECK(renderer->render(request, film).statistics.rays.camera_hits > 0);
  renderer->set_scene(scene);
  CHECK(renderer->render(request, other).statistics.rays.camera_hits == 0);
}

TEST_CASE("a copied graph shares what was shared", "[unit][scene]") {
  std::shared_ptr<Shape> top = std::make_shared<Sphere>("ball", Vec3(1, 2, 3), 4, nullptr);
  top->scale(2);
  for (int i = 0; i < 100'000; ++i) top = std::make_shared<Composite>("level", Composite::Children{top, top});
  auto const copies = copy_graph({top});
  top.reset();
  Shape const* shape = copies.at(0).get();
  int depth = 0;
  while (auto const* const composite = dynamic_cast<Composite const*>(shape)) {
    REQUIRE(composite->children().size() == 2);
    REQUIRE(composite->children()[0] == composite->children()[1]);
    shape = composite->children()[0].get();
    ++depth;
  }
  CHECK(depth == 100'000);
  auto const* const ball = dynamic_cast<Sphere const*>(shape);
  REQUIRE(ball);
  CHECK(ball->world_from_object().point(ball->center()) == Vec3(2, 4, 6));
}
