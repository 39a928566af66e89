/// What normal maps turn towards the light and away from the viewer, against the formulae in double precision.

#include <algorithm>
#include <glm/trigonometric.hpp>

#include "bsdf_probe.hpp"
#include "support/catch.hpp"
#include "support/skip.hpp"

using namespace lichtraum;
using namespace lichtraum::test;

namespace {

void check_fading(std::size_t lanes) {
  BsdfCase const matt{"matt", phong_bsdf(0.8, 0, 1)};
  BsdfCase const leaf{"leaf", translucent(phong_bsdf(0.8, 0, 1), 0.6)};
  BsdfCase const sheen{"sheen", with_sheen(phong_bsdf(0, 0, 1), 0.8, 0.5)};
  BsdfCase const metal{"metal", layered_bsdf(0.9, 1, 0.5)};
  std::size_t const count = std::max<std::size_t>(scaled_count(320), 64);  // of 64, some fade out in each case
  BsdfProbe const probe(lanes);
  Random random(71);
  for (BsdfCase const& surface : {matt, leaf, sheen, metal}) {
    for (double const tilt_degrees : {1., 20., 45., 80.}) {
      CAPTURE(lanes, surface.name, tilt_degrees);
      BsdfCase bumpy = surface;
      bumpy.smooth_normal = direction_at(glm::radians(tilt_degrees), 1.2);
      std::vector<float4> viewers, lights;
      for (std::size_t i = 0; i < count; ++i) {
        Vec3 const o = random.direction();
        viewers.push_back(to_float4({o.x, o.y, std::abs(o.z)}));
        lights.push_back(to_float4(random.direction()));
      }
      std::vector<float4> const flat = probe.evaluate(surface, viewers, lights);
      std::vector<float4> const actual = probe.evaluate(bumpy, viewers, lights);
      int faded = 0, hidden = 0, wrong = 0;
      for (std::size_t i = 0; i < lights.size(); ++i) {
        Vec3 const light = to_vec3(lights[i]);
        // Light that gets through comes from below both normals.
        double const share = bump_share(bumpy.smooth_normal, {0, 0, 1}, light);
        double const expected = surface.name == "metal" ? flat[i].x : share * flat[i].x;
        wrong += std::abs(actual[i].x - expected) > 1e-5 + 1e-5 * expected || actual[i].w != flat[i].w ? 1 : 0;
        faded += flat[i].x > 0 && share > 0 && share < 1 ? 1 : 0;
        hidden += flat[i].x > 0 && share == 0 ? 1 : 0;
      }
      CHECK(wrong == 0);
      CHECK(faded > 0);
      CHECK((tilt_degrees < 20 || hidden > 0));
    }
  }
}

void check_turned_coats(std::size_t lanes) {
  std::size_t const count = std::max<std::size_t>(scaled_count(160), 32);
  BsdfProbe const probe(lanes);
  Random random(72);
  for (double const viewer_degrees : {0., 40., 70., 88.}) {
    for (double const tilt_degrees : {5., 20., 45., 61., 80.}) {
      CAPTURE(lanes, viewer_degrees, tilt_degrees);
      Vec3 const viewer = viewer_at(viewer_degrees);
      double const tilt = glm::radians(tilt_degrees);
      Vec3 const away(-0.6 * std::sin(tilt), -0.8 * std::sin(tilt), std::cos(tilt));
      double const facing = glm::dot(away, viewer), least = viewer.z / 2;
      Vec3 const aside = glm::normalize(away - facing * viewer);
      Vec3 const turned = facing < least ? least * viewer + std::sqrt(1 - least * least) * aside : away;
      BsdfCase surface{"coat", coated(phong_bsdf(0, 0, 1), 1, 0.5)};
      std::vector<float4> const viewers(count, to_float4(viewer));
      std::vector<float4> lights;
      for (std::size_t i = 0; i < viewers.size(); ++i) lights.push_back(to_float4(random.direction()));
      surface.coat_normal = away;
      std::vector<float4> const actual = probe.evaluate(surface, viewers, lights);
      surface.coat_normal = turned;
      std::vector<float4> const expected = probe.evaluate(surface, viewers, lights);
      int lit = 0, wrong = 0;
      for (std::size_t i = 0; i < lights.size(); ++i) {
        lit += expected[i].x > 1e-3f ? 1 : 0;
        wrong += std::abs(actual[i].x - expected[i].x) > 1e-5 + 1e-4 * expected[i].x ? 1 : 0;
      }
      CHECK(lit > 0);
      CHECK(wrong == 0);
    }
  }
}

}  // namespace

TEST_CASE("what is matt fades out towards the smooth surface's horizon, and gloss does not", "[kernel]") {
  NEEDS_OPENCL_DEVICE();
  check_fading(1);
}

TEST_CASE("what is matt fades out towards the horizon in each of sixteen lanes", "[kernel][layouts]") {
  NEEDS_OPENCL_DEVICE();
  check_fading(16);
}

TEST_CASE("a coat's normal that faces away is turned to the viewer, half as much as the surface", "[kernel]") {
  NEEDS_OPENCL_DEVICE();
  check_turned_coats(1);
}

TEST_CASE("a coat's normal that faces away is turned in each of sixteen lanes", "[kernel][layouts]") {
  NEEDS_OPENCL_DEVICE();
  check_turned_coats(16);
}
