#include <random>

#include "lichtraum/shapes.hpp"
#include "support/catch.hpp"

using namespace lichtraum;

namespace {

std::shared_ptr<MeshGeometry> square() {
  auto geometry = std::make_shared<MeshGeometry>();
  geometry->positions = {{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}};
  geometry->indices = {0, 1, 2, 0, 2, 3};
  return geometry;
}

}  // namespace

TEST_CASE("a mesh is hit where its triangles are", "[unit]") {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> uniform(-1, 1);
  auto geometry = std::make_shared<MeshGeometry>();
  std::vector<std::unique_ptr<Triangle>> triangles;
  auto const transform =
      Transform::translation({1, 2, 3}) * Transform::rotation(40, {1, 2, -1}) * Transform::scaling({-1, 2, 0.5});
  for (std::uint32_t i = 0; i < 60; ++i) {
    for (int corner = 0; corner < 3; ++corner) {
      geometry->positions.push_back({float(uniform(random)), float(uniform(random)), float(uniform(random))});
      geometry->indices.push_back(3 * i + std::uint32_t(corner));
    }
    auto const [a, b, c] = geometry->triangle(i);
    triangles.push_back(std::make_unique<Triangle>("t", a, b, c, nullptr));
    triangles.back()->apply(transform);
  }
  Mesh mesh("m", geometry, nullptr);
  mesh.apply(transform);
  int hits = 0;
  for (int i = 0; i < 500; ++i) {
    Vec3 const center(1, 2, 3);
    Vec3 const origin = center + 4.0 * Vec3(uniform(random), uniform(random), uniform(random));
    Ray const ray{origin, center - origin + 0.5 * Vec3(uniform(random), uniform(random), uniform(random))};
    Hit expected;
    for (auto const& triangle : triangles) triangle->closest_hit(ray, 0.01, expected);
    Hit hit;
    REQUIRE(mesh.closest_hit(ray, 0.01, hit) == (expected.shape != nullptr));
    REQUIRE(hit.t == expected.t);
    if (!hit.shape) continue;
    ++hits;
    REQUIRE(hit.shape == &mesh);
    REQUIRE(hit.normal == expected.normal);
  }
  REQUIRE(hits > 50);
}

TEST_CASE("a flat mesh is hit by a ray in the direction of an axis", "[unit]") {
  Mesh const mesh("square", square(), nullptr);
  float t = 0;
  REQUIRE(mesh.intersect({{0.5, 0.25, 3}, {0, 0, -1}}, t));
  REQUIRE(t == 3.f);
  REQUIRE(mesh.intersect({{1, 1, 3}, {0, 0, -1}}, t));  // on the corner
  REQUIRE_FALSE(mesh.intersect({{1.001, 0, 3}, {0, 0, -1}}, t));
  REQUIRE_FALSE(mesh.intersect({{0, 0, 3}, {0, 0, 1}}, t));
}

TEST_CASE("a mesh without triangles is never hit", "[unit]") {
  Mesh const mesh("nothing", std::make_shared<MeshGeometry>(), nullptr);
  float t = 0;
  REQUIRE_FALSE(mesh.intersect({{0, 0, 3}, {0, 0, -1}}, t));
}

TEST_CASE("a mesh refuses a geometry that would read past its end", "[unit]") {
  auto const make = [](auto change) {
    auto geometry = square();
    change(*geometry);
    return Mesh("m", geometry, nullptr);
  };
  REQUIRE_THROWS_AS(Mesh("m", nullptr, nullptr), std::invalid_argument);
  REQUIRE_THROWS_AS(make([](MeshGeometry& g) { g.indices[5] = 4; }), std::invalid_argument);
  REQUIRE_THROWS_AS(make([](MeshGeometry& g) { g.indices.pop_back(); }), std::invalid_argument);
  REQUIRE_THROWS_AS(make([](MeshGeometry& g) { g.normals.resize(3); }), std::invalid_argument);
  REQUIRE_THROWS_AS(make([](MeshGeometry& g) { g.texcoords = {{}, {{0, 0}}}; }), std::invalid_argument);
  REQUIRE_NOTHROW(make([](MeshGeometry& g) { g.colors.resize(4); }));
}

TEST_CASE("positions that no triangle names do not make a mesh larger", "[unit]") {
  auto geometry = square();
  geometry->positions.push_back({100, 100, 100});
  CHECK(geometry->bounds().max == Vec3(1, 1, 0));
  CHECK(Mesh("mesh", geometry, nullptr).bounds().max == Vec3(1, 1, 0));
  geometry->indices.clear();  // points
  CHECK(geometry->bounds().max == Vec3(100));
}
