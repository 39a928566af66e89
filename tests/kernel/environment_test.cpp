/// Light from infinitely far away: radiance against a lookup in double precision, samples against their density.

#include <fmt/format.h>

#include <cstring>
#include <glm/trigonometric.hpp>
#include <numbers>
#include <numeric>

#include "compile/environment_table.hpp"
#include "reference.hpp"
#include "scene_arrays.hpp"
#include "support/catch.hpp"
#include "support/opencl_probe.hpp"
#include "support/skip.hpp"

using namespace lichtraum;
using namespace lichtraum::test;

namespace {

using std::numbers::pi;
using Uniforms = std::vector<std::array<float, 2>>;
using Texel = std::array<double, 3>;

std::shared_ptr<EnvironmentMap const> map_of(int width, int height, auto const& radiance) {
  auto map = std::make_shared<EnvironmentMap>();
  map->width = width;
  map->height = height;
  for (int row = 0; row < height; ++row) {
    for (int column = 0; column < width; ++column) {
      Texel const texel = radiance(column, row);
      for (double const value : texel) map->radiance.push_back(float(value));
    }
  }
  return map;
}

std::shared_ptr<EnvironmentMap const> constant_map() {
  return map_of(8, 4, [](int, int) { return Texel{0.5, 1, 2}; });
}
std::shared_ptr<EnvironmentMap const> random_map(int width, int height, std::uint64_t seed = 7) {
  Random random(seed);
  return map_of(width, height, [&](int, int) {
    return Texel{random.uniform(), random.uniform(), random.uniform() < 0.05 ? 30 : random.uniform()};
  });
}
/// A sky of a bright side, with a small sun of 10,000.
std::shared_ptr<EnvironmentMap const> sky_map(int width, int height) {
  return map_of(width, height, [=](int column, int row) {
    double const side = 1 + std::cos(2 * pi * (column + 0.5) / width);
    bool const is_sun = column == width / 5 && row == height / 3;
    double const light = is_sun ? 10000 : side * (1.2 - double(row) / height);
    return Texel{light, 0.9 * light, 0.7 * light};
  });
}
std::shared_ptr<EnvironmentMap const> one_texel_map(int width, int height, int at_column, int at_row) {
  return map_of(width, height, [=](int column, int row) {
    return column == at_column && row == at_row ? Texel{1e6, 1e6, 1e6} : Texel{0, 0, 0};
  });
}

/// What the probes take of a scene that has nothing but an environment.
struct Environment {
  explicit Environment(std::shared_ptr<EnvironmentMap const> map, bool is_compensated = true, double rotation = 0,
                       double brightness = 1, Vec3 const& up = {0, 1, 0})
      : table(make_environment_table(map, is_compensated)) {
    static_cast<device::EnvironmentArrays&>(scene) = table;
    scene.constants.features = SCENE_ENVIRONMENT;
    set_environment(scene.constants, table, {"", map, rotation, brightness}, up);
  }
  EnvironmentTable table;
  SceneArrays scene;
};

ProbeProgram program_with(int lanes) { return ProbeProgram("environment.cl", fmt::format("-D LANES={}", lanes)); }

std::vector<float4> evaluate(ProbeProgram const& program, Environment const& environment,
                             std::vector<float4> const& directions, std::size_t lanes = 1) {
  std::vector<float4> values(directions.size());
  program.run("probe_evaluate", directions.size() / lanes, environment.scene.arguments({in(directions), out(values)}));
  return values;
}

struct MapSamples {
  std::vector<float4> directions, radiances;
};
MapSamples sample_map(ProbeProgram const& program, Environment const& environment, Uniforms const& uniforms,
                      std::size_t lanes = 1) {
  MapSamples samples{std::vector<float4>(uniforms.size()), std::vector<float4>(uniforms.size())};
  program.run("probe_sample", uniforms.size() / lanes,
              environment.scene.arguments({in(uniforms), out(samples.directions), out(samples.radiances)}));
  return samples;
}

Uniforms random_uniforms(Random& random, std::size_t count) {
  Uniforms uniforms(count);
  for (auto& u : uniforms) u = {float(random.index(1 << 24)) * 0x1p-24f, float(random.index(1 << 24)) * 0x1p-24f};
  return uniforms;
}

/// u, v of the public header's formula.
std::array<double, 2> place_of(Vec3 const& direction) {
  return {0.5 + std::atan2(direction.z, direction.x) / (2 * pi), std::acos(std::clamp(direction.y, -1.0, 1.0)) / pi};
}
Vec3 direction_at(double u, double v) {
  double const phi = 2 * pi * (u - 0.5), theta = pi * v;
  return {std::sin(theta) * std::cos(phi), std::cos(theta), std::sin(theta) * std::sin(phi)};
}

/// The radiance at u, v. Rows beyond the poles are the mean of the row nearest to them, half a texel away from it.
Vec3 lookup(EnvironmentMap const& map, double u, double v) {
  auto const texel = [&](int column, int row) {
    int const wrapped = ((column % map.width) + map.width) % map.width;
    return to_vec3(&map.radiance[3 * std::size_t(row * map.width + wrapped)]);
  };
  auto const along_row = [&](int row) {
    double const x = u * map.width - 0.5, left = std::floor(x);
    return glm::mix(texel(int(left), row), texel(int(left) + 1, row), x - left);
  };
  auto const mean = [&](int row) {
    Vec3 sum(0);
    for (int i = 0; i < map.width; ++i) sum += texel(i, row);
    return sum / double(map.width);
  };
  double const y = v * map.height;
  if (y < 0.5) return glm::mix(mean(0), along_row(0), y / 0.5);
  if (y > map.height - 0.5)
    return glm::mix(along_row(map.height - 1), mean(map.height - 1), (y - map.height + 0.5) / 0.5);
  int const row = std::min(int(y - 0.5), map.height - 2);
  return map.height == 1 ? along_row(0) : glm::mix(along_row(row), along_row(row + 1), y - 0.5 - row);
}

constexpr std::size_t theta_bins = 80, phi_bins = 160;
std::size_t bin_of(Vec3 const& direction) {
  auto const [u, v] = place_of(direction);
  return std::min(std::size_t(v * theta_bins), theta_bins - 1) * phi_bins +
         std::min(std::size_t(u * phi_bins), phi_bins - 1);
}

/// The probability of each bin, by the midpoint rule; `steps` a bin along each axis.
std::vector<double> probabilities(ProbeProgram const& program, Environment const& environment, std::size_t steps) {
  std::vector<float4> directions;
  std::vector<double> areas;
  std::size_t const rows = theta_bins * steps, columns = phi_bins * steps;
  for (std::size_t i = 0; i < rows; ++i) {
    double const area = (std::cos(pi * double(i) / double(rows)) - std::cos(pi * double(i + 1) / double(rows))) * 2 *
                        pi / double(columns);
    for (std::size_t k = 0; k < columns; ++k) {
      directions.push_back(
          to_float4(direction_at((double(k) + 0.5) / double(columns), (double(i) + 0.5) / double(rows))));
      areas.push_back(area);
    }
  }
  std::vector<float4> const values = evaluate(program, environment, directions);
  std::vector<double> result(theta_bins * phi_bins);
  for (std::size_t i = 0; i < values.size(); ++i) {
    result[i / columns / steps * phi_bins + i % columns / steps] += double(values[i].w) * areas[i];
  }
  return result;
}

/// As in bsdf_test.cpp (Wilson and Hilferty 1931).
double deviations(double chi_square, double degrees) {
  double const spread = 2 / (9 * degrees);
  return (std::cbrt(chi_square / degrees) - (1 - spread)) / std::sqrt(spread);
}

}  // namespace

TEST_CASE("an environment's radiance is the map's, interpolated, turned and scaled", "[kernel][environment]") {
  NEEDS_OPENCL_DEVICE();
  Random random(100);
  ProbeProgram const program = program_with(1);
  for (auto const& map : {random_map(64, 32), random_map(7, 5), random_map(1, 1), random_map(2, 1), random_map(1, 3)}) {
    for (double const rotation : {0.0, 90.0, -37.0, 3600.0 + 180.0}) {
      bool const is_z_up = rotation != 0;
      Environment const environment(map, true, rotation, 2.5, is_z_up ? Vec3(0, 0, 1) : Vec3(0, 1, 0));
      std::vector<float4> directions;
      for (std::size_t i = 0; i < scaled_count(20000); ++i) directions.push_back(to_float4(random.direction()));
      for (double const y : {1.0, -1.0}) directions.push_back(to_float4({0, y, 0}));
      for (double const x : {1.0, -1.0}) directions.push_back(to_float4({x, 0, 0}));
      std::vector<float4> const values = evaluate(program, environment, directions);
      for (std::size_t i = 0; i < directions.size(); ++i) {
        // Seen from above x is to the right and z down: counter-clockwise is from x to -z.
        double const angle = glm::radians(rotation);
        Vec3 d = to_vec3(directions[i]);
        if (is_z_up) d = {d.x, d.z, -d.y};  // what is towards -y of the world is in front, as +z is otherwise
        Vec3 const turned_back(std::cos(angle) * d.x - std::sin(angle) * d.z, d.y,
                               std::sin(angle) * d.x + std::cos(angle) * d.z);
        auto const [u, v] = place_of(turned_back);
        Vec3 const expected = 2.5 * lookup(*map, u, v);
        INFO(map->width << " x " << map->height << ", rotation " << rotation << ", u " << u << ", v " << v);
        // A direction of floats is off by 1e-7, beside the poles in u by much more; the steepest slope is 30 a texel.
        double const sine = std::max(1e-3, std::hypot(d.x, d.z));
        if (max_abs(to_vec3(values[i]) - expected) > 2.5 * 30 * map->width * 2e-7 / sine + 1e-5) FAIL("radiance");
      }
    }
  }
}

TEST_CASE("a rotation turns an environment counter-clockwise, seen from above", "[kernel][environment]") {
  NEEDS_OPENCL_DEVICE();
  ProbeProgram const program = program_with(1);
  // A light towards +x, in the middle of the map: after a quarter turn it is towards -z.
  auto const map = map_of(9, 5, [](int column, int row) {
    return column == 4 && row == 2 ? Texel{1, 1, 1} : Texel{0, 0, 0};
  });
  std::vector<float4> const directions{to_float4({1, 0, 0}), to_float4({0, 0, -1}), to_float4({-1, 0, 0}),
                                       to_float4({0, 0, 1})};
  auto const lit = [&](double rotation) {
    std::vector<float4> const values = evaluate(program, Environment(map, true, rotation), directions);
    std::vector<bool> result;
    for (float4 const& value : values) result.push_back(value.x > 0.999f && value.w > 0);
    return result;
  };
  CHECK(lit(0) == std::vector<bool>{true, false, false, false});
  CHECK(lit(90) == std::vector<bool>{false, true, false, false});
  CHECK(lit(180) == std::vector<bool>{false, false, true, false});
  CHECK(lit(-90) == std::vector<bool>{false, false, false, true});
}

TEST_CASE("an environment has no seam, and its poles one value each", "[kernel][environment]") {
  NEEDS_OPENCL_DEVICE();
  ProbeProgram const program = program_with(1);
  for (auto const& map : {random_map(64, 32), random_map(7, 5)}) {
    Environment const environment(map);
    std::vector<float4> directions;
    std::size_t const count = 200;
    for (std::size_t i = 0; i < count; ++i) {  // on both sides of the edge, 1e-6 of a turn apart
      double const v = (double(i) + 0.5) / double(count);
      directions.push_back(to_float4(direction_at(-0.5e-6, v)));
      directions.push_back(to_float4(direction_at(0.5e-6, v)));
    }
    for (std::size_t i = 0; i < count; ++i) {  // around the poles
      double const u = double(i) / double(count);
      directions.push_back(to_float4(direction_at(u, 1e-6)));
      directions.push_back(to_float4(direction_at(u, 1 - 1e-6)));
    }
    std::vector<float4> const values = evaluate(program, environment, directions);
    double const slope = 30 * map->width;  // the most that radiance changes in a turn
    for (std::size_t i = 0; i < count; ++i) {
      INFO(map->width << " x " << map->height << ", " << i);
      // What a float has of an angle near pi is 2^-22: beside 1e-6 of a turn, nothing is added for it.
      if (max_abs(to_vec3(values[2 * i]) - to_vec3(values[2 * i + 1])) > 1.5e-6 * slope) FAIL("seam");
    }
    for (std::size_t i = 2 * count; i < 4 * count; ++i) {
      Vec3 const pole = to_vec3(&environment.table.poles[i % 2 == 0 ? 0 : 3]);
      INFO(map->width << " x " << map->height << ", " << i);
      if (max_abs(to_vec3(values[i]) - pole) > 1e-6 * 2 * 30 * map->height + 1e-5) FAIL("pole");
    }
  }
}

TEST_CASE("the density of an environment's samples integrates to 1, and follows the light",
          "[kernel][environment][statistics]") {
  NEEDS_OPENCL_DEVICE();
  ProbeProgram const program = program_with(1);
  struct Case {
    std::shared_ptr<EnvironmentMap const> map;
    bool is_compensated;
  };
  for (Case const& c : {Case{random_map(40, 20), false},
                        {random_map(40, 20), true},
                        {sky_map(80, 40), true},
                        {sky_map(80, 40), false},
                        {constant_map(), false},
                        {one_texel_map(16, 8, 0, 0), true}}) {
    Environment const environment(c.map, c.is_compensated);
    std::vector<double> const bins = probabilities(program, environment, 2);
    INFO(c.map->width << " x " << c.map->height << ", compensated: " << c.is_compensated);
    // The rule's rows are those of texels, cut into equal parts: it is exact but for floats.
    CHECK(std::accumulate(bins.begin(), bins.end(), 0.0) == Approx(1).margin(1e-5));
  }
  // Without compensation, every direction from which something arrives can be sampled.
  Random random(101);
  std::vector<float4> directions;
  for (std::size_t i = 0; i < scaled_count(20000); ++i) directions.push_back(to_float4(random.direction()));
  for (auto const& map : {one_texel_map(16, 8, 3, 0), one_texel_map(16, 8, 15, 4), one_texel_map(16, 8, 0, 7)}) {
    for (float4 const& value : evaluate(program, Environment(map, false), directions)) {
      if (value.x > 0 && !(value.w > 0)) FAIL("not sampled");
    }
  }
}

// 1 % in all for the 12 cases: 0.084 % each (Sidak), which is 3.14 standard deviations of the normal distribution.
TEST_CASE("an environment's samples have the density that it says (chi-square)", "[kernel][environment][statistics]") {
  NEEDS_OPENCL_DEVICE();
  Random random(102);
  ProbeProgram const program = program_with(1);
  std::size_t const count = scaled_count(1000000);
  for (auto const& map : {random_map(40, 20), random_map(80, 16), sky_map(160, 80), random_map(16, 5),
                          one_texel_map(16, 8, 5, 0), one_texel_map(16, 8, 15, 7)}) {
    for (bool const is_compensated : {false, true}) {
      INFO(map->width << " x " << map->height << ", compensated: " << is_compensated);
      Environment const environment(map, is_compensated);
      std::vector<double> const probability = probabilities(program, environment, 2);
      MapSamples const samples = sample_map(program, environment, random_uniforms(random, count));
      std::vector<double> found(probability.size());
      for (float4 const& direction : samples.directions) {
        REQUIRE(direction.w > 0);
        ++found[bin_of(to_vec3(direction))];
      }
      double chi_square = 0, degrees = 0, rare_expected = 0, rare_found = 0;
      for (std::size_t i = 0; i < found.size(); ++i) {
        double const expected = probability[i] * double(count);
        if (expected < 5) {  // together they are one bin
          rare_expected += expected;
          rare_found += found[i];
          continue;
        }
        chi_square += (found[i] - expected) * (found[i] - expected) / expected;
        ++degrees;
      }
      if (rare_expected >= 5) {
        chi_square += (rare_found - rare_expected) * (rare_found - rare_expected) / rare_expected;
        ++degrees;
      } else {
        CHECK(rare_found <= rare_expected + 20);
      }
      REQUIRE(degrees > 2);
      CHECK(deviations(chi_square, degrees - 1) < 3.14);
    }
  }
}

TEST_CASE("what is sampled of an environment is its radiance there, and the density", "[kernel][environment]") {
  NEEDS_OPENCL_DEVICE();
  Random random(103);
  ProbeProgram const program = program_with(1);
  std::size_t const count = scaled_count(100000);
  for (double const rotation : {0.0, 77.0}) {
    for (auto const& map : {random_map(40, 20), sky_map(512, 256), random_map(3, 1)}) {
      INFO(map->width << " x " << map->height << ", rotation " << rotation);
      Environment const environment(map, false, rotation, 0.5, rotation == 0 ? Vec3(0, 1, 0) : Vec3(1, 2, -3));
      MapSamples const samples = sample_map(program, environment, random_uniforms(random, count));
      std::vector<float4> const values = evaluate(program, environment, samples.directions);
      std::size_t others = 0;
      double power = 0;
      for (std::size_t i = 0; i < count; ++i) {
        Vec3 const wi = to_vec3(samples.directions[i]), radiance = to_vec3(samples.radiances[i]);
        if (std::abs(glm::length(wi) - 1) > 1e-6) FAIL("no unit vector");
        if (radiance != to_vec3(values[i])) FAIL("radiance");
        double const pdf = samples.directions[i].w;
        others += std::abs(pdf - values[i].w) > 1e-6 * pdf;
        power += glm::dot(Vec3(0.2126, 0.7152, 0.0722), radiance) / pdf / double(count);
      }
      // Only at the edges of texels, where the direction's rounding may lead into the next one.
      CHECK(double(others) <= 1e-5 * map->width * double(count) + 3);
      if (count == 100000) CHECK(power == Approx(double(environment.scene.constants.environment_power)).epsilon(0.02));
    }
  }
}

TEST_CASE("of a black or constant environment nothing is sampled, and all of one bright texel",
          "[kernel][environment]") {
  NEEDS_OPENCL_DEVICE();
  Random random(104);
  ProbeProgram const program = program_with(1);
  Uniforms const uniforms = random_uniforms(random, scaled_count(10000));
  auto const black = map_of(8, 4, [](int, int) { return Texel{0, 0, 0}; });
  for (auto const& [map, is_compensated] : {std::pair{black, true}, {black, false}, {constant_map(), true}}) {
    Environment const environment(map, is_compensated);
    CHECK(environment.scene.constants.environment_sampled_power == 0);
    MapSamples const samples = sample_map(program, environment, uniforms);
    for (std::size_t i = 0; i < uniforms.size(); ++i) {
      if (samples.directions[i].w != 0) FAIL("density");
      if (!(max_abs(to_vec3(samples.directions[i])) <= 1)) FAIL("direction");
      if (max_abs(to_vec3(samples.radiances[i]) - Vec3(map == black ? Vec3(0) : Vec3(0.5, 1, 2))) > 1e-6)
        FAIL("radiance");
    }
  }
  CHECK(Environment(black).scene.constants.environment_power == 0);
  double const luminance = 0.2126 * 0.5 + 0.7152 + 0.0722 * 2;
  CHECK(double(Environment(constant_map()).scene.constants.environment_power) == Approx(4 * pi * luminance));

  for (auto const& [column, row] : {std::pair{100, 37}, {0, 0}, {511, 255}, {511, 128}}) {
    Environment const environment(one_texel_map(512, 256, column, row));
    MapSamples const samples = sample_map(program, environment, uniforms);
    for (float4 const& direction : samples.directions) {
      auto const [u, v] = place_of(to_vec3(direction));
      // With half of each neighbour, by interpolation; a row at a pole all around it.
      double const around = std::abs(std::remainder(u * 512 - column - 0.5, 512));
      INFO(column << ", " << row << ": " << u << ", " << v);
      if (std::abs(v * 256 - row - 0.5) > 1.501) FAIL("row");
      if (row != 0 && row != 255 && around > 1.501) FAIL("column");
      if (!(direction.w > 0) || !std::isfinite(direction.w)) FAIL("density");
    }
  }
}

TEST_CASE("every texel of an environment can be sampled, however many there are", "[kernel][environment][statistics]") {
  NEEDS_OPENCL_DEVICE();
  // 2^25 texels: more than a float has numbers from 0 to 1. Texels of equal probability would each be met once.
  ProbeProgram const program = program_with(1);
  int const width = 8192, height = 4096;
  auto map = std::make_shared<EnvironmentMap>(EnvironmentMap{width, height, {}});
  map->radiance.assign(3 * std::size_t(width) * height, 1);
  Environment const environment(map, false);
  Random random(105);
  // In every row some columns; a number in the middle of a texel's part must lead into it: all of these are their own.
  Uniforms uniforms;
  std::vector<int> columns;
  for (int i = 0; i < 1000; ++i) {
    int const column = int(random.index(std::size_t(width)));
    columns.push_back(column);
    uniforms.push_back({(float(column) + 0.5f) / float(width), float(random.uniform())});
  }
  MapSamples const samples = sample_map(program, environment, uniforms);
  for (std::size_t i = 0; i < columns.size(); ++i) {
    double const u = place_of(to_vec3(samples.directions[i]))[0];
    INFO(i << ": " << u * width << ", " << columns[i]);
    if (std::abs(u * width - columns[i] - 0.5) > 0.05) FAIL("column");
  }
}

TEST_CASE("sixteen samples of an environment at once are those of one by one",
          "[kernel][environment][layouts][lanes]") {
  NEEDS_OPENCL_DEVICE();
  Random random(106);
  ProbeProgram const one = program_with(1), sixteen = program_with(16);
  std::size_t const count = (scaled_count(20000) + 15) / 16 * 16;
  for (auto const& map : {random_map(64, 32), random_map(7, 5), sky_map(33, 17), constant_map(), random_map(1, 1)}) {
    for (bool const is_compensated : {false, true}) {
      Environment const environment(map, is_compensated, 33);
      Uniforms uniforms = random_uniforms(random, count);
      std::vector<float4> directions;
      for (std::size_t i = 0; i < count; ++i) {
        if (i % 3 == 0) uniforms[i] = {i % 2 == 0 ? 0 : 0x1.fffffep-1f, i % 4 < 2 ? 0 : 0x1.fffffep-1f};
        // Lanes that do not count may hold anything.
        if (i % 7 == 0) uniforms[i] = {float_nan, i % 2 == 0 ? -float_infinity : 1e30f};
        directions.push_back(to_float4(i % 11 == 0 ? Vec3(i % 2, i % 3, 0) : random.direction()));
        if (i % 13 == 0) directions.back().z = i % 2 == 0 ? float_nan : float_infinity;
      }
      MapSamples const a = sample_map(one, environment, uniforms), b = sample_map(sixteen, environment, uniforms, 16);
      auto const c = evaluate(one, environment, directions), d = evaluate(sixteen, environment, directions, 16);
      auto const are_same = [&](std::vector<float4> const& x, std::vector<float4> const& y) {
        return std::memcmp(x.data(), y.data(), count * sizeof(float4)) == 0;
      };
      INFO(map->width << " x " << map->height << ", compensated: " << is_compensated);
      CHECK(are_same(a.directions, b.directions));
      CHECK(are_same(a.radiances, b.radiances));
      for (std::size_t i = 0; i < count; ++i) {
        if (std::isfinite(directions[i].z) && std::memcmp(&c[i], &d[i], sizeof c[i]) != 0) FAIL("lanes");
      }
    }
  }
}
