#include "io/polygon.hpp"

#include <cmath>
#include <glm/geometric.hpp>
#include <random>

#include "support/catch.hpp"

using namespace lichtraum;

namespace {

Vec3 to_vec3(Float3 const& p) { return {p[0], p[1], p[2]}; }

std::vector<std::array<std::uint32_t, 3>> cut(std::vector<Float3> const& corners) {
  std::vector<std::array<std::uint32_t, 3>> triangles;
  triangulate(corners, triangles);
  return triangles;
}

/// The sums of the triangles' vector areas and of their lengths: equal for plane polygons if none overlaps another.
std::pair<Vec3, double> areas(std::vector<Float3> const& corners) {
  Vec3 sum(0);
  double total = 0;
  for (auto const& t : cut(corners)) {
    Vec3 const area = 0.5 * glm::cross(to_vec3(corners[t[1]]) - to_vec3(corners[t[0]]),
                                       to_vec3(corners[t[2]]) - to_vec3(corners[t[0]]));
    sum += area;
    total += glm::length(area);
  }
  return {sum, total};
}

Vec3 vector_area(std::vector<Float3> const& corners) {
  Vec3 sum(0);
  for (std::size_t i = 0; i < corners.size(); ++i) {
    sum += 0.5 * glm::cross(to_vec3(corners[i]), to_vec3(corners[(i + 1) % corners.size()]));
  }
  return sum;
}

}  // namespace

TEST_CASE("polygons are cut into triangles that cover them once, in their sense of rotation", "[unit][polygon]") {
  std::mt19937 random(7);
  std::uniform_real_distribution<float> radius(0.2f, 1.0f);
  for (std::size_t count : {4u, 5u, 7u, 30u, 256u}) {
    for (int repetition = 0; repetition < 20; ++repetition) {
      // A star around the origin, in a plane that no axis is at right angles to.
      std::vector<Float3> corners;
      for (std::size_t i = 0; i < count; ++i) {
        float const angle = 6.2831853f * float(i) / float(count), r = radius(random);
        float const x = r * std::cos(angle), y = r * std::sin(angle);
        corners.push_back({x, y, 0.3f * x - 0.8f * y});
      }
      if (repetition % 2 == 1) std::reverse(corners.begin(), corners.end());
      INFO(count);
      CHECK(cut(corners).size() == count - 2);
      auto const [sum, total] = areas(corners);
      CHECK(glm::distance(sum, vector_area(corners)) < 1e-5);
      CHECK(total == Approx(glm::length(vector_area(corners))).epsilon(1e-4));
    }
  }
}

TEST_CASE("polygons that are none end in as many triangles all the same", "[unit][polygon]") {
  float const nan = std::nanf("");
  CHECK(cut({}).empty());
  CHECK(cut({{0, 0, 0}, {1, 0, 0}}).empty());
  CHECK(cut(std::vector<Float3>(9, {1, 2, 3})).size() == 7);
  CHECK(cut(std::vector<Float3>(6, {nan, nan, nan})).size() == 4);
  CHECK(cut({{0, 0, 0}, {1, 1, 0}, {1, 0, 0}, {0, 1, 0}, {2, 2, 0}}).size() == 3);  // crosses itself
  CHECK(cut(std::vector<Float3>(1000, {0, 0, 0})).size() == 998);
}

TEST_CASE("long thin polygons are cut along their inside, whatever corner they begin with", "[unit][polygon]") {
  std::vector<std::pair<std::string, std::vector<Float3>>> shapes;
  for (int const half : {32, 96, 128}) {  // corrugated sheets, seen from the side
    std::vector<Float3> sheet;
    float const heights[] = {0, 0, 1, 1};
    for (int i = 0; i < half; ++i) sheet.push_back({float(i), heights[i % 4], 0});
    for (int i = half - 1; i >= 0; --i) sheet.push_back({float(i), heights[i % 4] + 0.1f, 0});
    shapes.emplace_back("sheet", sheet);
    std::vector<Float3> spiral;
    auto const at = [&](int i, float width) {
      float const angle = 0.4f * float(i), radius = 1 + 0.1f * float(i) + width;
      return Float3{radius * std::cos(angle), radius * std::sin(angle), 0};
    };
    for (int i = 0; i < half; ++i) spiral.push_back(at(i, 0.5f));
    for (int i = half - 1; i >= 0; --i) spiral.push_back(at(i, 0));
    shapes.emplace_back("spiral", spiral);
  }
  for (auto& [name, corners] : shapes) {
    for (int start = 0; start < 8; ++start) {
      INFO(name << " of " << corners.size() << ", from " << start);
      auto const [sum, total] = areas(corners);
      CHECK(total == Approx(glm::length(vector_area(corners))).epsilon(1e-4));
      CHECK(glm::distance(sum, vector_area(corners)) < 1e-3 * total);
      std::rotate(corners.begin(), corners.begin() + std::ptrdiff_t(corners.size() / 8), corners.end());
    }
  }
}
