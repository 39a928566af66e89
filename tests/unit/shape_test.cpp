#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <optional>
#include <random>
#include <stdexcept>

#include "lichtraum/shapes.hpp"
#include "support/catch.hpp"

using namespace lichtraum;

namespace {

struct Expected {
  double t;
  Vec3 normal;
};

double closeness(Vec3 const& a, Vec3 const& b) { return glm::length(a - b); }

/// Seeded rays around the origin: from a cube of side 8, most towards the middle.
class RandomRays {
 public:
  explicit RandomRays(unsigned seed) : random_(seed) {}
  double number(double low, double high) { return std::uniform_real_distribution<double>(low, high)(random_); }
  Vec3 point(double reach) { return {number(-reach, reach), number(-reach, reach), number(-reach, reach)}; }
  Ray ray() {
    Vec3 const origin = point(4);
    return {origin, (point(1.5) - origin) * number(0.1, 3)};
  }
  Transform transform(int kind) {
    Vec3 axis = point(1);
    Transform t = Transform::translation(point(1));
    if (kind >= 1) t = t * Transform::rotation(number(-180, 180), axis);
    if (kind == 2) t = t * Transform::scaling(Vec3(number(0.3, 2)));
    if (kind >= 3) t = t * Transform::scaling({number(0.3, 2), number(0.3, 2), number(0.3, 2)});
    if (kind >= 4) t = t * Transform::scaling({-1, 1, 1});
    if (kind >= 5) t = t * Transform::rotation(number(-180, 180), point(1));  // a shear, with the scale before it
    return t;
  }

 private:
  std::mt19937_64 random_;
};

/// Sphere by the sign of |p - c| - r along the ray: the first sign change from the point nearest to the origin,
/// bisected.
std::optional<Expected> sphere_by_bisection(Ray const& ray, Vec3 const& center, double radius) {
  auto const signed_distance = [&](double t) { return glm::length(ray.at(t) - center) - radius; };
  double const middle =
      glm::dot(center - ray.origin, ray.direction) / glm::dot(ray.direction, ray.direction);  // nearest to the centre
  if (signed_distance(middle) > 0) return std::nullopt;
  double outside = middle - 2 * radius / glm::length(ray.direction), inside = middle;
  if (outside < 0 && signed_distance(0) < 0) {
    outside = middle + 2 * radius / glm::length(ray.direction);
  } else if (middle < 0) {
    return std::nullopt;
  }
  for (int i = 0; i < 200; ++i) {
    double const t = (outside + inside) / 2;
    (signed_distance(t) > 0 ? outside : inside) = t;
  }
  return Expected{inside, (ray.at(inside) - center) / radius};
}

/// Box by its six planes: the nearest point of a plane that lies within the face.
std::optional<Expected> box_by_planes(Ray const& ray, Vec3 const& min, Vec3 const& max) {
  std::optional<Expected> result;
  for (int axis = 0; axis < 3; ++axis) {
    for (double const side : {-1.0, 1.0}) {
      double const plane = side < 0 ? min[axis] : max[axis];
      double const t = (plane - ray.origin[axis]) / ray.direction[axis];
      Vec3 const p = ray.at(t);
      int const u = (axis + 1) % 3, v = (axis + 2) % 3;
      bool const within = p[u] >= min[u] && p[u] <= max[u] && p[v] >= min[v] && p[v] <= max[v];
      if (!(t > 0) || !within || (result && result->t <= t)) continue;
      Vec3 normal(0);
      normal[axis] = side;
      result = Expected{t, normal};
    }
  }
  return result;
}

/// Triangle by solving origin + t d = a + u (b - a) + v (c - a) with Cramer's rule.
std::optional<Expected> triangle_by_equations(Ray const& ray, std::array<Vec3, 3> const& corners) {
  Vec3 const ab = corners[1] - corners[0], ac = corners[2] - corners[0], to_origin = ray.origin - corners[0];
  double const det = glm::determinant(Mat3(-ray.direction, ab, ac));
  double const t = glm::determinant(Mat3(to_origin, ab, ac)) / det;
  double const u = glm::determinant(Mat3(-ray.direction, to_origin, ac)) / det;
  double const v = glm::determinant(Mat3(-ray.direction, ab, to_origin)) / det;
  if (!(t > 0 && u >= 0 && v >= 0 && u + v <= 1)) return std::nullopt;
  return Expected{t, glm::normalize(glm::cross(ab, ac))};
}

void check_against(Shape const& shape, Ray const& ray, std::optional<Expected> const& expected) {
  Hit hit;
  bool const found = shape.closest_hit(ray, 0, hit);
  float t = -1;
  REQUIRE(shape.intersect(ray, t) == found);
  REQUIRE(found == expected.has_value());
  if (!found) {
    REQUIRE(t == -1);
    return;
  }
  REQUIRE(hit.t == Approx(expected->t).epsilon(1e-9));
  REQUIRE(t == float(hit.t));
  REQUIRE(closeness(hit.normal, expected->normal) < 1e-6);
}

/// The expectation in the frame above `t`, from one in the frame below.
std::optional<Expected> lifted(Transform const& t, std::optional<Expected> expected) {
  if (expected) expected->normal = glm::normalize(t.normal(expected->normal));
  return expected;
}

Ray lowered(Transform const& t, Ray const& ray) {
  Transform const inverse = t.inverse();
  return {inverse.point(ray.origin), inverse.vector(ray.direction)};
}

}  // namespace

TEST_CASE("a sphere is hit where its surface is, under every kind of transform", "[unit][shape]") {
  int const kind = GENERATE(0, 1, 2, 3, 4, 5);
  RandomRays rays(unsigned(1 + kind));
  int hits = 0;
  for (int i = 0; i < 2000; ++i) {
    Vec3 const center = rays.point(1);
    double const radius = rays.number(0.2, 2);
    Sphere sphere("s", center, radius, nullptr);
    Transform const t = rays.transform(kind);
    sphere.set_world_from_object(t);
    Ray const ray = rays.ray();
    auto const expected = lifted(t, sphere_by_bisection(lowered(t, ray), center, radius));
    check_against(sphere, ray, expected);
    hits += expected.has_value();
  }
  CHECK(hits > 500);
}

TEST_CASE("a box is hit where its faces are, under every kind of transform", "[unit][shape]") {
  int const kind = GENERATE(0, 1, 2, 3, 4, 5);
  RandomRays rays(unsigned(11 + kind));
  int hits = 0;
  for (int i = 0; i < 2000; ++i) {
    Box box("b", rays.point(1.5), rays.point(1.5), nullptr);
    Transform const t = rays.transform(kind);
    box.set_world_from_object(t);
    Ray const ray = rays.ray();
    auto const expected = lifted(t, box_by_planes(lowered(t, ray), box.min(), box.max()));
    check_against(box, ray, expected);
    hits += expected.has_value();
  }
  CHECK(hits > 200);
}

TEST_CASE("a triangle is hit from both sides, under every kind of transform", "[unit][shape]") {
  int const kind = GENERATE(0, 1, 2, 3, 4, 5);
  RandomRays rays(unsigned(21 + kind));
  int hits = 0;
  for (int i = 0; i < 4000; ++i) {
    Triangle triangle("t", rays.point(2), rays.point(2), rays.point(2), nullptr);
    Transform const t = rays.transform(kind);
    triangle.set_world_from_object(t);
    Ray const ray = rays.ray();
    auto const expected = lifted(t, triangle_by_equations(lowered(t, ray), triangle.vertices()));
    check_against(triangle, ray, expected);
    hits += expected.has_value();
  }
  CHECK(hits > 200);
}

TEST_CASE("only hits between t_min and hit.t count, and a miss changes nothing", "[unit][shape]") {
  Sphere const sphere("s", {0, 0, 0}, 1, nullptr);
  Box const box("b", {-1, -1, -1}, {1, 1, 1}, nullptr);
  Ray const ray{{0, 0, 5}, {0, 0, -2}};  // enters at t = 2, leaves at t = 3
  for (Shape const* shape : {static_cast<Shape const*>(&sphere), static_cast<Shape const*>(&box)}) {
    Hit hit;
    REQUIRE(shape->closest_hit(ray, 0, hit));
    CHECK(hit.t == Approx(2));
    CHECK(hit.shape == shape);
    CHECK(hit.normal == Vec3(0, 0, 1));
    hit = {};
    REQUIRE(shape->closest_hit(ray, 2.5, hit));
    CHECK(hit.t == Approx(3));
    CHECK(hit.normal == Vec3(0, 0, -1));
    hit = {};
    CHECK(!shape->closest_hit(ray, 3, hit));
    CHECK(hit.shape == nullptr);
    hit.t = 2;
    CHECK(!shape->closest_hit(ray, 0, hit));
    CHECK(hit.shape == nullptr);
    CHECK(!shape->closest_hit({{0, 0, 5}, {0, 0, 2}}, 0, hit));  // behind
  }
}

TEST_CASE("rays from a sphere's or box's own surface leave it without a hit at their start", "[unit][shape]") {
  RandomRays rays(31);
  Sphere const sphere("s", {100, 0, 0}, 3, nullptr);
  for (int i = 0; i < 1000; ++i) {
    Vec3 const normal = glm::normalize(rays.point(1));
    Vec3 const start = Vec3(100, 0, 0) + 3 * (1 + 1e-13) * normal;
    Vec3 direction = rays.point(1);
    if (glm::dot(direction, normal) < 0) direction = -direction;
    Hit hit;
    REQUIRE(!sphere.closest_hit({start, direction}, 0, hit));
    REQUIRE(sphere.closest_hit({start, -direction}, 1e-9, hit));
    REQUIRE(glm::length(start - hit.t * direction - Vec3(100, 0, 0)) == Approx(3));
  }
}

TEST_CASE("a sphere far away and a huge one keep their digits", "[unit][shape]") {
  Sphere const far("far", {0, 0, -1e7}, 1, nullptr);
  Hit hit;
  REQUIRE(far.closest_hit({{0.6, 0, 0}, {0, 0, -1}}, 0, hit));
  CHECK(hit.t == Approx(1e7 - 0.8).epsilon(1e-15));
  CHECK(closeness(hit.normal, {0.6, 0, 0.8}) < 1e-8);
  CHECK(!far.closest_hit({{1.0001, 0, 0}, {0, 0, -1}}, 0, hit));

  Sphere const ground("ground", {0, -1e7, 0}, 1e7, nullptr);
  hit = {};
  REQUIRE(ground.closest_hit({{0, 1, 0}, {0, -1, 0}}, 0, hit));
  CHECK(hit.t == Approx(1).epsilon(1e-8));
}

TEST_CASE("a flat box is a rectangle", "[unit][shape]") {
  Box const floor("floor", {-1, 0, -1}, {1, 0, 1}, nullptr);
  Hit hit;
  REQUIRE(floor.closest_hit({{0.5, 2, 0.5}, {0, -1, 0}}, 0, hit));
  CHECK(hit.t == 2);
  CHECK(hit.normal == Vec3(0, 1, 0));
  hit = {};
  CHECK(floor.closest_hit({{0.5, -2, 0.5}, {0.1, 1, 0}}, 0, hit));
  CHECK(!floor.closest_hit({{1.5, 2, 0.5}, {0, -1, 0}}, 0, hit));
  CHECK(!floor.closest_hit({{-5, 0.1, 0}, {1, 0, 0}}, 0, hit));  // parallel, above
}

TEST_CASE("a ray along a box's face or edge is inside its slabs", "[unit][shape]") {
  Box const box("b", {-1, -1, -1}, {1, 1, 1}, nullptr);
  Hit hit;
  REQUIRE(box.closest_hit({{-5, 1, 0}, {1, 0, 0}}, 0, hit));
  CHECK(hit.t == 4);
  hit = {};
  REQUIRE(box.closest_hit({{-5, 1, 1}, {1, 0, -0.0}}, 0, hit));
  CHECK(hit.t == 4);
  CHECK(!box.closest_hit({{-5, std::nextafter(1.0, 2.0), 0}, {1, 0, 0}}, 0, hit));
}

TEST_CASE("a triangle without area is never hit", "[unit][shape]") {
  RandomRays rays(41);
  Triangle const point("point", {0, 0, 0}, {0, 0, 0}, {0, 0, 0}, nullptr);
  Triangle const line("line", {0.1, 0.1, 0.1}, {0.2, 0.2, 0.2}, {0.3, 0.3, 0.3}, nullptr);
  Triangle const edge("edge", {0, 0, 0}, {1, 0, 0}, {1, 0, 0}, nullptr);
  for (int i = 0; i < 1000; ++i) {
    double const along = rays.number(-1, 1);
    for (Triangle const* triangle : {&point, &line, &edge}) {
      Hit hit;
      Vec3 const origin = rays.point(3);
      REQUIRE(!triangle->closest_hit({origin, Vec3(along, along, along) - origin}, 0, hit));
      REQUIRE(!triangle->closest_hit({origin, -origin}, 0, hit));
    }
  }
}

TEST_CASE("no ray slips between triangles that share an edge", "[unit][shape]") {
  // A fan of eight triangles around a crooked centre; rays through points exactly on the shared edges, as far as
  // rounding lets them be.
  RandomRays rays(51);
  Vec3 const center(0.1, 0.2, 0.3);
  std::array<Vec3, 8> rim;
  for (std::size_t i = 0; i < 8; ++i) {
    double const angle = double(i) * M_PI / 4;
    rim[i] = {3 * std::cos(angle), 3 * std::sin(angle), rays.number(-0.3, 0.3)};
  }
  for (int i = 0; i < 20000; ++i) {
    Vec3 const target = center + rays.number(0, 0.9) * (rim[std::size_t(i) % 8] - center);
    Vec3 const origin(rays.number(-2, 2), rays.number(-2, 2), rays.number(5, 10));
    bool found = false;
    for (std::size_t k = 0; k < 8; ++k) {
      Hit hit;
      found |= Triangle("t", center, rim[k], rim[(k + 1) % 8], nullptr).closest_hit({origin, target - origin}, 0, hit);
    }
    REQUIRE(found);
  }
}

TEST_CASE("a ray with a NaN hits nothing", "[unit][shape]") {
  Sphere const sphere("s", {0, 0, 0}, 1, nullptr);
  Box const box("b", {-1, -1, -1}, {1, 1, 1}, nullptr);
  Triangle const triangle("t", {-1, -1, 0}, {1, -1, 0}, {0, 1, 0}, nullptr);
  Composite const group("g", {std::make_shared<Sphere>("in", Vec3(0), 1, nullptr)});
  double const nan = std::numeric_limits<double>::quiet_NaN();
  for (Shape const* shape : {static_cast<Shape const*>(&sphere), static_cast<Shape const*>(&box),
                             static_cast<Shape const*>(&triangle), static_cast<Shape const*>(&group)}) {
    for (int component = 0; component < 6; ++component) {
      Ray ray{{0, 0, 3}, {0, 0, -1}};
      (component < 3 ? ray.origin : ray.direction)[component % 3] = nan;
      Hit hit;
      INFO(*shape << ", component " << component);
      CHECK(!shape->closest_hit(ray, 0, hit));
    }
    Hit hit;
    CHECK(!shape->closest_hit({{0, 0, 3}, {0, 0, 0}}, 0, hit));  // no direction
  }
}

TEST_CASE("transforms of a shape apply in its parent's frame, in the order given", "[unit][shape]") {
  Sphere sphere("s", {1, 0, 0}, 1, nullptr);
  sphere.rotate(90, {0, 0, 1});  // centre to 0 1 0
  sphere.translate({5, 0, 0});   // 5 1 0
  sphere.scale(Vec3(2, 1, 1));   // 10 1 0
  CHECK(closeness(sphere.world_from_object().point({1, 0, 0}), {10, 1, 0}) < 1e-14);
  CHECK(closeness(sphere.object_from_world().point({10, 1, 0}), {1, 0, 0}) < 1e-14);
  sphere.set_world_from_object({});
  CHECK(sphere.world_from_object().is_identity());
  CHECK_THROWS_AS(sphere.scale(0), std::invalid_argument);
  CHECK_THROWS_AS(sphere.rotate(10, {0, 0, 0}), std::invalid_argument);
}

TEST_CASE("a sphere needs a positive radius", "[unit][shape]") {
  CHECK_THROWS_AS(Sphere("s", Vec3(0), 0, nullptr), std::invalid_argument);
  CHECK_THROWS_AS(Sphere("s", Vec3(0), -1, nullptr), std::invalid_argument);
  CHECK_THROWS_AS(Sphere("s", Vec3(0), std::nan(""), nullptr), std::invalid_argument);
}
