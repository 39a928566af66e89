#include "accel/bvh.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <set>

#include "support/catch.hpp"

using namespace lichtraum;

namespace {

DeviceBounds around(Vec3 const& center, double half) {
  DeviceBounds bounds;
  add_point(bounds, center - Vec3(half));
  add_point(bounds, center + Vec3(half));
  return bounds;
}

std::vector<BuildPrimitive> random_primitives(std::size_t count) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> coordinate(-100, 100);
  std::vector<BuildPrimitive> primitives;
  for (std::size_t i = 0; i < count; ++i) {
    Vec3 const center(coordinate(random), coordinate(random), coordinate(random));
    primitives.push_back({around(center, 0.5), {PRIMITIVE_SPHERE, device::uint(i)}});
  }
  return primitives;
}

bool contains(device::BvhChild const& outer, DeviceBounds const& inner) {
  for (int axis = 0; axis < 3; ++axis) {
    if (outer.min[axis] > inner.min[axis] || outer.max[axis] < inner.max[axis]) return false;
  }
  return true;
}

/// As build_bvh, of a copy: that reorders its argument.
Bvh build(std::vector<BuildPrimitive> primitives) { return build_bvh(primitives); }

struct Facts {
  std::size_t depth = 0;
  std::size_t largest_leaf = 0;
  std::multiset<device::uint> found;
};

/// Walks the whole tree; every primitive must lie in the bounds of each child on the way to it.
Facts check(Bvh const& bvh, std::vector<BuildPrimitive> const& primitives) {
  Facts facts;
  struct Open {
    device::uint node;
    std::vector<device::BvhChild> path;
  };
  std::vector<Open> open{{0, {}}};
  while (!open.empty()) {
    Open const top = open.back();
    open.pop_back();
    facts.depth = std::max(facts.depth, top.path.size() + 1);
    for (device::BvhChild const& child : bvh.nodes.at(top.node).children) {
      if (child.count == 0 && !(child.min[0] <= child.max[0])) continue;  // absent
      auto path = top.path;
      path.push_back(child);
      if (child.count == 0) {
        REQUIRE(child.first > top.node);  // depth-first order: no cycles
        open.push_back({child.first, path});
        continue;
      }
      facts.largest_leaf = std::max<std::size_t>(facts.largest_leaf, child.count);
      for (device::uint i = child.first; i < child.first + child.count; ++i) {
        auto const index = bvh.references.at(i).index;
        facts.found.insert(index);
        for (auto const& ancestor : path) {
          if (!contains(ancestor, primitives[index].bounds)) FAIL("a primitive sticks out of the bounds above it");
        }
      }
    }
  }
  return facts;
}

void require_each_once(Facts const& facts, std::size_t count) {
  REQUIRE(facts.found.size() == count);
  REQUIRE(std::set<device::uint>(facts.found.begin(), facts.found.end()).size() == count);
}

}  // namespace

TEST_CASE("a hierarchy holds every primitive once, within all bounds above it", "[unit][bvh]") {
  for (std::size_t const count : {1, 2, 3, 5, 17, 1000, 140'003}) {
    auto const primitives = random_primitives(count);
    Bvh const bvh = build(primitives);
    Facts const facts = check(bvh, primitives);
    require_each_once(facts, count);
    CHECK(facts.largest_leaf <= 4);
    CHECK(facts.depth <= BVH_MAX_DEPTH);
  }
}

TEST_CASE("the hierarchy of nothing has two absent children", "[unit][bvh]") {
  Bvh const bvh = build_bvh({});
  REQUIRE(bvh.nodes.size() == 1);
  for (auto const& child : bvh.nodes[0].children) {
    CHECK(child.count == 0);
    CHECK(child.min[0] > child.max[0]);
  }
  CHECK(bvh.bounds.is_empty());
}

TEST_CASE("a hierarchy of identical primitives is balanced", "[unit][bvh]") {
  std::vector<BuildPrimitive> primitives;
  for (device::uint i = 0; i < 150'000; ++i) primitives.push_back({around(Vec3(3), 1), {PRIMITIVE_TRIANGLE, i}});
  Facts const facts = check(build(primitives), primitives);
  require_each_once(facts, primitives.size());
  CHECK(facts.depth <= 17);
}

TEST_CASE("no input makes a hierarchy deeper than its limit", "[unit][bvh]") {
  // Distances grow so fast that a binned split takes off a few primitives at a time.
  auto const [count, growth] = GENERATE(std::pair(3000u, 1.02), std::pair(140'000u, 1.0005));
  std::vector<BuildPrimitive> primitives;
  for (device::uint i = 0; i < count; ++i) {
    Vec3 const center(std::pow(growth, double(i)), 0, 0);
    primitives.push_back({around(center, 1e-3 * center.x), {PRIMITIVE_SPHERE, i}});
  }
  Facts const facts = check(build(primitives), primitives);
  require_each_once(facts, primitives.size());
  CHECK(facts.depth <= BVH_MAX_DEPTH);
  CHECK(facts.depth > 20);  // it is a hard case
}

TEST_CASE("two builds of one scene, on threads, give the same tree", "[unit][bvh]") {
  auto const primitives = random_primitives(150'000);
  Bvh const first = build(primitives);
  require_each_once(check(first, primitives), primitives.size());
  Bvh const second = build(primitives);
  auto const same = [](device::BvhChild const& a, device::BvhChild const& b) {
    return a.first == b.first && a.count == b.count && std::equal(a.min, a.min + 3, b.min) &&
           std::equal(a.max, a.max + 3, b.max);
  };
  REQUIRE(first.nodes.size() == second.nodes.size());
  for (std::size_t i = 0; i < first.nodes.size(); ++i) {
    bool const equal = same(first.nodes[i].children[0], second.nodes[i].children[0]) &&
                       same(first.nodes[i].children[1], second.nodes[i].children[1]);
    if (!equal) FAIL("node " << i << " differs");
  }
}

TEST_CASE("what has no bounds stands beside the tree, where every ray meets it", "[unit][bvh]") {
  constexpr float far = std::numeric_limits<float>::max();
  DeviceBounds const everywhere{glm::vec3(-far), glm::vec3(far)};
  for (std::size_t const bounded : {0, 1, 3, 4, 5, 100, 20'000}) {
    for (device::uint const count : {1u, 2u, 3u, 40u}) {
      INFO(bounded << " with bounds, " << count << " without");
      std::vector<BuildPrimitive> all = random_primitives(bounded);
      std::vector<BuildPrimitive> unbounded;
      for (device::uint i = 0; i < count; ++i) {
        unbounded.push_back({DeviceBounds(), {PRIMITIVE_ELLIPSOID, device::uint(bounded) + i}});
      }
      unbounded[0].bounds = around(Vec3(500), 1);  // what in it is bounded
      std::vector<BuildPrimitive> copy = all;
      Bvh const alone = build(all);
      Bvh const bvh = build_bvh(copy, unbounded);
      for (BuildPrimitive primitive : unbounded) {
        primitive.bounds = everywhere;
        all.push_back(primitive);
      }
      Facts const facts = check(bvh, all);
      require_each_once(facts, all.size());
      CHECK(facts.largest_leaf <= 4);
      CHECK(facts.depth <= BVH_MAX_DEPTH);
      CHECK(bvh.bounds.max.x == 501);
      CHECK(bvh.bounds.min.x == (bounded == 0 ? 499 : alone.bounds.min.x));
      for (std::size_t node = 0; node < bvh.nodes.size(); ++node) {  // depth-first: a left child comes next
        device::BvhChild const& left = bvh.nodes[node].children[0];
        if (left.count == 0) CHECK(left.first == node + 1);
      }
    }
  }
}

TEST_CASE("a hierarchy with something beside it is as deep as any may be", "[unit][bvh]") {
  std::vector<BuildPrimitive> primitives;
  for (device::uint i = 0; i < 3000; ++i) {
    Vec3 const center(std::pow(1.02, double(i)), 0, 0);
    primitives.push_back({around(center, 1e-3 * center.x), {PRIMITIVE_SPHERE, i}});
  }
  std::vector<BuildPrimitive> const unbounded{{DeviceBounds(), {PRIMITIVE_ELLIPSOID, 3000}}};
  std::vector<BuildPrimitive> all = primitives;
  all.push_back({DeviceBounds{glm::vec3(0), glm::vec3(1)}, unbounded[0].reference});
  CHECK(check(build_bvh(primitives, unbounded), all).depth <= BVH_MAX_DEPTH);
}
