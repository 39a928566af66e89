/// Every layout of the tree finds what the scalar one finds, to the last bit.

#include <map>

#include "layout_probe.hpp"
#include "support/catch.hpp"
#include "support/skip.hpp"

using namespace lichtraum;
using namespace lichtraum::test;

namespace {

std::size_t count_different(std::vector<LayoutHit> const& a, std::vector<LayoutHit> const& b) {
  std::size_t different = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    bool const same = a[i].t == b[i].t && a[i].shape == b[i].shape && a[i].instance == b[i].instance;
    if (!same && different++ < 3) {
      UNSCOPED_INFO("ray " << i << ": t " << a[i].t << " and " << b[i].t << ", shape " << a[i].shape << " and "
                           << b[i].shape);
    }
  }
  return different;
}

}  // namespace

TEST_CASE("wide and packet find the scalar layout's hits, to the last bit", "[kernel][layouts]") {
  NEEDS_OPENCL_DEVICE();
  Rays const rays = mixed_rays(5, scaled_count(2000));
  auto const expected = LayoutProbe(mixed_scene(1), Traversal::scalar).closest(rays);
  std::size_t hits = 0;
  for (LayoutHit const& hit : expected) hits += std::isfinite(hit.t) ? 1 : 0;
  if (rays.size() > 10000) CHECK(hits > rays.size() / 4);
  if (rays.size() > 10000) CHECK(hits < rays.size());
  for (Traversal const traversal : {Traversal::wide, Traversal::packet}) {
    CHECK(count_different(LayoutProbe(mixed_scene(1), traversal).closest(rays), expected) == 0);
  }
}

TEST_CASE("wide and packet agree with the scalar layout on what is hidden, also by glass", "[kernel][layouts]") {
  NEEDS_OPENCL_DEVICE();
  Rays const rays = mixed_rays(6, scaled_count(1000));
  auto const expected = LayoutProbe(mixed_scene(2), Traversal::scalar).hidden(rays, 0.5f);
  std::map<device::uint, std::size_t> kinds;
  for (device::uint const h : expected) ++kinds[h];
  if (rays.size() > 10000) CHECK(kinds[0] > 100);
  if (rays.size() > 10000) CHECK(kinds[1] > 100);
  if (rays.size() > 10000) CHECK(kinds[3] > 100);
  for (Traversal const traversal : {Traversal::wide, Traversal::packet}) {
    CHECK((LayoutProbe(mixed_scene(2), traversal).hidden(rays, 0.5f) == expected));
  }
}

TEST_CASE("what a ray of a packet hits does not depend on the others", "[kernel][layouts]") {
  NEEDS_OPENCL_DEVICE();
  Rays rays = mixed_rays(7, scaled_count(200));
  LayoutProbe const probe(mixed_scene(1), Traversal::packet);
  auto const together = probe.closest(rays);
  Random random(1);
  for (float4& direction : rays.directions) direction.w = random.index(8) == 0 ? 1.f : 0.f;
  auto const few = probe.closest(rays);
  std::size_t different = 0;
  for (std::size_t i = 0; i < rays.size(); ++i) {
    bool const same = few[i].t == together[i].t && few[i].shape == together[i].shape;
    different += rays.directions[i].w > 0 && !same ? 1 : 0;
    if (rays.directions[i].w == 0) different += std::isfinite(few[i].t) ? 1 : 0;
  }
  CHECK(different == 0);
}

TEST_CASE("a ray hits among others in turn what it hits alone", "[kernel][layouts]") {
  NEEDS_OPENCL_DEVICE();
  Rays rays = mixed_rays(8, scaled_count(400));
  Random random(1);
  for (float4& direction : rays.directions) {
    if (random.index(50) == 0) direction = random.index(2) == 0 ? float4{} : float4{float_nan, 1, 1, 0};  // no rays
  }
  auto const expected = LayoutProbe(mixed_scene(1), Traversal::wide).closest(rays);
  for (Traversal const traversal : {Traversal::wide, Traversal::packet}) {
    CHECK(count_different(LayoutProbe(mixed_scene(1), traversal).closest_in_turn(rays), expected) == 0);
  }
}

TEST_CASE("as much light gets through to a ray among others in turn as alone", "[kernel][layouts]") {
  NEEDS_OPENCL_DEVICE();
  Rays const rays = mixed_rays(9, scaled_count(400));
  for (Traversal const traversal : {Traversal::wide, Traversal::packet}) {
    LayoutProbe const probe(mixed_scene(1), traversal);
    for (float const t_max : {0.3f, 20.f}) {
      auto const expected = LayoutProbe(mixed_scene(1), Traversal::wide).visibility(rays, t_max);
      CHECK(probe.visibility_in_turn(rays, t_max) == expected);
      if (rays.size() < 1000) continue;
      CHECK(std::ranges::count(expected, 0.f) > 10);
      CHECK(std::ranges::count(expected, 1.f) > 10);
      CHECK(std::ranges::count_if(expected, [](float share) { return share > 0 && share < 1; }) > 10);
    }
  }
}
