/// Which shapes are looked for as lamps, and where they are in the world.

#include "compile/emissive_shapes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "scene/flatten.hpp"
#include "support/catch.hpp"
#include "support/esdf.hpp"

using namespace lichtraum;
using namespace lichtraum::test;

namespace {

SceneBuffers compiled(std::string const& text, TreeLayout layout) {
  Scene const scene = scene_of(text);
  return compile_scene(flatten(scene.roots()), scene.lights, layout);
}

constexpr char const* materials = R"(
define material matt 0 0 0  0.5 0.5 0.5  0 0 0 1
define material lamp 0 0 0  0.5 0.5 0.5  0 0 0 1  emission 3 2 1
define material glass 0 0 0  0.5 0.5 0.5  0 0 0 1  transmit=0.5 emission 3 2 1
define camera eye 45
)";

Vec3 vec3(float const (&v)[3]) { return {v[0], v[1], v[2]}; }

}  // namespace

TEST_CASE("Spheres, ellipsoids and boxes that shine are lamps, in the world's frame", "[light]") {
  std::string const text = std::string(materials) + R"(
define shape sphere ball 1 2 3 0.5 lamp
define shape sphere dark 5 2 3 0.5 matt
define shape sphere clear -5 2 3 0.5 glass
define shape sphere egg 0 0 0 1 lamp
transform egg scale 1 3 2
transform egg translate 0 0 -4
define shape box block -1 -2 -3  1 2 3 lamp
transform block rotate 90 0 1 0
define shape box flat -1 5 -2  1 5 2 lamp
define shape cylinder tube 7 0 0  7 1 0  0.3 lamp
)";
  for (TreeLayout const layout : {TreeLayout::binary, TreeLayout::wide}) {
    SceneBuffers const scene = compiled(text, layout);
    auto const& solids = scene.emissive_solids;
    REQUIRE(solids.size() == 4);
    CHECK(solids[0].kind == PRIMITIVE_SPHERE);
    CHECK(vec3(solids[0].center) == Vec3(1, 2, 3));
    CHECK(vec3(solids[0].axes[1]) == Vec3(0, 0.5, 0));
    CHECK(solids[0].unit_from_world.row_y.w == -4);
    CHECK(solids[1].kind == PRIMITIVE_ELLIPSOID);
    CHECK(vec3(solids[1].center) == Vec3(0, 0, -4));
    CHECK(vec3(solids[1].axes[1]) == Vec3(0, 3, 0));
    CHECK(std::abs(solids[1].unit_from_world.row_z.z - 0.5) < 1e-6);
    auto const volume = [](device::EmissiveSolid const& solid) {
      return std::abs(glm::dot(vec3(solid.axes[0]), glm::cross(vec3(solid.axes[1]), vec3(solid.axes[2]))));
    };
    CHECK(std::abs(volume(solids[2]) - 6) < 1e-5);
    CHECK(std::abs(std::abs(solids[2].axes[0][2]) - 1) < 1e-6);  // its x is the world's -z
    CHECK(volume(solids[3]) == 0);
    CHECK(vec3(solids[3].center) == Vec3(0, 5, 0));
    for (auto const& solid : solids) {
      CHECK(solid.instance == 0xffffffffu);
      CHECK(scene.shading.materials[solid.material].emission[0] == 3);
    }
    // As hits name them.
    CHECK(scene.boxes[solids[2].index].min[1] == -2);
    CHECK(scene.boxes[solids[3].index].min[1] == 5);
    auto const constants = scene_constants(scene, scene.shading);
    CHECK(constants.emissive_solid_count == 4);
    CHECK(constants.emissive_triangle_count == 0);
  }
}

TEST_CASE("A lamp that several instances show is one for each", "[light]") {
  std::string text = std::string(materials) + "define shape sphere ball 0 0 0 1 lamp\n";
  for (int i = 0; i < 40; ++i) {  // so many that they are not baked
    std::string const name = "dark" + std::to_string(i);
    text += "define shape sphere " + name + " 0 " + std::to_string(i + 3) + " 0 1 matt\n";
  }
  text += "define shape composite tower ball";
  for (int i = 0; i < 40; ++i) text += " dark" + std::to_string(i);
  text += "\ndefine shape composite root";
  for (int i = 0; i < 40; ++i) text += " at" + std::to_string(i);
  std::string places;
  for (int i = 0; i < 40; ++i) {
    std::string const name = "at" + std::to_string(i);
    places += "define shape composite " + name + " tower\ntransform " + name + " scale 1 1 2\ntransform " + name +
              " translate " + std::to_string(5 * i) + " 0 0\n";
  }
  text.insert(text.find("\ndefine shape composite root") + 1, places);
  SceneBuffers const scene = compiled(text, TreeLayout::wide);
  auto const& solids = scene.emissive_solids;
  REQUIRE(solids.size() == 40);
  REQUIRE(scene.instances.size() == 40);
  std::vector<float> places_x;
  for (std::size_t i = 0; i < solids.size(); ++i) {
    CHECK(solids[i].instance == i);
    CHECK(solids[i].index == solids[0].index);
    CHECK(scene.sphere_blocks[solids[i].index / BLOCK_LANES].center[1][solids[i].index % BLOCK_LANES] == 0);
    // The device's map of the instance says where the ball is, too.
    CHECK(std::abs(scene.instances[i].object_from_world.row_x.w + solids[i].center[0]) < 1e-4);
    CHECK(std::abs(solids[i].axes[2][2]) == 2);
    places_x.push_back(solids[i].center[0]);
  }
  std::ranges::sort(places_x);
  for (std::size_t i = 0; i < places_x.size(); ++i) CHECK(places_x[i] == 5 * float(i));
}

TEST_CASE("Lamps are chosen by how bright and how large they are", "[light]") {
  std::string const text = std::string(materials) + R"(
define shape sphere small 0 0 0 1 lamp
define shape sphere large 5 0 0 2 lamp
define shape box block -9 -1 -1  -7 1 1 lamp
define shape triangle sheet 0 5 0  2 5 0  0 5 2 lamp
)";
  SceneBuffers const scene = compiled(text, TreeLayout::wide);
  auto const& chances = scene.shading.light_probabilities;
  REQUIRE(chances.size() == 5);  // environment, triangle, solids
  // Half the surface; of a triangle one side.
  double const surfaces[] = {0, 2, 2 * 3.14159265, 8 * 3.14159265, 12};
  double sum = 0;
  for (double const surface : surfaces) sum += surface;
  auto const solid = [&](int i) { return scene.emissive_solids[std::size_t(i)]; };
  CHECK(std::abs(chances[1] - surfaces[1] / sum) < 1e-5);
  for (int i = 0; i < 2; ++i) {
    double const surface = solid(i).axes[0][0] == 1 ? surfaces[2] : surfaces[3];
    CHECK(std::abs(chances[std::size_t(2 + i)] - surface / sum) < 1e-5);
  }
  CHECK(solid(2).kind == PRIMITIVE_BOX);
  CHECK(std::abs(chances[4] - surfaces[4] / sum) < 1e-5);
}

TEST_CASE("Triangles that shine are the same lamps in every layout", "[light]") {
  std::string text = materials;
  for (int i = 0; i < 50; ++i) {
    int const x = 37 * i % 50;
    text += fmt::format("define shape triangle t{0} {1} {2} 0  {3} {2} 0  {1} {4} {0} lamp\n", i, x, x % 7, x + 1,
                        x % 7 + 1);
  }
  auto const lamps = [&](TreeLayout layout) {
    std::vector<float> numbers;
    for (device::EmissiveTriangle const& lamp : compiled(text, layout).emissive_triangles) {
      numbers.insert(numbers.end(), lamp.corner, lamp.corner + 3);
      for (auto const& edge : lamp.edges) numbers.insert(numbers.end(), edge, edge + 3);
    }
    return numbers;
  };
  CHECK(lamps(TreeLayout::wide).size() == 50 * 9);
  CHECK(lamps(TreeLayout::wide) == lamps(TreeLayout::binary));
}

TEST_CASE("What is too large to be drawn is no lamp, and takes no light from others", "[light]") {
  std::string text = std::string(materials) + "define shape sphere huge 0 3e18 0 2e18 lamp\n";
  std::string children;
  for (int i = 0; i < 12; ++i) {  // so many that they are not baked
    text += fmt::format("define shape triangle t{0} {0} 0 0  {0} 1 0  {0} 0 1 lamp\n", i);
    text += fmt::format("define shape sphere s{0} {0} 0 4 0.5 lamp\ntransform s{0} scale 1 2 1\n", i);
    children += fmt::format(" t{0} s{0}", i);
  }
  text += "define shape composite group" + children +
          "\ndefine shape composite near group\ndefine shape composite far group\n"
          "transform far scale 1e20\ntransform far scale 1e20\n";
  for (TreeLayout const layout : {TreeLayout::wide, TreeLayout::binary}) {
    SceneBuffers const scene = compiled(text, layout);
    CHECK(scene.emissive_triangles.size() == 12);
    CHECK(scene.emissive_solids.size() == 12);
    REQUIRE(scene.shading.light_probabilities.size() == 25);
    double sum = 0;
    for (float const probability : scene.shading.light_probabilities) {
      CHECK(probability <= 0.2f);
      sum += probability;
    }
    CHECK(sum == Approx(1).epsilon(1e-5));
  }
}
