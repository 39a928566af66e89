#include "random_scene.hpp"
#include "support/catch.hpp"
#include "support/skip.hpp"

using namespace lichtraum;
using namespace lichtraum::test;

namespace {

/// Rays through a random scene, with what testing every primitive in double precision says of them.
struct RandomRays {
  SceneArrays scene;
  std::vector<ProbeRay> rays;
  std::vector<float> t_max;

  RandomRays(std::uint64_t seed, double scale, std::vector<float> const& transmits, std::size_t count) {
    Random random(seed);
    scene = make_random_scene(random, scale, transmits);
    for (std::size_t i = 0; i < count; ++i) {
      Vec3 const origin = random.in_cube(8 * scale);
      Vec3 direction = random.in_cube(4 * scale) - origin;
      if (i % 7 == 0) direction[int(random.index(3))] = 0;  // parallel to the bounds' faces
      rays.push_back({to_float4(origin), to_float4(direction * std::pow(10., random.uniform(-2, 2)))});
      double const reach = i % 2 == 0 ? infinity : random.uniform(0, 2) * glm::length(origin) / max_abs(direction);
      t_max.push_back(float(reach));
    }
  }

  /// The scene's crossings of a ray in front of it and before t_max, nearest first; nothing when roundings could decide
  /// about one of them (an edge, an end of the ray, two surfaces at the same place).
  std::optional<std::vector<std::pair<double, SceneCrossing>>> reference(std::size_t i) const {
    constexpr double unclear = 2e-5;
    std::vector<std::pair<double, SceneCrossing>> surfaces;
    double const unit = glm::length(to_vec3(rays[i].origin)) / glm::length(to_vec3(rays[i].direction));
    for (auto const& c : cross_all(scene, rays[i])) {
      if (std::abs(c.crossing.margin) < unclear) return std::nullopt;
      if (!c.crossing.hit()) continue;
      for (double const t : {c.crossing.t_enter, c.crossing.t_leave}) {
        if (std::abs(t) < unclear * unit || std::abs(t - t_max[i]) < unclear * unit) return std::nullopt;
        bool const second_of_triangle = c.kind == PRIMITIVE_TRIANGLE && !surfaces.empty() && surfaces.back().first == t;
        if (t > 0 && t < t_max[i] && !second_of_triangle) surfaces.push_back({t, c});
      }
    }
    std::sort(surfaces.begin(), surfaces.end(), [](auto const& a, auto const& b) { return a.first < b.first; });
    if (surfaces.size() > 1 && surfaces[1].first - surfaces[0].first < unclear * unit) return std::nullopt;
    return surfaces;
  }
};

}  // namespace

TEST_CASE("The closest hit is that of testing every primitive", "[kernel]") {
  NEEDS_OPENCL_DEVICE();
  double const scale = GENERATE(1e-3, 1., 1e6);
  RandomRays const cases(40, scale, {0.f}, scaled_count(20000));
  std::vector<ProbeHit> hits(cases.rays.size());
  ProbeProgram("traversal.cl")
      .run("probe_trace_closest", cases.rays.size(),
           cases.scene.arguments({in(cases.rays), in(cases.t_max), out(hits)}));
  std::array<std::size_t, 5> found{};
  std::size_t misses = 0, unclear = 0;
  for (std::size_t i = 0; i < hits.size(); ++i) {
    auto const expected = cases.reference(i);
    if (!expected) {
      ++unclear;
      continue;
    }
    INFO("ray " << i << ": kind " << hits[i].kind << " index " << hits[i].index << " instance " << hits[i].instance
                << " t " << hits[i].t);
    if (expected->empty()) {
      ++misses;
      if (hits[i].kind != none || hits[i].t != cases.t_max[i]) FAIL("hit where there is nothing");
      continue;
    }
    auto const& [t, surface] = expected->front();
    if (hits[i].kind != surface.kind || hits[i].index != surface.index || hits[i].instance != surface.instance) {
      FAIL("another primitive: kind " << surface.kind << " index " << surface.index << " instance " << surface.instance
                                      << " t " << t);
    }
    double const length = glm::length(to_vec3(cases.rays[i].direction));
    if (std::abs(hits[i].t - t) * length > 2e-5 * 14 * scale) FAIL("distance " << t);
    ++found[surface.kind];
    found[PRIMITIVE_INSTANCE] += surface.instance != none;
  }
  if (hits.size() >= 20000) {
    for (std::size_t kind_hits : found) CHECK(kind_hits > 200);
    CHECK(misses > 1000);
  }
  CHECK(unclear <= 2 + hits.size() / 50);
}

TEST_CASE("Any hit and visibility are those of testing every primitive", "[kernel]") {
  NEEDS_OPENCL_DEVICE();
  std::vector<float> const transmits{0.f, 0.5f, 1.f, 0.9f, 0.25f};
  RandomRays const cases(41, 1, transmits, scaled_count(20000));
  std::vector<device::uint> found(cases.rays.size());
  std::vector<float> visibility(cases.rays.size());
  ProbeProgram const program("traversal.cl");
  program.run("probe_trace_any", found.size(), cases.scene.arguments({in(cases.rays), in(cases.t_max), out(found)}));
  // Groups of one: what all work-items of a group hold is on one thread's stack.
  program.run("probe_trace_visibility", found.size(),
              cases.scene.arguments({in(cases.rays), in(cases.t_max), out(visibility)}), 1, 1, 1);
  std::size_t dark = 0, dimmed = 0, clear = 0, unclear = 0;
  for (std::size_t i = 0; i < found.size(); ++i) {
    auto const expected = cases.reference(i);
    if (!expected) {
      ++unclear;
      continue;
    }
    double product = 1;
    for (auto const& [t, surface] : *expected) product *= double(transmits[surface.material]);
    INFO("ray " << i << ": visibility " << visibility[i] << ", expected " << product);
    if ((found[i] != 0) != !expected->empty()) FAIL("any hit");
    if (std::abs(visibility[i] - product) > 1e-5 * product) FAIL("visibility");
    ++(product == 0 ? dark : product == 1 ? clear : dimmed);
  }
  if (found.size() >= 20000) {
    CHECK(dark > 1000);
    CHECK(dimmed > 1000);
    CHECK(clear > 1000);
  }
  CHECK(unclear <= 2 + found.size() / 50);
}

TEST_CASE("Scenes without anything, and rays that are none, hit nothing", "[kernel]") {
  NEEDS_OPENCL_DEVICE();
  float const inf = float_infinity, nan = float_nan;
  SceneArrays empty, full;
  empty.close_object();
  full.add(make_sphere(Vec3(0), 1));
  full.close_object();
  std::vector<ProbeRay> const rays{
      {{0, 0, -3, 0}, {0, 0, 1, 0}},  {{nan, 0, 0, 0}, {0, 0, 1, 0}},  {{0, 0, -3, 0}, {nan, 0, 1, 0}},
      {{0, 0, -3, 0}, {0, 0, 0, 0}},  {{0, 0, -inf, 0}, {0, 0, 1, 0}}, {{0, 0, -3, 0}, {0, 0, inf, 0}},
      {{0, 0, -3, 0}, {0, 0, -1, 0}},
  };
  std::vector<float> const t_max(rays.size(), inf);
  std::vector<ProbeHit> hits(rays.size());
  ProbeProgram const program("traversal.cl");
  program.run("probe_trace_closest", rays.size(), empty.arguments({in(rays), in(t_max), out(hits)}));
  for (auto const& hit : hits) CHECK(hit.kind == none);
  program.run("probe_trace_closest", rays.size(), full.arguments({in(rays), in(t_max), out(hits)}));
  CHECK(hits[0].kind == PRIMITIVE_SPHERE);
  for (std::size_t i = 1; i < hits.size(); ++i) CHECK(hits[i].kind == none);
}

TEST_CASE("The slab test never misses, and enters nothing but what it nearly hits", "[kernel]") {
  NEEDS_OPENCL_DEVICE();
  Random random(42);
  std::size_t const count = scaled_count(100000);
  std::vector<device::BvhChild> children(count);
  std::vector<ProbeRay> rays;
  std::vector<float> t_max, t(count);
  for (std::size_t i = 0; i < count; ++i) {
    double const scale = std::array{1e-3, 1., 1e6}[i % 3];
    Vec3 const low = random.in_cube(scale), size = random.in_cube(scale);
    for (int k = 0; k < 3; ++k) {
      children[i].min[k] = float(low[k]);
      children[i].max[k] = std::max(children[i].min[k], float(low[k] + size[k]));  // half of them flat on an axis
    }
    Vec3 origin = random.in_cube(5 * scale);
    Vec3 const target = low + glm::max(size, Vec3(0)) * random.uniform();
    if (i % 3 == 1) origin = Vec3(float(target.x), origin.y, origin.z);
    Vec3 direction = target - origin;
    if (i % 5 == 0) direction = random.in_cube(scale);
    if (i % 11 == 0) direction[int(random.index(3))] = 0;
    rays.push_back({to_float4(origin), to_float4(direction)});
    t_max.push_back(i % 4 == 0 ? 0.7f : float_infinity);
  }
  ProbeProgram("traversal.cl").run("probe_enter_bounds", count, {in(children), in(rays), in(t_max), out(t)});
  std::size_t hits = 0;
  for (std::size_t i = 0; i < count; ++i) {
    Vec3 const o = to_vec3(rays[i].origin), d = to_vec3(rays[i].direction);
    auto const crossing = cross_box(to_vec3(children[i].min), to_vec3(children[i].max), o, d);
    bool const expected = crossing.hit() && crossing.t_leave >= 0 && crossing.t_enter <= t_max[i];
    INFO(i << ": t " << t[i] << ", reference " << crossing.t_enter);
    if (expected && !(t[i] <= std::max(crossing.t_enter, 0.) * (1 + 2e-7))) FAIL("missed, or entered too late");
    hits += expected;
    // What passes within twice the padding may be entered.
    Vec3 const low = to_vec3(children[i].min), high = to_vec3(children[i].max);
    double const padding = 24 * rounding_unit * std::max(max_abs(low - o), max_abs(high - o));
    auto const padded = cross_box(low - padding, high + padding, o, d);
    bool const clear_miss = !padded.hit() || padded.t_leave < 0 || padded.t_enter > t_max[i];
    if (clear_miss && t[i] < float_infinity) FAIL("entered from afar");
  }
  if (count >= 1000) CHECK(hits > count / 4);
}

TEST_CASE("Bounds that are absent or not numbers are never entered", "[kernel]") {
  NEEDS_OPENCL_DEVICE();
  float const inf = float_infinity, nan = float_nan;
  std::vector<device::BvhChild> const children{
      {{1, 1, 1}, 0, {-1, -1, -1}, 0},          {{inf, inf, inf}, 0, {-inf, -inf, -inf}, 0},
      {{nan, nan, nan}, 0, {nan, nan, nan}, 0}, {{-1, -1, -1}, 0, {1, 1, 1}, 0},  // these are: a cube,
      {{0, 0, -3}, 0, {0, 0, -3}, 0},  // and a point at the ray's origin, where 0 is multiplied by infinity
      {{0, 0, -3}, 0, {0, 0, -3}, 0},           {{0, 0, -3}, 0, {0, 0, -3}, 0},
  };
  std::vector<ProbeRay> rays(children.size(), ProbeRay{{0, 0, -3, 0}, {0, 0, 1, 0}});
  rays[5].direction = {1, 0, 0, 0};
  rays[6].direction = {0, -1, 0, 0};
  std::vector<float> const t_max(children.size(), inf);
  std::vector<float> t(children.size());
  ProbeProgram("traversal.cl").run("probe_enter_bounds", t.size(), {in(children), in(rays), in(t_max), out(t)});
  CHECK(t[0] == inf);
  CHECK(t[1] == inf);
  CHECK(t[2] == inf);
  CHECK(t[3] == Approx(2));
  for (std::size_t i = 4; i < t.size(); ++i) CHECK(t[i] == 0);
}
