/// Light from spheres, ellipsoids and boxes: samples against the shapes, against their density and against each other.

#include <fmt/format.h>

#include <numbers>
#include <optional>

#include "reference.hpp"
#include "scene/device_conversion.hpp"
#include "scene_arrays.hpp"
#include "support/catch.hpp"
#include "support/opencl_probe.hpp"
#include "support/skip.hpp"

using namespace lichtraum;
using namespace lichtraum::test;

namespace {

using std::numbers::pi;

/// The shape on the host: all points center + axes * p where p is in the unit ball, or in the cube from -1 to 1.
struct Solid {
  Vec3 center;
  Mat3 axes;
  bool is_box = false;

  struct Met {
    double distance, cosine;
  };
  /// Where a ray of unit length meets it: where it enters, or from within leaves.
  std::optional<Met> meet(Vec3 const& origin, Vec3 const& direction) const {
    return is_box ? meet_box(origin, direction) : meet_ball(origin, direction);
  }

 private:
  std::optional<Met> meet_ball(Vec3 const& origin, Vec3 const& direction) const {
    Mat3 const inverse = glm::inverse(axes);
    Vec3 const o = inverse * (origin - center), d = inverse * direction;
    double const a = glm::dot(d, d), b = glm::dot(o, d), c = glm::dot(o, o) - 1;
    double const discriminant = b * b - a * c;
    if (discriminant <= 0) return {};
    double const t = (-b + (c > 0 ? -1 : 1) * std::sqrt(discriminant)) / a;
    if (t <= 0) return {};
    Vec3 const normal = glm::normalize(glm::transpose(inverse) * (o + t * d));
    return Met{t, std::abs(glm::dot(normal, direction))};
  }
  /// Face by face, as parallelograms, so that flat boxes need no inverse.
  std::optional<Met> meet_box(Vec3 const& origin, Vec3 const& direction) const {
    std::optional<Met> nearest;
    for (int axis = 0; axis < 3; ++axis) {
      Vec3 const &a = axes[(axis + 1) % 3], &b = axes[(axis + 2) % 3];
      Vec3 const normal = glm::cross(a, b);
      if (normal == Vec3(0)) continue;
      for (double const side : {-1, 1}) {
        Vec3 const middle = center + side * axes[axis];
        double const t = glm::dot(middle - origin, normal) / glm::dot(direction, normal);
        Vec3 const on_face = origin + t * direction - middle;
        Vec3 const across_b = glm::cross(b, normal), across_a = glm::cross(normal, a);
        bool const is_met = std::abs(glm::dot(on_face, across_b)) <= std::abs(glm::dot(a, across_b)) &&
                            std::abs(glm::dot(on_face, across_a)) <= std::abs(glm::dot(b, across_a));
        if (!(t > 0) || !is_met || (nearest && nearest->distance <= t)) continue;
        nearest = Met{t, std::abs(glm::dot(glm::normalize(normal), direction))};
      }
    }
    return nearest;
  }
};

struct Case {
  char const* what;
  Solid solid;
  Vec3 position;
};

std::vector<Case> cases() {
  Random random(81);
  Mat3 const turned = random.rotation();
  Mat3 const sheared = turned * Mat3(0.3, 0, 0, 0.1, 0.8, 0, 0.2, -0.3, 0.5);
  Vec3 const c(0.4, -0.2, 0.7);
  return {
      {"a sphere, near", {c, Mat3(0.5)}, c + Vec3(0.3, 0.5, -0.2)},
      {"a sphere, far", {c, Mat3(0.5)}, c + Vec3(3, 1, -2)},
      {"a sphere, nearly touched", {c, Mat3(0.5)}, c + Vec3(0, 0.5005, 0)},
      {"a sphere, from its middle", {c, Mat3(0.5)}, c},
      {"a sphere, from within", {c, Mat3(2)}, c + Vec3(1.1, -0.8, 0.3)},
      {"an ellipsoid", {c, turned * Mat3(1.5, 0, 0, 0, 0.2, 0, 0, 0, 0.6)}, c + Vec3(1, 1.2, 0.4)},
      {"a sheared and mirrored one", {c, sheared * Mat3(-1, 0, 0, 0, 1, 0, 0, 0, 1)}, c + Vec3(-0.5, 0.9, 1)},
      {"an ellipsoid, from within", {c, sheared}, c + sheared * Vec3(0.4, -0.5, 0.3)},
      {"a cube, above a face", {c, Mat3(0.5), true}, c + Vec3(0.2, 1.1, -0.3)},
      {"a cube, by an edge", {c, Mat3(0.5), true}, c + Vec3(0.9, 1.1, -0.3)},
      {"a cube, by a corner", {c, Mat3(0.5), true}, c + Vec3(0.9, 1.1, -0.8)},
      {"a cube, in the plane of a face", {c, Mat3(0.5), true}, c + Vec3(1.5, -0.5, 0.1)},
      {"a sheared box", {c, sheared, true}, c + Vec3(1, -1.2, 0.9)},
      {"a mirrored box", {c, sheared * Mat3(1, 0, 0, 0, -1, 0, 0, 0, 1), true}, c + Vec3(1, -1.2, 0.9)},
      {"a sheared box, from within", {c, sheared, true}, c + sheared * Vec3(0.6, -0.5, 0.1)},
      {"a flat box", {c, turned * Mat3(0.5, 0, 0, 0, 0, 0, 0, 0, 0.9), true}, c + turned * Vec3(0.3, 0.6, -0.2)},
      {"a flat box, from below", {c, turned * Mat3(0.5, 0, 0, 0, 0, 0, 0, 0, 0.9), true}, c + turned * Vec3(1, -1, 1)},
  };
}

SceneArrays scene_of_solids(std::vector<Case> const& all) {
  SceneArrays scene;
  device::PhongMaterial material{};
  material.emission[0] = 7;
  scene.materials.push_back(material);
  for (std::size_t i = 0; i < all.size(); ++i) {
    Solid const& solid = all[i].solid;
    device::EmissiveSolid emissive{};
    store(solid.center, emissive.center);
    for (int axis = 0; axis < 3; ++axis) store(solid.axes[axis], emissive.axes[axis]);
    if (!solid.is_box) emissive.unit_from_world = to_device(Affine{solid.axes, solid.center}.inverse());
    emissive.kind = solid.is_box ? PRIMITIVE_BOX : PRIMITIVE_ELLIPSOID;
    emissive.index = device::uint(i);
    emissive.instance = none;
    scene.emissive_solids.push_back(emissive);
  }
  scene.constants.emissive_solid_count = device::uint(all.size());
  return scene;
}

using Pair = std::array<float, 2>;

struct SolidSamples {
  std::vector<float4> directions;  // w: how far rays may go
  std::vector<Pair> found;         // density, radiance
};
SolidSamples sample_solids(SceneArrays const& scene, std::vector<device::uint> const& numbers,
                           std::vector<float4> const& positions, std::vector<Pair> const& uniforms, std::size_t lanes) {
  SolidSamples samples{std::vector<float4>(numbers.size()), std::vector<Pair>(numbers.size())};
  ProbeProgram("emissive_solid.cl", fmt::format("-D LANES={}", lanes))
      .run("probe_sample", numbers.size() / lanes,
           scene.arguments({in(numbers), in(positions), in(uniforms), out(samples.directions), out(samples.found)}));
  return samples;
}

std::vector<float> densities(SceneArrays const& scene, std::vector<device::uint> const& numbers,
                             std::vector<float4> const& positions, std::vector<float4> const& directions) {
  std::vector<float> pdfs(numbers.size());
  ProbeProgram("emissive_solid.cl", "-D LANES=16")
      .run("probe_pdf", numbers.size() / 16, scene.arguments({in(numbers), in(positions), in(directions), out(pdfs)}));
  return pdfs;
}

Pair random_pair(Random& random) {
  return {float(random.index(1 << 24)) * 0x1p-24f, float(random.index(1 << 24)) * 0x1p-24f};
}

/// In which `position` sees a sphere.
double solid_angle(Case const& drawn) {
  double const ratio = drawn.solid.axes[0].x / glm::distance(drawn.position, drawn.solid.center);
  return ratio < 1 ? 2 * pi * (1 - std::sqrt(1 - ratio * ratio)) : 4 * pi;
}

/// Lists of the same length: each case `each` times, mixed, so that lanes differ.
struct Listed {
  std::vector<device::uint> numbers;
  std::vector<float4> positions;
  Listed(std::vector<Case> const& all, std::size_t each) {
    for (std::size_t i = 0; i < each * all.size(); ++i) {
      std::size_t const number = i % all.size();
      numbers.push_back(device::uint(number));
      positions.push_back(to_float4(all[number].position));
    }
  }
};

}  // namespace

TEST_CASE("SolidSamples of solids that shine lie on them, before anything of them", "[kernel]") {
  NEEDS_OPENCL_DEVICE();
  auto const all = cases();
  SceneArrays const scene = scene_of_solids(all);
  Random random(82);
  std::size_t const each = 16 * scaled_count(64);
  Listed listed(all, each);
  std::vector<Pair> uniforms;
  for (std::size_t i = 0; i < listed.numbers.size(); ++i) uniforms.push_back(random_pair(random));
  uniforms[5][0] = -1;
  SolidSamples const samples = sample_solids(scene, listed.numbers, listed.positions, uniforms, 16);
  CHECK(samples.found[5] == Pair{0, 0});
  std::size_t misses = 0;
  std::vector<float4> positions, directions;
  for (std::size_t i = 0; i < listed.numbers.size(); ++i) {
    Case const& drawn = all[listed.numbers[i]];
    Vec3 const direction = to_vec3(samples.directions[i]);
    auto const met = drawn.solid.meet(to_vec3(listed.positions[i]), direction);
    positions.push_back(listed.positions[i]);
    directions.push_back(samples.directions[i]);
    positions.back().w = 0;
    if (i == 5) continue;
    INFO(drawn.what << ", sample " << i);
    if (std::abs(glm::length(direction) - 1) > 1e-5) FAIL("not a unit vector");
    if (samples.found[i][1] != 7) FAIL("radiance");
    bool const is_sphere = drawn.solid.axes == Mat3(drawn.solid.axes[0].x) && !drawn.solid.is_box;
    if (is_sphere && std::abs(samples.found[i][0] * solid_angle(drawn) - 1) > 1e-3) FAIL("not even over the sphere");
    if (!met || met->cosine < 1e-2) {  // beside its edge by rounding, or all but
      ++misses;
      continue;
    }
    double const reach = samples.directions[i].w;
    if (!(reach < met->distance && reach > 0.995 * met->distance - 1e-5)) {
      FAIL("rays may go " << reach << " to what is at " << met->distance);
    }
    positions.back().w = float(met->distance);
    directions.back().w = float(met->cosine);
  }
  CHECK(misses < listed.numbers.size() / 50);
  auto const pdfs = densities(scene, listed.numbers, positions, directions);
  for (std::size_t i = 0; i < listed.numbers.size(); ++i) {
    if (positions[i].w == 0) continue;
    INFO(all[listed.numbers[i]].what << ", sample " << i);
    double const tolerance = 1e-3 + 1e-5 / directions[i].w;
    if (std::abs(pdfs[i] / samples.found[i][0] - 1) > tolerance) {
      FAIL("found by chance with " << pdfs[i] << ", looked for with " << samples.found[i][0]);
    }
  }
}

TEST_CASE("SolidSamples of solids that shine are the same alone and in lanes", "[kernel]") {
  NEEDS_OPENCL_DEVICE();
  auto const all = cases();
  SceneArrays const scene = scene_of_solids(all);
  Random random(83);
  Listed const listed(all, 16);
  std::vector<Pair> uniforms;
  for (std::size_t i = 0; i < listed.numbers.size(); ++i) uniforms.push_back(random_pair(random));
  SolidSamples const alone = sample_solids(scene, listed.numbers, listed.positions, uniforms, 1);
  SolidSamples const together = sample_solids(scene, listed.numbers, listed.positions, uniforms, 16);
  CHECK(alone.found == together.found);
  auto const same = [](float4 const& a, float4 const& b) {
    return a.x == b.x && a.y == b.y && a.z == b.z && a.w == b.w;
  };
  CHECK(std::ranges::equal(alone.directions, together.directions, same));
}

/// A function's integral over the directions in which a solid is seen, two ways: by its samples and their density, and
/// by directions all around, of which the host says which meet it. The function is 1 in one of the octants around the
/// way to the middle, so that a density that is wrong anywhere shows.
TEST_CASE("SolidSamples of solids that shine are as dense as is said", "[kernel][statistics]") {
  NEEDS_OPENCL_DEVICE();
  auto const all = cases();
  SceneArrays const scene = scene_of_solids(all);
  Random random(84);
  std::size_t const each = 16 * scaled_count(2000);
  Listed const listed(all, each);
  std::vector<Pair> uniforms;
  for (std::size_t i = 0; i < listed.numbers.size(); ++i) uniforms.push_back(random_pair(random));
  SolidSamples const samples = sample_solids(scene, listed.numbers, listed.positions, uniforms, 16);
  constexpr int octants = 8;
  struct Sum {
    double first = 0, second = 0, count = 0;
    void add(double value) {
      first += value;
      second += value * value;
      ++count;
    }
    double mean() const { return first / count; }
    double variance_of_mean() const { return std::max(second / count - mean() * mean(), 0.0) / count; }
  };
  for (std::size_t number = 0; number < all.size(); ++number) {
    Case const& drawn = all[number];
    Vec3 const position = to_vec3(to_float4(drawn.position));
    Vec3 const to_middle = drawn.solid.center + 0.2 * drawn.solid.axes * Vec3(0.3, 0.5, -0.4) - position;
    Vec3 const x = glm::normalize(glm::cross(to_middle, Vec3(0.3, -0.5, 0.8))),
               y = glm::normalize(glm::cross(to_middle, x));
    double const width = 0.5 * glm::length(drawn.solid.axes[0]) / glm::length(to_middle);
    auto const octant = [&](Vec3 const& direction) {
      double const across = glm::dot(direction, x), up = glm::dot(direction, y);
      bool const is_outer = std::hypot(across, up) > std::min(0.7, 0.5 * width);
      return (across > 0) + 2 * (up > 0) + 4 * is_outer;
    };
    Sum sampled[octants], all_around[octants];
    for (std::size_t i = number; i < listed.numbers.size(); i += all.size()) {
      int const met = octant(to_vec3(samples.directions[i]));
      double const pdf = samples.found[i][0];
      for (int k = 0; k < octants; ++k) sampled[k].add(k == met && pdf > 0 ? 1 / pdf : 0);
    }
    for (std::size_t i = 0; i < 4 * each; ++i) {
      Vec3 const direction = random.direction();
      int const met = drawn.solid.meet(position, direction) ? octant(direction) : octants;
      for (int k = 0; k < octants; ++k) all_around[k].add(k == met ? 4 * pi : 0);
    }
    for (int k = 0; k < octants; ++k) {
      INFO(drawn.what << ", octant " << k << ": " << sampled[k].mean() << ", expected " << all_around[k].mean());
      double const deviation = std::sqrt(sampled[k].variance_of_mean() + all_around[k].variance_of_mean());
      // Of 17 * 8 comparisons one fails by chance with probability 0.1 %.
      CHECK(std::abs(sampled[k].mean() - all_around[k].mean()) <= 4.5 * deviation + 1e-4 * all_around[k].mean());
    }
  }
}

TEST_CASE("A solid that was hit is found among those that shine", "[kernel]") {
  NEEDS_OPENCL_DEVICE();
  using Name = std::array<device::uint, 4>;
  std::vector<Name> names;
  for (device::uint const instance : {0u, 3u, none}) {
    for (device::uint const kind : {PRIMITIVE_SPHERE, PRIMITIVE_ELLIPSOID, PRIMITIVE_BOX}) {
      for (device::uint const index : {0u, 2u, 9u}) names.push_back({instance, kind, index, 0});
    }
  }
  SceneArrays scene;
  for (Name const& name : names) {
    device::EmissiveSolid solid{};
    solid.instance = name[0];
    solid.kind = name[1];
    solid.index = name[2];
    scene.emissive_solids.push_back(solid);
  }
  scene.constants.emissive_solid_count = device::uint(names.size());
  std::vector<device::uint> expected;
  for (device::uint i = 0; i < names.size(); ++i) expected.push_back(i);
  for (Name const other : {Name{0, PRIMITIVE_SPHERE, 1}, Name{1, PRIMITIVE_SPHERE, 0}, Name{3, PRIMITIVE_BOX, 10},
                           Name{none, PRIMITIVE_BOX, 10}, Name{0, PRIMITIVE_TRIANGLE, 0}}) {
    names.push_back(other);
    expected.push_back(none);
  }
  std::vector<device::uint> numbers(names.size());
  ProbeProgram const program("emissive_solid.cl", "-D LANES=1");
  program.run("probe_find", names.size(), scene.arguments({in(names), out(numbers)}));
  CHECK(numbers == expected);
  scene.constants.emissive_solid_count = 0;
  program.run("probe_find", names.size(), scene.arguments({in(names), out(numbers)}));
  CHECK(numbers == std::vector<device::uint>(names.size(), none));
}
