#include "lichtraum/transform.hpp"

#include <stdexcept>

#include "support/catch.hpp"

using namespace lichtraum;

namespace {

double distance(Vec3 const& a, Vec3 const& b) { return glm::length(a - b); }

}  // namespace

TEST_CASE("a product of transforms applies the right factor first", "[unit][transform]") {
  Transform const t = Transform::translation({10, 0, 0}) * Transform::rotation(90, {0, 0, 1});
  CHECK(distance(t.point({1, 0, 0}), {10, 1, 0}) < 1e-14);
  CHECK(distance(t.vector({1, 0, 0}), {0, 1, 0}) < 1e-14);
}

TEST_CASE("rotations are right-handed", "[unit][transform]") {
  CHECK(distance(Transform::rotation(90, {0, 0, 2}).point({1, 0, 0}), {0, 1, 0}) < 1e-15);
  CHECK(distance(Transform::rotation(90, {0.5, 0, 0}).point({0, 1, 0}), {0, 0, 1}) < 1e-15);
  CHECK(distance(Transform::rotation(90, {0, 1e-200, 0}).point({0, 0, 1}), {1, 0, 0}) < 1e-15);
  CHECK(distance(Transform::rotation(360e6 + 90, {0, 0, 1}).point({1, 0, 0}), {0, 1, 0}) < 1e-15);
  CHECK_THROWS_AS(Transform::rotation(90, {0, 0, 0}), std::invalid_argument);
}

TEST_CASE("the inverse is composed, so extreme scales lose nothing", "[unit][transform]") {
  Transform t;
  for (int i = 0; i < 20; ++i) {
    t = Transform::rotation(37, {1, 2, 3}) * Transform::scaling({1e-6, 1e-6, -1e-6}) * t;
  }
  // 1e-120 to the power of three: no determinant of this matrix can be computed.
  Vec3 const p(0.25, -7, 3);
  CHECK(distance(t.inverse().point(t.point(p)), p) < 1e-12);
  CHECK(glm::length(t.point({1, 0, 0})) == Approx(1e-120).epsilon(1e-12));
  CHECK(Transform().is_identity());
  CHECK(!Transform::scaling({1, 1, -1}).is_identity());
}

TEST_CASE("normals stay perpendicular to what they were perpendicular to", "[unit][transform]") {
  Transform const t = Transform::rotation(30, {1, 1, 0}) * Transform::scaling({1, 5, -0.2});
  Vec3 const n = t.normal({1, 1, 1});
  CHECK(std::abs(glm::dot(n, t.vector({1, -1, 0}))) < 1e-12);
  CHECK(std::abs(glm::dot(n, t.vector({0, 1, -1}))) < 1e-12);
  CHECK(glm::dot(n, t.vector({1, 1, 1})) > 0);  // outward stays outward, also mirrored
}

TEST_CASE("a transform without an inverse is refused", "[unit][transform]") {
  CHECK_THROWS_AS(Transform::scaling({1, 0, 1}), std::invalid_argument);
  CHECK_THROWS_AS(Transform::scaling({1, NAN, 1}), std::invalid_argument);
  CHECK_THROWS_AS(Transform::scaling({1, 1, -INFINITY}), std::invalid_argument);
  CHECK_THROWS_AS(Transform::from_matrix(Mat4(0)), std::invalid_argument);
  Mat4 flat(1);
  flat[2][2] = 0;
  CHECK_THROWS_AS(Transform::from_matrix(flat), std::invalid_argument);
  Mat4 singular(1);  // 1 to 9: its rounded determinant is not 0
  for (int i = 0; i < 9; ++i) singular[i % 3][i / 3] = i + 1;
  CHECK_THROWS_AS(Transform::from_matrix(singular), std::invalid_argument);
  Mat4 const thin = Transform::scaling({1e-10, 1, 1e-10}).matrix();
  CHECK(Transform::from_matrix(thin).inverse_matrix()[0][0] == Approx(1e10));
  Mat4 projective(1);
  projective[0][3] = 0.5;
  CHECK_THROWS_AS(Transform::from_matrix(projective), std::invalid_argument);
  Mat4 tiny(1e-120);
  tiny[3] = {1, 2, 3, 1};
  Transform const t = Transform::from_matrix(tiny);
  CHECK(distance(t.inverse().vector({1e-120, -2e-120, 0}), {1, -2, 0}) < 1e-14);
  CHECK(distance(t.inverse().point({1, 2, 3}), {0, 0, 0}) == 0);
}

TEST_CASE("look_along points -z along the direction and keeps +y in the plane of up", "[unit][transform]") {
  Vec3 const eye(3, -4, 5);
  Transform const t = Transform::look_along(eye, {2, 0, 0}, {0.3, 7, 0});
  CHECK(distance(t.point({0, 0, 0}), eye) < 1e-14);
  CHECK(distance(t.vector({0, 0, -1}), {1, 0, 0}) < 1e-14);
  CHECK(distance(t.vector({0, 1, 0}), {0, 1, 0}) < 1e-14);
  CHECK(distance(t.vector({1, 0, 0}), {0, 0, 1}) < 1e-14);
  CHECK(distance(t.inverse().point(t.point({1, 2, 3})), {1, 2, 3}) < 1e-13);
  CHECK(Transform::look_along({0, 0, 0}, {0, 0, -1}, {0, 1, 0}).is_identity());
  CHECK_THROWS_AS(Transform::look_along(eye, {0, 0, 0}, {0, 1, 0}), std::invalid_argument);
  CHECK_THROWS_AS(Transform::look_along(eye, {0, -3, 0}, {0, 1, 0}), std::invalid_argument);
}
