/// Phong's BSDF: evaluate against formulae of another form in double precision, pdf and sample against each other.

#include <fmt/format.h>

#include <cstring>
#include <glm/trigonometric.hpp>

#include "reference.hpp"
#include "shared/phong_material.h"
#include "support/catch.hpp"
#include "support/opencl_probe.hpp"
#include "support/skip.hpp"

using namespace lichtraum;
using namespace lichtraum::test;

namespace {

constexpr double pi = 3.14159265358979;

struct Model {
  double kd, ks, m, reflect, transmit, ior;
};

device::PhongMaterial material_of(Model const& model) {
  device::PhongMaterial out{};
  for (int c = 0; c < 3; ++c) {
    out.kd[c] = float(model.kd * (1 - 0.3 * c));
    out.ks[c] = float(model.ks * (1 - 0.2 * c));
  }
  out.m = float(model.m);
  out.reflect = float(model.reflect);
  out.transmit = float(model.transmit);
  out.ior = float(model.ior);
  return out;
}

std::vector<Model> const models{{0.8, 0, 1, 0, 0, 1},      {0.5, 0.5, 0, 0, 0, 1},   {0, 1, 5, 0, 0, 1},
                                {0.3, 0.6, 20, 0.1, 0, 1}, {0.1, 0.9, 100, 0, 0, 1}, {0.4, 0.3, 1000, 0.2, 0.3, 1.5}};
std::vector<double> const angles_degrees{0, 30, 60, 80, 88};

Vec3 viewer_at(double degrees) {
  double const angle = glm::radians(degrees);
  return {0.6 * std::sin(angle), 0.8 * std::sin(angle), std::cos(angle)};
}

Vec3 direction_at(double theta, double phi) {
  return {std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta)};
}

ProbeProgram program_with(int lanes) { return ProbeProgram("bsdf.cl", fmt::format("-D LANES={}", lanes)); }

std::vector<float4> evaluate(ProbeProgram const& program, Model const& model, std::vector<float4> const& viewers,
                             std::vector<float4> const& lights, std::size_t lanes = 1) {
  std::vector<device::PhongMaterial> const material{material_of(model)};
  std::vector<float4> values(viewers.size());
  program.run("probe_evaluate", viewers.size() / lanes, {in(material), in(viewers), in(lights), out(values)});
  return values;
}

struct Samples {
  std::vector<float4> directions;
  std::vector<float4> weights;
};

Samples sample(ProbeProgram const& program, Model const& model, float eta, std::vector<float4> const& viewers,
               std::vector<std::array<float, 2>> const& uniforms, std::size_t lanes = 1) {
  std::vector<device::PhongMaterial> const material{material_of(model)};
  Samples samples{std::vector<float4>(viewers.size()), std::vector<float4>(viewers.size())};
  program.run("probe_sample", viewers.size() / lanes,
              {in(material), value(eta), in(viewers), in(uniforms), out(samples.directions), out(samples.weights)});
  return samples;
}

std::vector<std::array<float, 2>> random_uniforms(Random& random, std::size_t count) {
  std::vector<std::array<float, 2>> uniforms(count);
  for (auto& u : uniforms) u = {float(random.index(1 << 24)) * 0x1p-24f, float(random.index(1 << 24)) * 0x1p-24f};
  return uniforms;
}

/// The sphere in bins of equal angles: the probability of each, and what f cos sums up to, by the midpoint rule.
constexpr std::size_t theta_bins = 80, phi_bins = 160, theta_steps = 5;
struct Integrals {
  std::vector<double> probability = std::vector<double>(theta_bins * phi_bins);
  Vec3 albedo{0};
};

Integrals integrate(ProbeProgram const& program, Model const& model, Vec3 const& viewer) {
  std::vector<float4> lights;
  std::vector<double> areas;
  // Microfacets that are met at a grazing angle hardly move the azimuth: there a highlight is narrow.
  std::size_t const phi_steps = viewer.z < 0.1 ? 40 : 5;
  double const theta_step = pi / (theta_bins * theta_steps), phi_step = 2 * pi / double(phi_bins * phi_steps);
  for (std::size_t i = 0; i < theta_bins * theta_steps; ++i) {
    double const theta = (double(i) + 0.5) * theta_step;
    double const area = (std::cos(theta - theta_step / 2) - std::cos(theta + theta_step / 2)) * phi_step;
    for (std::size_t k = 0; k < phi_bins * phi_steps; ++k) {
      lights.push_back(to_float4(direction_at(theta, (double(k) + 0.5) * phi_step)));
      areas.push_back(area);
    }
  }
  std::vector<float4> const viewers(lights.size(), to_float4(viewer));
  std::vector<float4> const values = evaluate(program, model, viewers, lights);
  Integrals result;
  for (std::size_t i = 0; i < values.size(); ++i) {
    std::size_t const row = i / (phi_bins * phi_steps) / theta_steps, column = i % (phi_bins * phi_steps) / phi_steps;
    result.probability[row * phi_bins + column] += double(values[i].w) * areas[i];
    result.albedo += to_vec3(values[i]) * std::max(0.0, double(lights[i].z)) * areas[i];
  }
  return result;
}

double sum_of(std::vector<double> const& values) {
  double sum = 0;
  for (double const value : values) sum += value;
  return sum;
}

/// How many standard deviations the statistic is above what `degrees` of freedom let one expect (Wilson and Hilferty
/// 1931).
double deviations(double chi_square, double degrees) {
  double const spread = 2 / (9 * degrees);
  return (std::cbrt(chi_square / degrees) - (1 - spread)) / std::sqrt(spread);
}

double probability_of_delta(Model const& model) {
  double const delta = model.reflect + model.transmit;
  return delta / ((1 - delta) * model.kd + model.ks + delta);
}

}  // namespace

TEST_CASE("Phong's BSDF is Lambert's and GGX's formula", "[kernel][bsdf]") {
  NEEDS_OPENCL_DEVICE();
  Random random(90);
  ProbeProgram const program = program_with(1);
  std::size_t const count = scaled_count(20000);
  for (Model const& model : models) {
    std::vector<float4> viewers, lights;
    for (std::size_t i = 0; i < count; ++i) {
      Vec3 o = random.direction(), l = random.direction();
      o.z = std::abs(o.z);
      if (i % 2 == 0) l = glm::normalize(Vec3(-o.x, -o.y, o.z) + random.in_cube(0.1));  // into the highlight
      viewers.push_back(to_float4(o));
      lights.push_back(to_float4(l));
    }
    std::vector<float4> const values = evaluate(program, model, viewers, lights);
    std::vector<float4> const swapped = evaluate(program, model, lights, viewers);
    for (std::size_t i = 0; i < count; ++i) {
      Vec3 const o = to_vec3(viewers[i]), l = to_vec3(lights[i]);
      if (std::abs(l.z) < 1e-3 || o.z < 1e-3) continue;
      // Walter et al. 2007, with tangents; Smith's Lambda as Heitz 2014 has it.
      double const alpha = std::sqrt(2 / (model.m + 2));
      Vec3 const h = glm::normalize(o + l);
      auto const tangent_squared = [](Vec3 const& w) { return (w.x * w.x + w.y * w.y) / (w.z * w.z); };
      auto const lambda = [&](Vec3 const& w) { return (std::sqrt(1 + alpha * alpha * tangent_squared(w)) - 1) / 2; };
      double const t = alpha * alpha + tangent_squared(h);
      double const d = alpha * alpha / (pi * std::pow(h.z, 4) * t * t);
      double const gloss = d / ((1 + lambda(o) + lambda(l)) * 4 * o.z * l.z);
      device::PhongMaterial const material = material_of(model);
      double const matt = (1 - model.reflect - model.transmit) / pi;
      Vec3 const expected = l.z > 0 ? matt * to_vec3(material.kd) + gloss * to_vec3(material.ks) : Vec3(0);
      INFO("m " << model.m << ", case " << i);
      // The sharpest highlight magnifies a rounding of h by 1 / alpha.
      if (max_abs(to_vec3(values[i]) - expected) > 1e-4 * (max_abs(expected) + 1e-3)) FAIL("f");
      if (max_abs(to_vec3(values[i]) - to_vec3(swapped[i])) > 1e-4 * max_abs(expected)) FAIL("reciprocity");
    }
  }
}

TEST_CASE("the densities of Phong's BSDF integrate to 1, and it keeps no more light than arrives",
          "[kernel][bsdf][statistics]") {
  NEEDS_OPENCL_DEVICE();
  ProbeProgram const program = program_with(1);
  for (Model const& model : models) {
    for (double const angle : angles_degrees) {
      INFO("m " << model.m << ", seen from " << angle << " degrees");
      Integrals const integrals = integrate(program, model, viewer_at(angle));
      CHECK(sum_of(integrals.probability) == Approx(1 - probability_of_delta(model)).margin(2e-3));
      double const matt = (1 - model.reflect - model.transmit) * model.kd;
      CHECK(integrals.albedo.r < matt + model.ks + 1e-3);
      CHECK(integrals.albedo.r > matt + 0.3 * model.ks);
      CHECK(integrals.albedo.r + model.reflect + model.transmit < 1.001);
    }
  }
}

// 1 % in all for the 30 cases: 0.0335 % each (Sidak), which is 3.4 standard deviations of the normal distribution.
TEST_CASE("the samples of Phong's BSDF have the density that it says (chi-square)", "[kernel][bsdf][statistics]") {
  NEEDS_OPENCL_DEVICE();
  Random random(91);
  ProbeProgram const program = program_with(1);
  std::size_t const count = scaled_count(300000);
  for (Model const& model : models) {
    for (double const angle : angles_degrees) {
      INFO("m " << model.m << ", seen from " << angle << " degrees");
      Vec3 const viewer = viewer_at(angle);
      std::vector<double> const probability = integrate(program, model, viewer).probability;
      std::vector<float4> const viewers(count, to_float4(viewer));
      Samples const samples = sample(program, model, float(1 / model.ior), viewers, random_uniforms(random, count));
      std::vector<double> found(probability.size());
      std::size_t delta = 0;
      for (std::size_t i = 0; i < count; ++i) {
        if (samples.directions[i].w == 0) {
          ++delta;
          continue;
        }
        Vec3 const l = to_vec3(samples.directions[i]);
        double const theta = std::acos(std::clamp(l.z, -1.0, 1.0));
        double const phi = std::atan2(l.y, l.x) + (l.y < 0 ? 2 * pi : 0);
        std::size_t const row = std::min(std::size_t(theta / pi * theta_bins), theta_bins - 1);
        ++found[row * phi_bins + std::min(std::size_t(phi / (2 * pi) * phi_bins), phi_bins - 1)];
      }
      double const p_delta = probability_of_delta(model), mean = p_delta * double(count);
      CHECK(std::abs(double(delta) - mean) <= 4 * std::sqrt(mean * (1 - p_delta)));
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
      }
      REQUIRE(degrees > 2);
      CHECK(deviations(chi_square, degrees - 1) < 3.4);
    }
  }
}

TEST_CASE("the weights of Phong's samples are f cos / pdf, and shares for mirror and glass", "[kernel][bsdf]") {
  NEEDS_OPENCL_DEVICE();
  Random random(92);
  ProbeProgram const program = program_with(1);
  std::size_t const count = scaled_count(20000);
  for (Model const& model : models) {
    for (double const eta : {1 / model.ior, model.ior}) {
      std::vector<float4> viewers;
      for (std::size_t i = 0; i < count; ++i) {
        Vec3 o = random.direction();
        o.z = std::abs(o.z) + 1e-4;
        viewers.push_back(to_float4(glm::normalize(o)));
      }
      Samples const samples = sample(program, model, float(eta), viewers, random_uniforms(random, count));
      std::vector<float4> const values = evaluate(program, model, viewers, samples.directions);
      double const total = (1 - model.reflect - model.transmit) * model.kd + model.ks + model.reflect + model.transmit;
      for (std::size_t i = 0; i < count; ++i) {
        Vec3 const o = to_vec3(viewers[i]), l = to_vec3(samples.directions[i]), weight = to_vec3(samples.weights[i]);
        INFO("m " << model.m << ", eta " << eta << ", sample " << i);
        if (std::abs(glm::length(l) - 1) > 1e-5) FAIL("no unit vector");
        double const pdf = samples.directions[i].w;
        if (pdf > 0) {
          Vec3 const expected = to_vec3(values[i]) * std::max(l.z, 0.0) / double(values[i].w);
          if (max_abs(weight - expected) > 1e-3 * (1e-3 + max_abs(expected))) FAIL("weight");
          if (std::abs(pdf - values[i].w) > 1e-4 * pdf) FAIL("density");
          continue;
        }
        // Chosen by their shares of all, so each weighs that all.
        if (max_abs(weight - Vec3(total)) > 1e-4) FAIL("weight of mirror or glass");
        if (l.z > 0) {
          if (max_abs(l - Vec3(-o.x, -o.y, o.z)) > 1e-5) FAIL("mirrored");
        } else if (max_abs(Vec3(l.x, l.y, 0) + eta * Vec3(o.x, o.y, 0)) > 1e-5) {
          FAIL("Snell's law");
        }
      }
    }
  }
}

TEST_CASE("sixteen samples of Phong's BSDF at once are those of one by one, at the edges too",
          "[kernel][bsdf][layouts][lanes]") {
  NEEDS_OPENCL_DEVICE();
  Random random(93);
  ProbeProgram const one = program_with(1), sixteen = program_with(16);
  std::size_t const count = (scaled_count(20000) + 15) / 16 * 16;
  for (Model const& model : models) {
    std::vector<float4> viewers;
    auto uniforms = random_uniforms(random, count);
    for (std::size_t i = 0; i < count; ++i) {
      Vec3 o = random.direction();
      if (i % 8 != 0) o.z = std::abs(o.z);
      if (i % 5 == 0) o = {std::sqrt(1 - 1e-14), 0, 1e-7};
      viewers.push_back(to_float4(o));
      if (i % 3 == 0) uniforms[i] = {i % 2 == 0 ? 0 : 0x1.fffffep-1f, i % 4 < 2 ? 0 : 0x1.fffffep-1f};
    }
    Samples const a = sample(one, model, 0.7f, viewers, uniforms);
    Samples const b = sample(sixteen, model, 0.7f, viewers, uniforms, 16);
    CHECK(std::memcmp(a.weights.data(), b.weights.data(), count * sizeof(float4)) == 0);
    CHECK(std::memcmp(a.directions.data(), b.directions.data(), count * sizeof(float4)) == 0);
    auto const values = evaluate(one, model, viewers, a.directions);
    auto const values_of_sixteen = evaluate(sixteen, model, viewers, a.directions, 16);
    CHECK(std::memcmp(values.data(), values_of_sixteen.data(), count * sizeof(float4)) == 0);
    for (std::size_t i = 0; i < count; ++i) {
      INFO("m " << model.m << ", sample " << i);
      Vec3 const weight = to_vec3(a.weights[i]);
      if (!(max_abs(weight) < 1e3) || std::min({weight.x, weight.y, weight.z}) < 0) FAIL("weight");
      if (!std::isfinite(a.directions[i].w)) FAIL("density");
      if (viewers[i].z <= 0 && weight != Vec3(0)) FAIL("seen from below");
    }
  }
}
