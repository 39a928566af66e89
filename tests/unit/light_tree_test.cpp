/// The shape of light trees: each light is in it once, and each ball holds what is below it.

#include "compile/light_tree.hpp"

#include <cmath>
#include <functional>
#include <numeric>
#include <set>

#include "compile/scene_buffers.hpp"
#include "lichtraum/light.hpp"
#include "support/catch.hpp"

using namespace lichtraum;

namespace {

LightLeaf light_at(Vec3 const& place, device::uint number, double intensity = 1) {
  LightLeaf light;
  light.bounds.add(place);
  light.intensity = intensity;
  light.number = number;
  return light;
}

/// Calls visit(node, lane) for each child, and returns the numbers of the lights.
std::multiset<device::uint> walk(BigVector<device::LightTreeNode> const& tree,
                                 std::function<void(device::LightTreeNode const&, int)> const& visit) {
  std::multiset<device::uint> numbers;
  for (device::LightTreeNode const& node : tree) {
    for (int lane = 0; lane < LIGHT_TREE_CHILDREN; ++lane) {
      if (!(node.intensity[lane] > 0)) continue;
      visit(node, lane);
      device::uint const child = node.children[lane];
      if (child & LIGHT_TREE_LEAF) numbers.insert(child & ~LIGHT_TREE_LEAF);
    }
  }
  return numbers;
}

double sum_of(float const (&values)[LIGHT_TREE_CHILDREN]) {
  double sum = 0;
  for (float const value : values) sum += value;
  return sum;
}

}  // namespace

TEST_CASE("Light trees hold each light once, in balls that enclose it", "[light_tree]") {
  for (std::size_t const count : {1u, 2u, 16u, 17u, 1000u}) {
    std::vector<LightLeaf> lights;
    for (std::size_t i = 0; i < count; ++i) {
      double const angle = 2.4 * double(i);
      LightLeaf light =
          light_at(Vec3(std::cos(angle), 0.01 * double(i), std::sin(angle)), device::uint(i + 5), 1 + double(i % 7));
      light.bounds.add(light.bounds.min + Vec3(0.1, 0.2, 0.05));
      lights.push_back(light);
    }
    auto const tree = make_light_tree(lights, 10);
    CHECK(std::abs(sum_of(tree[0].intensity) - 1) < 1e-6);
    auto const numbers = walk(tree, [&](device::LightTreeNode const& node, int lane) {
      device::uint const child = node.children[lane];
      auto const holds = [&](Vec3 const& point) {
        Vec3 const center(node.center[0][lane], node.center[1][lane], node.center[2][lane]);
        return glm::distance(center, point) <= node.radius[lane] * (1 + 1e-5);
      };
      if (child & LIGHT_TREE_LEAF) {
        LightLeaf const& light = lights[(child & ~LIGHT_TREE_LEAF) - 5];
        CHECK((holds(light.bounds.min) && holds(light.bounds.max)));
      } else {
        REQUIRE(child < tree.size());
        CHECK(std::abs(sum_of(tree[child].intensity) - node.intensity[lane]) < 1e-6 * node.intensity[lane]);
        // Balls of boxes within a box may stick out of its ball, their middles not.
        for (int i = 0; i < LIGHT_TREE_CHILDREN; ++i) {
          if (!(tree[child].intensity[i] > 0)) continue;
          CHECK(holds({tree[child].center[0][i], tree[child].center[1][i], tree[child].center[2][i]}));
        }
      }
    });
    REQUIRE(numbers.size() == count);
    CHECK(std::set<device::uint>(numbers.begin(), numbers.end()).size() == count);
  }
}

TEST_CASE("Lights in one place, and far apart, become a tree", "[light_tree]") {
  std::vector<LightLeaf> lights;
  for (device::uint i = 0; i < 300; ++i) lights.push_back(light_at(Vec3(1, 2, 3), i));
  CHECK(walk(make_light_tree(lights, 1), [](auto const&, int) {}).size() == 300);
  lights.clear();
  for (device::uint i = 0; i < 300; ++i) lights.push_back(light_at(Vec3(std::pow(1.1, i), 0, 0), i, std::pow(0.9, i)));
  CHECK(walk(make_light_tree(lights, 1e12), [](auto const&, int) {}).size() == 300);
}

TEST_CASE("Light trees know how flat lights are turned", "[light_tree]") {
  std::vector<LightLeaf> lights;
  for (device::uint i = 0; i < 40; ++i) {
    LightLeaf light = light_at(Vec3(i, 0, 0), i);
    light.normal = i % 2 == 0 ? Vec3(0, 1, 0) : Vec3(0, -1, 0);  // the same to lights that shine to both sides
    lights.push_back(light);
  }
  walk(make_light_tree(lights, 40), [](device::LightTreeNode const& node, int lane) {
    CHECK(std::abs(node.axis[1][lane]) == 1);
    CHECK(node.spread[lane] == 0);
  });
  lights[7].normal = Vec3(0);
  auto const tree = make_light_tree(lights, 40);
  int any_way = 0;
  walk(tree, [&](device::LightTreeNode const& node, int lane) { any_way += node.spread[lane] == 1; });
  CHECK(any_way >= 1);
  CHECK(any_way <= 3);  // of the light and of what is above it
}

TEST_CASE("Lights that fall off are chosen from a tree where they are many, or not alone", "[light_tree]") {
  auto const compile = [](int count, bool has_sun) {
    Registry<Light> lights;
    if (has_sun) {
      lights.insert(Light::directional("sun", {0, -1, 0}, Rgb(1)));
      lights.insert(Light::point("as bright anywhere", {0, 1, 0}, Rgb(3)));
    }
    for (int i = 0; i < count; ++i) lights.insert(Light::falling_off("light" + std::to_string(i), Vec3(i), Rgb(0.5)));
    FlatScene scene;
    scene.objects.emplace_back();
    return compile_scene(std::move(scene), lights, TreeLayout::wide);
  };
  struct Case {
    int count;
    bool has_sun, has_tree;
  };
  for (Case const c : {Case{0, true, false},
                       {1, true, true},
                       {65, true, true},
                       {1, false, false},
                       {64, false, false},
                       {65, false, true}}) {
    INFO(c.count << (c.has_sun ? " lights beside others" : " lights"));
    SceneBuffers const scene = compile(c.count, c.has_sun);
    auto const& chances = scene.shading.light_probabilities;
    auto const constants = scene_constants(scene, scene.shading);
    std::size_t const others = c.has_sun ? 2 : 0;
    CHECK(scene.shading.light_choices.size() == chances.size());
    CHECK(chances.size() == others + std::size_t(c.count) + 1);
    bool const has_choices = c.has_sun || !c.has_tree;
    CHECK(std::abs(std::accumulate(chances.begin(), chances.end(), 0.0) - (has_choices ? 1 : 0)) < 1e-5);
    CHECK(scene.shading.light_tree.empty() == !c.has_tree);
    if (!c.has_tree) {
      CHECK(constants.distant_importance < 0);
      continue;
    }
    if (c.has_sun) CHECK(chances[0] == 0.25f);
    CHECK(chances[others] == 0);
    // What sun and constant light bring anywhere, over what the tree brings to a distance of 1.
    CHECK(constants.distant_importance == Approx(c.has_sun ? 4 / (0.5 * c.count) : 0));
    CHECK(walk(scene.shading.light_tree, [](auto const&, int) {}).size() == std::size_t(c.count));
  }
}
