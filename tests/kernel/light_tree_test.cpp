/// Lights chosen from a tree: as often as is said, and by what they bring to a point.

#include <fmt/format.h>

#include <map>

#include "compile/light_tree.hpp"
#include "primitives.hpp"
#include "reference.hpp"
#include "scene_arrays.hpp"
#include "support/catch.hpp"
#include "support/opencl_probe.hpp"
#include "support/skip.hpp"

using namespace lichtraum;
using namespace lichtraum::test;

namespace {

constexpr double diagonal = 20;

/// Panels and points, in clusters; each tenth is a hundred times as bright.
std::vector<LightLeaf> random_lights(std::size_t count, Random& random) {
  std::vector<LightLeaf> lights;
  Vec3 cluster(0);
  for (std::size_t i = 0; i < count; ++i) {
    if (i % 8 == 0) cluster = random.in_cube(5);
    LightLeaf light;
    Vec3 const middle = cluster + random.in_cube(0.4);
    light.normal = i % 3 == 0 ? Vec3(0) : random.direction();
    light.bounds.add(middle);
    if (i % 3 != 0) {  // a square as large as its normal lets it be
      Vec3 const across = glm::normalize(glm::cross(light.normal, random.direction()));
      for (double const side : {-0.1, 0.1}) light.bounds.add(middle + side * across);
    }
    light.intensity = random.uniform(0.2, 1) * (i % 10 == 0 ? 100 : 1);
    light.number = device::uint(1000 + i);
    lights.push_back(light);
  }
  return lights;
}

struct Point {
  Vec3 position, normal;
};

/// What the light brings to a point, as if it all were in its middle.
double irradiance(LightLeaf const& light, Point const& point) {
  Vec3 const way = light.bounds.center() - point.position;
  double const distance = glm::length(way);
  double const sent = light.normal == Vec3(0) ? 1 : std::abs(glm::dot(light.normal, way)) / distance;
  double const received = point.normal == Vec3(0) ? 1 : std::max(glm::dot(point.normal, way) / distance, 0.0);
  return light.intensity * sent * received / (distance * distance);
}

struct Choices {
  std::vector<device::uint> numbers;
  std::vector<std::array<float, 2>> chances;  // probability, importance
};

Choices choose(std::vector<LightLeaf> const& lights, std::vector<Point> const& points,
               std::vector<float> const& choices, int lanes) {
  SceneArrays scene;
  scene.light_tree = make_light_tree(lights, diagonal);
  std::vector<float4> positions, normals;
  for (Point const& point : points) {
    positions.push_back(to_float4(point.position));
    normals.push_back(to_float4(point.normal));
  }
  Choices chosen{std::vector<device::uint>(points.size()), std::vector<std::array<float, 2>>(points.size())};
  ProbeProgram("light_tree.cl", fmt::format("-D LANES={}", lanes))
      .run("probe_choose", points.size() / std::size_t(lanes),
           scene.arguments({in(positions), in(normals), in(choices), out(chosen.numbers), out(chosen.chances)}));
  return chosen;
}

/// So many choices for one point, evenly spread.
Choices choose_evenly(std::vector<LightLeaf> const& lights, Point const& point, std::size_t count) {
  std::vector<float> choices;
  for (std::size_t i = 0; i < count; ++i) choices.push_back(float((double(i) + 0.5) / double(count)));
  return choose(lights, std::vector<Point>(count, point), choices, 1);
}

}  // namespace

TEST_CASE("A light tree chooses each light as often as it says", "[kernel][statistics]") {
  NEEDS_OPENCL_DEVICE();
  Random random(91);
  std::size_t const count = scaled_count(1 << 16);
  for (std::size_t const light_count : {1u, 16u, 17u, 700u}) {
    std::vector<LightLeaf> const lights = random_lights(light_count, random);
    for (int i = 0; i < 6; ++i) {
      Point const point{i % 2 == 0 ? random.in_cube(6) : lights.front().bounds.center() + random.in_cube(0.3),
                        i % 3 == 0 ? Vec3(0) : random.direction()};
      Choices const chosen = choose_evenly(lights, point, count);
      std::map<device::uint, std::size_t> times;
      std::map<device::uint, float> probabilities;
      std::size_t lost = 0;  // where a ball is partly above the surface, and the lights in it are not
      for (std::size_t k = 0; k < count; ++k) {
        if (!(chosen.chances[k][0] > 0)) {
          ++lost;
          continue;
        }
        ++times[chosen.numbers[k]];
        auto const [known, is_new] = probabilities.insert({chosen.numbers[k], chosen.chances[k][0]});
        if (!is_new && known->second != chosen.chances[k][0]) FAIL("a light has two probabilities");
      }
      double sum = 0;
      for (auto const& [number, n] : times) {
        double const expected = probabilities[number] * double(count);
        INFO(light_count << " lights, point " << i << ": light " << number << " was chosen " << n << " times");
        // Each has one interval of the even choices; roundings move its ends.
        if (std::abs(double(n) - expected) > 2 + 1e-4 * double(count)) FAIL("expected " << expected);
        sum += probabilities[number];
      }
      INFO(light_count << " lights, point " << i << ": " << lost << " of " << count << " choices lost");
      // Those that none of the choices met are missing.
      if (count > 10000) CHECK(std::abs(sum + double(lost) / double(count) - 1) < 0.002);
      if (point.normal == Vec3(0)) CHECK(lost == 0);
    }
  }
}

TEST_CASE("A light tree chooses by what lights bring", "[kernel][statistics]") {
  NEEDS_OPENCL_DEVICE();
  Random random(92);
  std::size_t const count = scaled_count(1 << 16);
  std::vector<LightLeaf> const lights = random_lights(700, random);
  double total_intensity = 0;
  for (LightLeaf const& light : lights) total_intensity += light.intensity;
  double spread = 0, spread_by_intensity = 0;
  constexpr int point_count = 30;
  for (int i = 0; i < point_count; ++i) {
    Point point{random.in_cube(6), random.direction()};
    if (glm::dot(point.normal, point.position) > 0) point.normal = -point.normal;  // most lights are before it
    double total = 0;
    for (LightLeaf const& light : lights) total += irradiance(light, point);
    Choices const chosen = choose_evenly(lights, point, count);
    // The estimate's variance, relative to its square: of one light's irradiance over its probability.
    double squares = 0;
    for (std::size_t k = 0; k < count; ++k) {
      if (!(chosen.chances[k][0] > 0)) continue;
      double const estimate = irradiance(lights[chosen.numbers[k] - 1000], point) / chosen.chances[k][0];
      squares += estimate * estimate / double(count);
    }
    spread += (squares / (total * total) - 1) / point_count;
    double squares_by_intensity = 0;
    for (LightLeaf const& light : lights) {
      double const brings = irradiance(light, point);
      squares_by_intensity += brings * brings * total_intensity / light.intensity;
    }
    spread_by_intensity += (squares_by_intensity / (total * total) - 1) / point_count;
  }
  INFO("variance " << spread << ", by intensity alone " << spread_by_intensity);
  if (count > 10000) {
    CHECK(spread < 0.6);
    CHECK(spread < 0.2 * spread_by_intensity);
  }
}

TEST_CASE("A light tree says about how much light there is", "[kernel]") {
  NEEDS_OPENCL_DEVICE();
  Random random(95);
  std::vector<LightLeaf> const lights = random_lights(700, random);
  double total_intensity = 0;
  for (LightLeaf const& light : lights) total_intensity += light.intensity;
  std::vector<Point> points;
  for (int i = 0; i < 200; ++i) points.push_back({random.in_cube(12), Vec3(0)});
  Choices const chosen = choose(lights, points, std::vector<float>(points.size(), 0.5f), 1);
  for (std::size_t i = 0; i < points.size(); ++i) {
    double expected = 0;
    for (LightLeaf const& light : lights) expected += irradiance(light, points[i]);
    double const importance = total_intensity * chosen.chances[i][1];
    INFO("point " << i << ": importance " << importance << ", irradiance " << expected);
    if (!(importance > 0.3 * expected && importance < 3 * expected)) FAIL("too far from it");
  }
}

TEST_CASE("A light tree's lanes are as if alone", "[kernel][lanes]") {
  NEEDS_OPENCL_DEVICE();
  Random random(93);
  std::size_t const count = 16 * std::max<std::size_t>(scaled_count(512), 1);
  std::vector<LightLeaf> const lights = random_lights(300, random);
  std::vector<Point> points;
  std::vector<float> choices;
  for (std::size_t i = 0; i < count; ++i) {
    points.push_back({random.in_cube(6), i % 5 == 0 ? Vec3(0) : random.direction()});
    choices.push_back(i % 7 == 0 ? -1.f : float(0.999999 * random.uniform()));
  }
  Choices const alone = choose(lights, points, choices, 1), together = choose(lights, points, choices, 16);
  for (std::size_t i = 0; i < count; ++i) {
    if (choices[i] < 0) {
      if (together.chances[i][0] != 0) FAIL("a lane that was not asked for");
    } else if (alone.numbers[i] != together.numbers[i] || alone.chances[i] != together.chances[i]) {
      FAIL("point " << i);
    }
  }
}

TEST_CASE("A light tree has no lights for what is behind a surface, or out of reach", "[kernel]") {
  NEEDS_OPENCL_DEVICE();
  Random random(94);
  std::vector<LightLeaf> const lights = random_lights(100, random);
  std::vector<Point> const points{{{0, 0, 30}, {0, 0, 1}},
                                  {{0, 0, 30}, {0, 0, -1}},
                                  {{0, 0, 30}, {0, 0, 0}},
                                  {{1e30, 0, 0}, {0, 0, 0}},
                                  {lights[0].bounds.center(), {0, 0, 0}}};
  Choices const chosen = choose(lights, points, std::vector<float>(points.size(), 0.99999994f), 1);
  CHECK(chosen.chances[0][0] == 0);
  CHECK(chosen.chances[0][1] == 0);
  CHECK(chosen.chances[1][0] > 0);
  CHECK(chosen.chances[2][0] > 0);
  CHECK(chosen.chances[3][0] == 0);
  CHECK(chosen.chances[4][0] > 0);
  CHECK(std::isfinite(chosen.chances[4][1]));
}

TEST_CASE("A triangle that shines has the world's area, also as an instance", "[kernel]") {
  NEEDS_OPENCL_DEVICE();
  Random random(96);
  Vec3 const a = random.in_cube(2), b = random.in_cube(2), c = random.in_cube(2);
  SceneArrays scene;
  scene.add(make_triangle(a, b, c));
  auto const [object, bounds] = scene.close_object();
  std::vector<double> expected{0.5 * glm::length(glm::cross(b - a, c - a))};
  for (int i = 0; i < 50; ++i) {
    Vec3 const sizes(random.uniform(0.1, 3), random.uniform(0.1, 3), i % 2 == 0 ? -1 : 2);
    Mat3 const stretched(sizes.x, 0, 0, 0, sizes.y, 0, 0, 0, sizes.z);
    Affine const world_from_object{random.rotation() * stretched * random.rotation(), random.in_cube(5)};
    scene.add_instance(world_from_object, object, bounds);
    auto const edge = [&](Vec3 const& tip) { return world_from_object.linear * (tip - a); };
    expected.push_back(0.5 * glm::length(glm::cross(edge(b), edge(c))));
  }
  scene.close_object();
  std::vector<float> areas(expected.size());
  ProbeProgram("light_tree.cl", "-D LANES=1").run("probe_area", areas.size(), scene.arguments({out(areas)}));
  for (std::size_t i = 0; i < areas.size(); ++i) {
    INFO("area " << i << " is " << areas[i]);
    if (std::abs(areas[i] - expected[i]) > 1e-5 * expected[i]) FAIL("expected " << expected[i]);
  }
}
