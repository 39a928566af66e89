#include <sstream>

#include "compile/scene_buffers.hpp"
#include "lichtraum/graph_summary.hpp"
#include "lichtraum/shapes.hpp"
#include "scene/flatten.hpp"
#include "support/catch.hpp"
#include "support/esdf.hpp"
#include "support/shape_hit.hpp"

using namespace lichtraum;
using namespace lichtraum::test;

namespace {

double const none = std::numeric_limits<double>::infinity();

}  // namespace

TEST_CASE("a plane is met from both sides", "[unit][shape]") {
  Plane const plane("p", {0, -1, 0}, {0, 3, 0}, nullptr);
  CHECK(hit_of(plane, {5, 1, 0}, {0, -1, 0}).t == 2);
  CHECK(hit_of(plane, {5, 1, 0}, {0, -1, 0}).normal == Vec3(0, 1, 0));
  CHECK(hit_of(plane, {5, -3, 0}, {0, 4, 7}).t == 0.5);
  CHECK(hit_of(plane, {5, -3, 0}, {0, 4, 7}).normal == Vec3(0, 1, 0));
  CHECK(hit_of(plane, {1e12, 1e6, 0}, {1, -1, 0}).t == 1e6 + 1);
  CHECK(hit_of(plane, {5, 1, 0}, {0, 1, 0}).t == none);
  CHECK(hit_of(plane, {5, 1, 0}, {1, 0, 0}).t == none);
  CHECK(hit_of(plane, {5, -1, 0}, {1, 0, 0}).t == none);
  CHECK(hit_of(plane, {5, -1, 0}, {0, -1, 0}).t == none);
  CHECK(hit_of(plane, {5, 1, 0}, {0, 0, 0}).t == none);
  CHECK(hit_of(plane, {NAN, NAN, 0}, {0, -1, 0}).t == none);
  Plane slope("s", {0, 0, 0}, {1, 1, 0}, nullptr);
  slope.scale({2, 1, 1});
  CHECK(hit_of(slope, {2, 5, 0}, {0, -1, 0}).t == Approx(6));  // y = -x / 2
  CHECK(glm::length(hit_of(slope, {2, 5, 0}, {0, -1, 0}).normal - glm::normalize(Vec3(1, 2, 0))) < 1e-12);
}

TEST_CASE("a plane prints, and refuses a normal of no direction", "[unit][shape]") {
  std::ostringstream text;
  text << Plane("floor", {0, -1, 0}, {0, 2, 0}, nullptr);
  CHECK(text.str() == "plane 'floor': point 0 -1 0, normal 0 2 0");
  CHECK_THROWS_AS(Plane("p", {0, 0, 0}, {0, 0, 0}, nullptr), std::invalid_argument);
  CHECK_THROWS_AS(Plane("p", {0, 0, 0}, {0, NAN, 0}, nullptr), std::invalid_argument);
}

TEST_CASE("a plane has no bounds, and what has keeps its own", "[unit][shape]") {
  Scene const scene = scene_of(red +
                               "define shape plane floor 0 -1 0 0 1 0 red\n"
                               "define shape sphere s 0 0 0 1 red\n"
                               "define shape composite both s floor\n"
                               "transform both rotate 30 0 0 1\n");
  CHECK_FALSE((*scene.shapes.find("floor"))->bounds().is_finite());
  GraphSummary const summary = summarise(scene.roots());
  CHECK(summary.drawn[ShapeKind::plane] == 1);
  CHECK(summary.bounds.is_finite());
  CHECK(summary.bounds.max.y < 1.5);
  Scene const alone = scene_of(red + "define shape plane floor 0 -1 0 0 1 0 red\n");
  CHECK(summarise(alone.roots()).bounds.is_empty());
}

TEST_CASE("planes stand beside the hierarchies, in instances too", "[unit][shape]") {
  std::string text = red;
  std::string children;
  for (int i = 0; i < 12; ++i) {
    text += "define shape sphere s" + std::to_string(i) + " " + std::to_string(3 * i) + " 0 0 1 red\n";
    children += " s" + std::to_string(i);
  }
  text += "define shape plane floor 0 -1 0 0 1 0 red\ndefine shape composite row" + children;
  std::string const end = "\ndefine shape composite a row\ndefine shape composite b row\ntransform b translate 0 0 9\n";
  for (TreeLayout const layout : {TreeLayout::binary, TreeLayout::wide}) {
    Scene const with = scene_of(text + " floor" + end);
    SceneBuffers const buffers = compile_scene(flatten(with.roots()), with.lights, layout);
    CHECK(buffers.planes.size() == 1);
    CHECK(buffers.instances.size() == 2);
    CHECK(buffers.world_bounds.is_finite());
    CHECK((buffers.shading.features & SCENE_RARE_SHAPES) != 0);
    REQUIRE(buffers.objects.size() == 2);
    CHECK(buffers.objects[0].is_unbounded);
    CHECK(buffers.objects[1].is_unbounded);

    // The bounded rest is the same without: but not the world, which must not be taken from there.
    Scene const without = scene_of(text + end.substr(0, end.rfind('\n') + 1) + "define shape composite c floor\n");
    SceneBuffers const before = compile_scene(flatten(without.roots()), without.lights, layout);
    CHECK_FALSE(before.objects[0].is_unbounded);
    SceneBuffers const reused = compile_scene(flatten(with.roots()), with.lights, layout, &before);
    CHECK(reused.objects[1].content == buffers.objects[1].content);
    CHECK(reused.wide_nodes.size() == buffers.wide_nodes.size());
    CHECK(reused.nodes.size() == buffers.nodes.size());
  }
}
