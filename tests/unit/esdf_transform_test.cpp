#include <glm/gtc/constants.hpp>
#include <string>

#include "support/catch.hpp"
#include "support/esdf.hpp"

// Where points end up, against numbers worked out by hand.

using namespace lichtraum;
using namespace lichtraum::test;

namespace {

std::string const sphere = red + "define shape sphere s 0 0 0 1 red\n";

/// Where (1, 2, 3) of shape `name` ends up in its parent.
Vec3 moved(std::string const& transforms, EsdfOptions const& options = {}, std::string const& name = "s") {
  Scene const scene = scene_of(sphere + transforms, options);
  auto const* const found = scene.shapes.find(name);
  REQUIRE(found);
  return (*found)->world_from_object().point(Vec3(1, 2, 3));
}

void check_moved(std::string const& transforms, Vec3 const& expected, EsdfOptions const& options = {}) {
  INFO(transforms);
  Vec3 const p = moved(transforms, options);
  INFO(p.x << ' ' << p.y << ' ' << p.z);
  CHECK(glm::length(p - expected) < 1e-12);
}

EsdfOptions const local = [] {
  EsdfOptions options;
  options.transform_order = TransformOrder::local;
  return options;
}();

EsdfOptions const left = [] {
  EsdfOptions options;
  options.rotation = RotationSense::left;
  return options;
}();

}  // namespace

TEST_CASE("single transforms", "[unit][esdf]") {
  check_moved("", Vec3(1, 2, 3));
  check_moved("transform s translate 10 20 30\n", Vec3(11, 22, 33));
  check_moved("transform s scale 2\n", Vec3(2, 4, 6));
  check_moved("transform s scale -1\n", Vec3(-1, -2, -3));
  check_moved("transform s scale 2 3 -4\n", Vec3(2, 6, -12));
  check_moved("transform s rotate 90 0 0 1\n", Vec3(-2, 1, 3));
  check_moved("transform s rotate 90 0 0 0.001\n", Vec3(-2, 1, 3));
  check_moved("transform s rotate 90 0 0 -7\n", Vec3(2, -1, 3));
  check_moved("transform s rotate -90 1 0 0\n", Vec3(1, 3, -2));
  check_moved("transform s rotate 120 1 1 1\n", Vec3(3, 1, 2));
  check_moved("define transform s translate 10 20 30\n", Vec3(11, 22, 33));
}

TEST_CASE("axis letters and rotations about three axes", "[unit][esdf]") {
  check_moved("transform s rotate 90 x\n", Vec3(1, -3, 2));
  check_moved("transform s rotate 90 y\n", Vec3(3, 2, -1));
  check_moved("transform s rotate 90 z\n", Vec3(-2, 1, 3));
  // about x: (1, -3, 2); then about y: (2, -3, -1); then about z: (3, 2, -1)
  check_moved("transform s rotate 90 90 90\n", Vec3(3, 2, -1));
  // The same in the object's own frame is Rx Ry Rz: about z first: (-2, 1, 3), y: (3, 1, 2), x: (3, -2, 1)
  check_moved("transform s rotate 90 90 90\n", Vec3(3, -2, 1), local);
}

TEST_CASE("transforms compose in the parent's frame, or in the object's own", "[unit][esdf]") {
  std::string const turn_then_move = "transform s rotate 90 0 0 1\ntransform s translate 10 0 0\n";
  check_moved(turn_then_move, Vec3(8, 1, 3));
  check_moved(turn_then_move, Vec3(-2, 11, 3), local);
  std::string const move_then_scale = "transform s translate 10 0 0\ntransform s scale 2\n";
  check_moved(move_then_scale, Vec3(22, 4, 6));
  check_moved(move_then_scale, Vec3(12, 4, 6), local);
}

TEST_CASE("left-handed rotations", "[unit][esdf]") {
  check_moved("transform s rotate 90 0 0 1\n", Vec3(2, -1, 3), left);
  check_moved("transform s rotate 90 z\n", Vec3(2, -1, 3), left);
  check_moved("transform s rotate 0 0 90\n", Vec3(2, -1, 3), left);
  check_moved("transform s translate 1 1 1\n", Vec3(2, 3, 4), left);
}

TEST_CASE("a child may be transformed after its composite was defined", "[unit][esdf]") {
  Scene const scene = scene_of(sphere +
                               "define shape composite c s\n"
                               "transform c translate 0 100 0\n"
                               "transform s translate 10 0 0\n");
  auto const& composite = dynamic_cast<Composite const&>(**scene.shapes.find("c"));
  CHECK(composite.world_from_object().point(Vec3(0)) == Vec3(0, 100, 0));
  CHECK(composite.children()[0]->world_from_object().point(Vec3(0)) == Vec3(10, 0, 0));
}

TEST_CASE("cameras are transformed like shapes", "[unit][esdf]") {
  std::string const text =
      "define camera eye 45 1 2 3 0 0 -1\ntransform eye rotate 90 0 0 1\ntransform eye translate 10 0 0\n";
  auto const place = [&](EsdfOptions const& options) {
    return scene_of(text, options).cameras.find("eye")->world_from_camera().point(Vec3(0));
  };
  CHECK(glm::length(place({}) - Vec3(8, 1, 3)) < 1e-12);
  CHECK(glm::length(place(local) - Vec3(1, 12, 3)) < 1e-12);
  CHECK(glm::length(place(left) - Vec3(12, -1, 3)) < 1e-12);
}

TEST_CASE("the standard's example camera looks away from its scene, and at it with left rotations", "[unit][esdf]") {
  std::string const text = eye + "transform eye rotate -45 0 1 0\ntransform eye translate 100 0 100\n";
  auto const sees_origin = [&](EsdfOptions const& options) {
    Scene const scene = scene_of(text, options);
    Transform const& frame = scene.cameras.find("eye")->world_from_camera();
    return glm::dot(frame.vector(Vec3(0, 0, -1)), -frame.point(Vec3(0))) > 0.9 * glm::length(frame.point(Vec3(0)));
  };
  CHECK_FALSE(sees_origin({}));
  CHECK(sees_origin(left));
}

TEST_CASE("transforms that exceed the range of numbers are refused", "[unit][esdf]") {
  std::string text = eye;
  for (int i = 0; i < 20; ++i) text += "transform eye scale 1e38\n";
  auto const found = findings(text);
  REQUIRE_FALSE(found.empty());
  CHECK(found[0].message == "the transforms of 'eye' exceed the range of numbers");
  EsdfOptions options;
  options.keep_going = true;
  Scene const scene = scene_of(text, options);
  CHECK(std::isfinite(scene.cameras.find("eye")->world_from_camera().matrix()[0][0]));
}
