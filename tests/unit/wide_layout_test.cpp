#include "accel/wide_layout.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <set>

#include "support/catch.hpp"

using namespace lichtraum;

namespace {

/// Small cubes around random points, of kinds that take turns.
std::vector<BuildPrimitive> random_primitives(std::size_t count, std::vector<device::uint> const& kinds) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> coordinate(-10, 10);
  std::vector<BuildPrimitive> primitives;
  for (std::size_t i = 0; i < count; ++i) {
    Vec3 const center(coordinate(random), coordinate(random), coordinate(random));
    DeviceBounds bounds;
    add_point(bounds, center - Vec3(0.3));
    add_point(bounds, center + Vec3(0.3));
    primitives.push_back({bounds, {kinds[i % kinds.size()], device::uint(i)}});
  }
  return primitives;
}

/// Finds every primitive below the root, each within the bounds of its leaf. Fails where a block is met twice or has
/// members of several kinds.
std::multiset<device::uint> find_all(WideBvh const& wide, Bvh const& bvh,
                                     std::vector<BuildPrimitive> const& primitives) {
  std::multiset<device::uint> found;
  std::set<device::uint> visited;  // child words: nodes and blocks
  std::vector<device::uint> open{0};
  while (!open.empty()) {
    device::WideNode const& node = wide.nodes.at(open.back());
    open.pop_back();
    for (int lane = 0; lane < WIDE_CHILDREN; ++lane) {
      if (!(node.bounds[WIDE_MIN_X][lane] <= node.bounds[WIDE_MAX_X][lane])) continue;  // absent
      device::uint const kind = node.children[lane] >> WIDE_INDEX_BITS;
      device::uint const index = node.children[lane] & WIDE_INDEX_MASK;
      if (!visited.insert(node.children[lane]).second) FAIL("a child of two nodes");
      if (kind == WIDE_KIND_NODE) {
        open.push_back(index);
        continue;
      }
      std::vector<device::uint> members{index};
      if (kind == PRIMITIVE_TRIANGLE || kind == PRIMITIVE_SPHERE) {
        auto const& blocks = kind == PRIMITIVE_SPHERE ? wide.sphere_blocks : wide.triangle_blocks;
        WideBvh::Block const block = blocks.at(index);
        if (block.count < 1 || block.count > BLOCK_LANES) FAIL("a block of " << block.count);
        members.clear();
        for (device::uint i = block.first; i < block.first + block.count; ++i) {
          if (bvh.references.at(i).kind != kind) FAIL("a block of several kinds");
          members.push_back(bvh.references[i].index);
        }
      }
      for (device::uint const member : members) {
        found.insert(member);
        DeviceBounds const& bounds = primitives.at(member).bounds;
        for (int axis = 0; axis < 3; ++axis) {
          if (bounds.min[axis] < node.bounds[2 * axis][lane] || bounds.max[axis] > node.bounds[2 * axis + 1][lane]) {
            FAIL("a primitive sticks out of its leaf");
          }
        }
      }
    }
  }
  return found;
}

}  // namespace

TEST_CASE("the wide layout holds every primitive once, triangles and spheres in blocks of their own", "[unit][bvh]") {
  std::vector<std::vector<device::uint>> const mixtures{
      {PRIMITIVE_SPHERE},
      {PRIMITIVE_TRIANGLE},
      {PRIMITIVE_SPHERE, PRIMITIVE_TRIANGLE},
      {PRIMITIVE_BOX, PRIMITIVE_SPHERE, PRIMITIVE_SPHERE, PRIMITIVE_TRIANGLE, PRIMITIVE_ELLIPSOID},
  };
  for (auto const& kinds : mixtures) {
    for (std::size_t const count : {1, 2, 4, 5, 40, 1000}) {
      auto const primitives = random_primitives(count, kinds);
      auto reordered = primitives;
      Bvh const bvh = build_bvh(reordered);
      WideBvh const wide = collapse(bvh);
      auto const found = find_all(wide, bvh, primitives);
      CHECK(found.size() == count);
      CHECK(std::set(found.begin(), found.end()).size() == count);
    }
  }
}

TEST_CASE("blocks are more than half full where all are of one kind", "[unit][bvh]") {
  std::size_t const count = 10'000;
  auto spheres = random_primitives(count, {PRIMITIVE_SPHERE}),
       triangles = random_primitives(count, {PRIMITIVE_TRIANGLE});
  CHECK(collapse(build_bvh(spheres)).sphere_blocks.size() < count / 2);
  CHECK(collapse(build_bvh(triangles)).triangle_blocks.size() < count / 2);
}

TEST_CASE("in a wide node leaves come first, then the largest nodes", "[unit][bvh]") {
  auto primitives = random_primitives(20000, {PRIMITIVE_SPHERE, PRIMITIVE_TRIANGLE, PRIMITIVE_BOX});
  WideBvh const wide = collapse(build_bvh(primitives));
  std::size_t mixed = 0, wrong = 0;
  for (device::WideNode const& node : wide.nodes) {
    auto const is_leaf = [&](int lane) { return node.children[lane] >> WIDE_INDEX_BITS != WIDE_KIND_NODE; };
    auto const is_present = [&](int lane) { return node.bounds[WIDE_MIN_X][lane] <= node.bounds[WIDE_MAX_X][lane]; };
    auto const area = [&](int lane) {
      auto const size = [&](unsigned row) {
        return double(node.bounds[row + 1][lane]) - double(node.bounds[row][lane]);
      };
      double const x = size(WIDE_MIN_X), y = size(WIDE_MIN_Y), z = size(WIDE_MIN_Z);
      return x * y + y * z + z * x;
    };
    for (int lane = 1; lane < WIDE_CHILDREN && is_present(lane); ++lane) {
      mixed += is_leaf(lane) != is_leaf(lane - 1) ? 1 : 0;
      bool const is_right = is_leaf(lane) == is_leaf(lane - 1) ? area(lane) <= area(lane - 1) : is_leaf(lane - 1);
      wrong += is_right ? 0 : 1;
    }
  }
  CHECK(mixed > 0);  // there are nodes of both
  CHECK(wrong == 0);
}

TEST_CASE("a stack has room for what waits on the way to the deepest node, and to the deepest instance",
          "[unit][bvh]") {
  auto primitives = random_primitives(20000, {PRIMITIVE_SPHERE, PRIMITIVE_INSTANCE, PRIMITIVE_TRIANGLE});
  Bvh const bvh = build_bvh(primitives);
  WideBvh const alone = collapse(bvh);
  // What waits: each child but the one that is visited, or two words for them all.
  std::vector<std::size_t> waiting(alone.nodes.size());  // above a node, then with those of its own
  std::vector<std::size_t> at_instance(primitives.size());
  for (std::size_t n = 0; n < alone.nodes.size(); ++n) {  // depth first: a node comes before those below it
    device::WideNode const& node = alone.nodes[n];
    std::ptrdiff_t const present = std::count_if(node.bounds[WIDE_MIN_X], node.bounds[WIDE_MIN_X] + WIDE_CHILDREN,
                                                 [](float min_x) { return std::isfinite(min_x); });
    waiting[n] += present == 1 ? 0 : present == 2 ? 2 : std::size_t(present - 1);
    for (std::ptrdiff_t lane = 0; lane < present; ++lane) {
      device::uint const kind = node.children[lane] >> WIDE_INDEX_BITS;
      device::uint const index = node.children[lane] & WIDE_INDEX_MASK;
      if (kind == WIDE_KIND_NODE) waiting.at(index) = waiting[n];
      if (kind == PRIMITIVE_INSTANCE) at_instance.at(index) = waiting[n];
    }
  }
  std::size_t const deepest = *std::max_element(waiting.begin(), waiting.end());
  CHECK(alone.stack_size == deepest);
  std::vector<std::size_t> below(primitives.size(), 1);
  std::size_t shallowest_instance = 1;
  for (std::size_t i = 1; i < at_instance.size(); i += 3) {
    if (at_instance[i] < at_instance[shallowest_instance]) shallowest_instance = i;
  }
  REQUIRE(at_instance[shallowest_instance] + 10 < deepest);
  below[shallowest_instance] = 10;  // hidden by what is deeper
  std::size_t expected = deepest;
  for (std::size_t i = 1; i < at_instance.size(); i += 3) expected = std::max(expected, at_instance[i] + below[i]);
  CHECK(collapse(bvh, below).stack_size == expected);
  below[shallowest_instance] = 1000;
  CHECK(collapse(bvh, below).stack_size == at_instance[shallowest_instance] + 1000);
}

TEST_CASE("what stands beside the tree costs no wide node, if it is not too much", "[unit][bvh]") {
  constexpr float far = std::numeric_limits<float>::max();
  for (device::uint const beside : {1u, 3u, 40u}) {
    for (std::size_t const count : {0, 1, 3, 1000}) {
      INFO(beside << " beside " << count);
      auto primitives = random_primitives(count, {PRIMITIVE_SPHERE, PRIMITIVE_TRIANGLE});
      std::vector<BuildPrimitive> unbounded;
      for (device::uint i = 0; i < beside; ++i) unbounded.push_back({{}, {PRIMITIVE_BOX, device::uint(count) + i}});
      auto reordered = primitives;
      std::size_t const nodes_alone = collapse(build_bvh(reordered)).nodes.size();
      reordered = primitives;
      Bvh const bvh = build_bvh(reordered, unbounded);
      WideBvh const wide = collapse(bvh);
      for (BuildPrimitive primitive : unbounded) {
        primitive.bounds = {glm::vec3(-far), glm::vec3(far)};
        primitives.push_back(primitive);
      }
      auto const found = find_all(wide, bvh, primitives);
      CHECK(found.size() == count + beside);
      CHECK(std::set(found.begin(), found.end()).size() == count + beside);
      CHECK(wide.stack_size <= WIDE_STACK_SIZE);
      if (beside > WIDE_CHILDREN) continue;
      CHECK(wide.nodes.size() <= nodes_alone + 1);
      auto const* children = wide.nodes[0].children;
      CHECK(std::count_if(children, children + WIDE_CHILDREN,
                          [](device::uint child) { return child >> WIDE_INDEX_BITS == PRIMITIVE_BOX; }) == beside);
    }
  }
}
