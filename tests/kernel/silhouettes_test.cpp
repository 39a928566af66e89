/// Where rays begin to miss what is round, in all layouts, against bodies that share no formula with the kernels.

#include <functional>
#include <iostream>

#include "layout_probe.hpp"
#include "lichtraum/shapes.hpp"
#include "scene/flatten.hpp"
#include "support/catch.hpp"
#include "support/convex_oracle.hpp"
#include "support/skip.hpp"

using namespace lichtraum;
using namespace lichtraum::test;

namespace {

/// What docs/RELIABILITY.md promises: which rays pass a silhouette is right for those that pass it by more than so many
/// roundings, of 2^-24 each, of the numbers that they are computed from (RoundShape::numbers).
constexpr double promised_roundings = 4;

using Body = std::function<long double(LongVec3 const&)>;

struct RoundShape {
  std::shared_ptr<Shape> shape;
  Vec3 center;
  double size;  ///< no point of it is farther from the center
  Body body;    ///< the distance from its surface; negative inside

  /// How large what a ray from there is computed with can be.
  double numbers(Vec3 const& origin) const { return size + glm::length(center) + glm::length(origin - center); }
};

enum class RoundKind { sphere, cylinder, cone };

/// As large as `size`, up to ten thousand times that away from the world's origin, and of any proportions.
RoundShape random_shape(RoundKind kind, double size, Random& random) {
  Vec3 const middle = size * std::pow(10., random.uniform(-2, 4)) * random.direction();
  auto const material = std::make_shared<Material>();
  if (kind == RoundKind::sphere) {
    return {std::make_shared<Sphere>("", middle, size, material), middle, size, sphere_body(middle, size)};
  }
  double const slimness = std::pow(10., random.uniform(-2, 2));
  double const radius = size / std::hypot(1., slimness);
  Vec3 const half = radius * slimness * random.direction();
  Vec3 const p1 = middle - half, p2 = middle + half;
  if (kind == RoundKind::cylinder) {
    return {std::make_shared<Cylinder>("", p1, p2, radius, material), middle, size, cylinder_body(p1, p2, radius)};
  }
  return {std::make_shared<Cone>("", p1, p2, radius, material), middle, size, cone_body(p1, p2, radius)};
}

long double least_of(RoundShape const& round, Vec3 const& origin, Vec3 const& direction) {
  return deepest_point({origin, direction}, round.center, 1.01 * round.size, round.body).least;
}

/// What is truly so of each of Rays.
struct Truth {
  std::vector<double> least;    ///< how far from the surface the line stays; negative if it hits
  std::vector<double> numbers;  ///< see RoundShape
};

/// Rays that hardly hit and hardly miss, from up to a million sizes away.
void add_silhouette(RoundShape const& round, Random& random, Rays& rays, Truth& truth) {
  // A ray's origin is floats: what is meant is the ray that the device gets.
  Vec3 const wanted = round.center + round.size * std::pow(10., random.uniform(0.1, 6)) * random.direction();
  Vec3 const origin = to_vec3(to_float4(wanted));
  double const unit = rounding_unit * round.numbers(origin);
  double edge = 0;
  Vec3 sideways;
  int left = 0;
  rays.add_packet(origin, [&] {
    if (left-- == 0) {
      left = 15;
      sideways = round.size * glm::normalize(glm::cross(round.center - origin, random.direction()));
      double hits = 0, misses = 4;
      for (int i = 0; i < 50; ++i) {
        edge = (hits + misses) / 2;
        (least_of(round, origin, round.center + edge * sideways - origin) <= 0 ? hits : misses) = edge;
      }
    }
    double const beyond = unit / round.size * std::pow(10., random.uniform(-0.5, 2)) * (random.index(2) == 0 ? 1 : -1);
    Vec3 const direction = round.center + (edge + beyond) * sideways - origin;
    truth.least.push_back(double(least_of(round, origin, to_vec3(to_float4(direction)))));
    truth.numbers.push_back(round.numbers(origin));
    return direction;
  });
}

/// By how many roundings rays pass, at most, of which the kernels say what is wrong.
double worst_roundings(RoundKind kind, std::size_t shapes, Random& random) {
  double worst = 0;
  std::size_t wrong = 0, near = 0;
  for (std::size_t i = 0; i < shapes; ++i) {
    RoundShape const round = random_shape(kind, std::pow(10., random.uniform(-3, 3)), random);
    Rays rays;
    Truth truth;
    for (int packet = 0; packet < 8; ++packet) add_silhouette(round, random, rays, truth);
    FlatScene const scene = flatten({round.shape});
    for (Traversal const traversal : all_layouts) {
      LayoutProbe const probe(scene, traversal);
      auto const closest = probe.closest(rays);
      auto const hidden = probe.hidden(rays, 1e6f);
      for (std::size_t k = 0; k < rays.size(); ++k) {
        double const roundings = std::abs(truth.least[k]) / (rounding_unit * truth.numbers[k]);
        bool const is_hit = truth.least[k] < 0;
        near += roundings < 2 * promised_roundings ? 1 : 0;
        if (std::isfinite(closest[k].t) == is_hit && (hidden[k] == 3) == is_hit) continue;
        ++wrong;
        worst = std::max(worst, roundings);
      }
    }
  }
  std::cout << "silhouettes: " << near << " rays near them, " << wrong << " wrong, by " << worst
            << " roundings at most\n";
  CHECK(near > shapes * 100);  // else nothing was tried
  return worst;
}

}  // namespace

TEST_CASE("silhouettes of spheres, cylinders and cones are where they belong, but for some roundings",
          "[kernel][layouts]") {
  NEEDS_OPENCL_DEVICE();
  Random random(70);
  for (RoundKind const kind : {RoundKind::sphere, RoundKind::cylinder, RoundKind::cone}) {
    INFO("kind " << int(kind));
    CHECK(worst_roundings(kind, scaled_count(60), random) < promised_roundings);
  }
}
