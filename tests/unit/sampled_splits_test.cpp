#include "accel/sampled_splits.hpp"

#include <algorithm>
#include <limits>
#include <random>

#include "support/catch.hpp"

using namespace lichtraum;

namespace {

constexpr float infinity = std::numeric_limits<float>::infinity();

/// Points, more of them near the origin.
std::vector<BuildPrimitive> crowded_points(device::uint count) {
  std::mt19937 random(3);
  std::exponential_distribution<float> distance(1);
  std::vector<BuildPrimitive> points;
  for (device::uint i = 0; i < count; ++i) {
    glm::vec3 const point(distance(random), distance(random), distance(random));
    points.push_back({{point, point}, {PRIMITIVE_SPHERE, i}});
  }
  return points;
}

LaneBounds bounds_of(std::vector<BuildPrimitive> const& primitives) {
  LaneBounds bounds;
  for (BuildPrimitive const& primitive : primitives) bounds.add(LaneBounds(primitive));
  return bounds;
}

/// The points [first, last) of each node.
struct Spans {
  SampledSplits const& splits;
  std::vector<std::size_t> const& first;

  std::size_t begin(std::uint32_t number) const { return first[number]; }
  std::size_t end(std::uint32_t number) const {
    while (!splits.is_cell(number)) number = splits.children(number)[1];
    return first[number + 1];
  }
};

}  // namespace

TEST_CASE("sampled splits sort all primitives into cells that a plane parts", "[unit][bvh]") {
  auto const points = crowded_points(300'003);
  SampledSplits const splits(points, bounds_of(points));
  std::vector<BuildPrimitive> sorted(points.size());
  auto const first = splits.sort_into_cells(points, sorted);
  REQUIRE(first.size() == splits.size() + 1);
  CHECK(first.front() == 0);
  CHECK(first.back() == points.size());
  CHECK(splits.size() > 100);

  std::vector<bool> is_found(points.size());
  for (BuildPrimitive const& point : sorted) is_found.at(point.reference.index) = true;
  CHECK(std::count(is_found.begin(), is_found.end(), true) == std::ptrdiff_t(points.size()));

  Spans const spans{splits, first};
  std::size_t largest_cell = 0, unparted = 0, empty = 0;
  for (std::uint32_t number = 0; number < splits.size(); ++number) {
    if (splits.is_cell(number)) {
      largest_cell = std::max(largest_cell, first[number + 1] - first[number]);
      empty += first[number + 1] == first[number];
      continue;
    }
    auto const [left, right] = splits.children(number);
    CHECK(left == number + 1);
    CHECK(spans.end(left) == spans.begin(right));
    bool is_parted = false;
    for (int axis = 0; axis < 3; ++axis) {
      float most = -infinity, least = infinity;
      for (std::size_t i = spans.begin(left); i < spans.end(left); ++i)
        most = std::max(most, sorted[i].bounds.min[axis]);
      for (std::size_t i = spans.begin(right); i < spans.end(right); ++i) {
        least = std::min(least, sorted[i].bounds.min[axis]);
      }
      is_parted = is_parted || most < least;
    }
    unparted += !is_parted;
  }
  CHECK(unparted == 0);
  CHECK(empty == 0);
  CHECK(largest_cell < 2000);  // of one in nine, fewer than 64 are in a cell
}

TEST_CASE("primitives that no split parts are one cell, in their order", "[unit][bvh]") {
  std::vector<BuildPrimitive> same;
  for (device::uint i = 0; i < 20'000; ++i) same.push_back({{glm::vec3(1), glm::vec3(2)}, {PRIMITIVE_SPHERE, i}});
  SampledSplits const splits(same, bounds_of(same));
  REQUIRE(splits.size() == 1);
  CHECK(splits.is_cell(0));
  std::vector<BuildPrimitive> sorted(same.size());
  CHECK(splits.sort_into_cells(same, sorted) == std::vector<std::size_t>{0, same.size()});
  CHECK(std::ranges::equal(
      same, sorted, {}, [](auto const& p) { return p.reference.index; },
      [](auto const& p) { return p.reference.index; }));
}

TEST_CASE("sampled splits part what is large from what is small, however few are large", "[unit][bvh]") {
  // Walls whose middle is among the points. One in nine of all is looked at, but none of these for its number.
  std::vector<BuildPrimitive> primitives = crowded_points(300'000);
  std::vector<device::uint> walls;
  for (device::uint i = 0; i < 9; ++i) {
    device::uint const number = 30'000 * i + 1;
    float const at = 0.1f * float(i + 1);
    primitives[number].bounds = {glm::vec3(at, -10, -10), glm::vec3(at, 11, 11)};
    walls.push_back(number);
  }
  SampledSplits const splits(primitives, bounds_of(primitives));
  std::vector<BuildPrimitive> sorted(primitives.size());
  auto const first = splits.sort_into_cells(primitives, sorted);
  std::size_t beside_walls = 0;
  for (std::uint32_t number = 0; number < splits.size(); ++number) {
    bool const has_wall =
        std::any_of(sorted.begin() + std::ptrdiff_t(first[number]), sorted.begin() + std::ptrdiff_t(first[number + 1]),
                    [&](BuildPrimitive const& p) { return std::ranges::count(walls, p.reference.index) > 0; });
    if (splits.is_cell(number) && has_wall) beside_walls += first[number + 1] - first[number];
  }
  CHECK(beside_walls < 700);
}
