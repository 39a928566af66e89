/// The BSDF: evaluate against formulae of another form in double precision, pdf and sample against each other.

#include <cstring>

#include "bsdf_probe.hpp"
#include "support/catch.hpp"
#include "support/skip.hpp"

using namespace lichtraum;
using namespace lichtraum::test;

namespace {

double tangent_squared(Vec3 const& w) { return (w.x * w.x + w.y * w.y) / (w.z * w.z); }
/// Smith's, as Heitz 2014 has it.
double lambda(double alpha, Vec3 const& w) { return (std::sqrt(1 + alpha * alpha * tangent_squared(w)) - 1) / 2; }
/// Walter et al. 2007, with tangents.
double distribution(double alpha, Vec3 const& h) {
  double const t = alpha * alpha + tangent_squared(h);
  return alpha * alpha / (pi * std::pow(h.z, 4) * t * t);
}
double schlick(double f0, double cosine) { return f0 + (1 - f0) * std::pow(1 - cosine, 5); }

/// f |l.z| of a solid, what it refracts: equation 21 of Walter et al. 2007, with `o` as where light comes from, so that
/// radiance is not scaled; the indices of refraction on the viewer's and on the light's side.
double refraction(double alpha, double n_o, double n_i, double f0, Vec3 const& o, Vec3 const& l) {
  Vec3 h = -glm::normalize(n_o * o + n_i * l);
  if (h.z < 0) h = -h;
  double const oh = glm::dot(o, h), lh = glm::dot(l, h);
  if (oh <= 0 || lh >= 0) return 0;
  // Schlick's factor is that of the side with the smaller index.
  double const fresnel = schlick(f0, n_o < n_i ? oh : -lh);
  double const masking = 1 / (1 + lambda(alpha, o) + lambda(alpha, l));
  double const f = oh * -lh / (o.z * -l.z) * n_i * n_i * (1 - fresnel) * masking * distribution(alpha, h) /
                   std::pow(n_o * oh + n_i * lh, 2);
  return f * -l.z;
}

/// What such a surface keeps of light from everywhere, by the distribution of its microfacets' normals.
double kept_by_solid(double alpha, double n_o, double n_i, double f0, double cosine) {
  constexpr int steps = 256, turns = 128;
  double const sine = std::sqrt(1 - cosine * cosine), eta = n_o / n_i;
  Vec3 const o(sine, 0, cosine);
  double sum = 0;
  for (int i = 0; i < steps; ++i) {
    double const rest = (i + 0.5) / steps;  // many of the steep ones
    double const tangent = alpha * std::sqrt(1 - rest * rest) / rest, z = 1 / std::sqrt(1 + tangent * tangent);
    for (int k = 0; k < turns; ++k) {
      double const phi = pi * (k + 0.5) / turns;
      Vec3 const h(tangent * z * std::cos(phi), tangent * z * std::sin(phi), z);
      double const facing = glm::dot(o, h), beyond = 1 - eta * eta * (1 - facing * facing);
      if (facing <= 0) continue;
      double const weight = 2 * rest * facing / (cosine * z);
      double const inner = std::sqrt(std::max(beyond, 0.0));
      double const fresnel = beyond <= 0 ? 1 : schlick(f0, eta > 1 ? inner : facing);
      auto const masking = [&](Vec3 const& l) { return 1 / (1 + lambda(alpha, o) + lambda(alpha, l)); };
      Vec3 const mirrored = 2 * facing * h - o, refracted = (eta * facing - inner) * h - eta * o;
      if (mirrored.z > 0) sum += weight * fresnel * masking(mirrored);
      if (beyond > 0 && refracted.z < 0) sum += weight * (1 - fresnel) * masking(refracted);
    }
  }
  return sum / (steps * turns);
}

/// Viewers above the surface, and lights all around it, half of those mirrored or nearly.
struct Directions {
  std::vector<float4> viewers, lights;
};
Directions random_directions(Random& random, std::size_t count) {
  Directions directions;
  for (std::size_t i = 0; i < count; ++i) {
    Vec3 o = random.direction(), l = random.direction();
    o.z = std::abs(o.z);
    if (i % 2 == 0) l = glm::normalize(Vec3(-o.x, -o.y, i % 4 == 0 ? o.z : -o.z) + random.in_cube(0.1));
    directions.viewers.push_back(to_float4(o));
    directions.lights.push_back(to_float4(l));
  }
  return directions;
}

/// The sphere in bins of equal angles: the probability of each, and what f cos sums up to, by Gauss's two points in
/// each step of the polar angle and the midpoint of each step of the azimuth.
constexpr std::size_t theta_bins = 80, phi_bins = 160;
struct Integrals {
  std::vector<double> probability = std::vector<double>(theta_bins * phi_bins);
  Vec3 albedo{0};
};

/// The polar angle at which what a solid refracts begins: there the microfacets' normals are at right angles to the
/// surface's, and rough ones have a density that ends in a step.
double first_refracted_angle(BsdfCase const& surface, Vec3 const& viewer) {
  double const ior = surface.parameters.ior, sine = viewer.z * (surface.from_outside ? 1 / ior : ior);
  return sine < 1 ? pi / 2 + std::asin(sine) : pi;
}

/// The highlight's width decides how fine.
Integrals integrate(BsdfProbe const& probe, BsdfCase const& surface, Vec3 const& viewer) {
  BsdfParameters const& p = surface.parameters;
  bool const is_solid = p.transmitted[0] > 0 && p.ior != 1;
  double const sharpest = p.alpha / p.stretch;
  double const width = std::min(p.coat > 0 ? double(p.coat_alpha) : 1, is_solid ? sharpest / 3 : sharpest);
  std::size_t const theta_steps = width < 0.04 ? 6 : width < 0.2 ? 4 : 3;
  // Microfacets that are met at a grazing angle hardly move the azimuth: there a highlight is narrow.
  std::size_t const phi_steps = (viewer.z < 0.1 ? 8 : viewer.z < 0.4 ? 4 : 2) * theta_steps;
  std::vector<float4> lights;
  std::vector<double> areas;
  double const phi_step = 2 * pi / double(phi_bins * phi_steps);
  double const step_angle = is_solid ? first_refracted_angle(surface, viewer) : pi;
  std::vector<Vec3> around;  // as many sines and cosines as there are lights would take longer than the device
  for (std::size_t k = 0; k < phi_bins * phi_steps; ++k) {
    around.push_back(direction_at(pi / 2, (double(k) + 0.5) * phi_step));
  }
  Integrals result;
  auto const add_lights = [&](double begin, double end) {
    double const theta_step = (end - begin) / double(theta_steps);
    for (std::size_t i = 0; i < 2 * theta_steps; ++i) {
      double const offset = (i % 2 == 0 ? 1 : -1) * std::sqrt(1 / 12.);
      double const theta = begin + (double(i / 2) + 0.5 + offset) * theta_step;
      double const sine = std::sin(theta), cosine = std::cos(theta), area = sine * theta_step / 2 * phi_step;
      for (Vec3 const& direction : around) {
        lights.push_back(to_float4(Vec3(sine * direction.x, sine * direction.y, cosine)));
        areas.push_back(area);
      }
    }
  };
  for (std::size_t row = 0; row < theta_bins; ++row) {
    lights.clear();
    areas.clear();
    double const begin = pi * double(row) / theta_bins, end = pi * double(row + 1) / theta_bins;
    double const middle = std::clamp(step_angle, begin, end);
    if (middle > begin) add_lights(begin, middle);
    if (middle < end) add_lights(middle, end);
    std::vector<float4> const viewers(lights.size(), to_float4(viewer));
    std::vector<float4> const values = probe.evaluate(surface, viewers, lights);
    for (std::size_t i = 0; i < values.size(); ++i) {
      std::size_t const column = i % (phi_bins * phi_steps) / phi_steps;
      result.probability[row * phi_bins + column] += double(values[i].w) * areas[i];
      result.albedo += to_vec3(values[i]) * areas[i];
    }
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

/// How far counts in bins are from what their probabilities let one expect, in standard deviations.
double chi_square_deviations(std::vector<double> const& found, std::vector<double> const& probability, double count) {
  double chi_square = 0, degrees = 0, rare_expected = 0, rare_found = 0;
  for (std::size_t i = 0; i < found.size(); ++i) {
    double const expected = probability[i] * count;
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
  return degrees > 2 ? deviations(chi_square, degrees - 1) : infinity;
}

/// Draws `count` samples and compares their counts in bins, of those that are lost, and of mirror and glass with what
/// the densities say.
void check_density(BsdfProbe const& probe, BsdfCase const& surface, double angle, std::size_t count, Random& random) {
  INFO(surface.name << ", seen from " << angle << " degrees");
  Vec3 const viewer = viewer_at(angle);
  std::vector<double> const probability = integrate(probe, surface, viewer).probability;
  std::vector<float4> const viewers(count, to_float4(viewer));
  auto const samples = probe.sample(surface, viewers, random_uniforms(random, count));
  std::vector<double> found(probability.size());
  std::size_t delta = 0, lost = 0;
  for (std::size_t i = 0; i < count; ++i) {
    if (samples.directions[i].w == 0) {
      ++(to_vec3(samples.weights[i]) == Vec3(0) ? lost : delta);
      continue;
    }
    Vec3 const l = to_vec3(samples.directions[i]);
    double const theta = std::acos(std::clamp(l.z, -1.0, 1.0));
    double const phi = std::atan2(l.y, l.x) + (l.y < 0 ? 2 * pi : 0);
    std::size_t const row = std::min(std::size_t(theta / pi * theta_bins), theta_bins - 1);
    ++found[row * phi_bins + std::min(std::size_t(phi / (2 * pi) * phi_bins), phi_bins - 1)];
  }
  BsdfProbe::Choices const choices = probe.choices(surface, {to_float4(viewer)}).front();
  CHECK(choices.sum() == Approx(1).margin(1e-6));
  double const n = double(count);
  CAPTURE(double(lost) / n, 1 - choices.delta() - sum_of(probability));
  auto const is_likely = [&](std::size_t number, double p) {
    double const quadrature_error = 5e-4;
    return std::abs(double(number) - p * n) <= 4.5 * std::sqrt(std::max(p * (1 - p), 0.0) * n) + quadrature_error * n;
  };
  CHECK(is_likely(delta, choices.delta()));
  CHECK(is_likely(lost, 1 - choices.delta() - sum_of(probability)));
  CHECK(chi_square_deviations(found, probability, n) < 4);
}

}  // namespace

TEST_CASE("the BSDF without layers is Lambert's and GGX's formula, and reciprocal", "[kernel][bsdf]") {
  NEEDS_OPENCL_DEVICE();
  Random random(90);
  BsdfProbe const probe;
  std::size_t const count = scaled_count(20000);
  for (BsdfCase const& surface : bsdf_cases()) {
    BsdfParameters const& p = surface.parameters;
    if (p.is_layered != 0 || surface.smooth_normal.z != 1) continue;
    Directions const directions = random_directions(random, count);
    std::vector<float4> const values = probe.evaluate(surface, directions.viewers, directions.lights);
    std::vector<float4> const swapped = probe.evaluate(surface, directions.lights, directions.viewers);
    for (std::size_t i = 0; i < count; ++i) {
      Vec3 const o = to_vec3(directions.viewers[i]), l = to_vec3(directions.lights[i]);
      if (std::abs(l.z) < 1e-3 || o.z < 1e-3) continue;
      double const alpha = p.alpha;
      Vec3 const h = glm::normalize(o + l);
      double const gloss = distribution(alpha, h) / ((1 + lambda(alpha, o) + lambda(alpha, l)) * 4 * o.z * l.z);
      Vec3 const f = to_vec3(p.diffuse) / pi + gloss * to_vec3(p.f0);
      Vec3 const expected = l.z > 0 ? f * l.z : Vec3(0);
      INFO(surface.name << ", case " << i);
      // The sharpest highlight magnifies a rounding of h by 1 / alpha.
      if (max_abs(to_vec3(values[i]) - expected) > 1e-4 * (max_abs(expected) + 1e-3)) FAIL("f");
      if (max_abs(to_vec3(values[i]) * o.z - to_vec3(swapped[i]) * l.z) > 1e-4 * max_abs(expected) * o.z) {
        FAIL("reciprocity");
      }
    }
  }
}

TEST_CASE("stretched microfacets are GGX with two widths, and reciprocal", "[kernel][bsdf]") {
  NEEDS_OPENCL_DEVICE();
  Random random(97);
  BsdfProbe const probe;
  std::size_t const count = scaled_count(4000);
  for (double const roughness : {0.2, 0.5, 0.9}) {
    for (double const strength : {0.1, 0.5, 1.0}) {
      BsdfParameters p = phong_bsdf(0, 1, roughness * roughness);
      p = stretched(p, strength);
      double const along_y = roughness * roughness, along_x = std::lerp(along_y, 1.0, strength * strength);
      // Heitz 2014: the surface scaled by 1 / width along each axis has facets of width 1.
      auto const narrowed = [&](Vec3 const& h) { return Vec3(h.x / along_x, h.y / along_y, h.z); };
      auto const widened = [&](Vec3 const& w) { return Vec3(w.x * along_x, w.y * along_y, w.z); };
      Directions const directions = random_directions(random, count);
      BsdfCase const surface{"", p};
      std::vector<float4> const values = probe.evaluate(surface, directions.viewers, directions.lights);
      std::vector<float4> const swapped = probe.evaluate(surface, directions.lights, directions.viewers);
      for (std::size_t i = 0; i < count; ++i) {
        Vec3 const o = to_vec3(directions.viewers[i]), l = to_vec3(directions.lights[i]);
        if (std::abs(l.z) < 1e-3 || o.z < 1e-3) continue;
        Vec3 const h = glm::normalize(o + l);
        double const length = glm::length(narrowed(h));
        double const d = 1 / (pi * along_x * along_y * std::pow(length, 4));
        double const masking = 1 / (1 + lambda(1, widened(o)) + lambda(1, widened(l)));
        Vec3 const expected = l.z > 0 ? d * masking / (4 * o.z) * to_vec3(p.f0) : Vec3(0);
        CAPTURE(roughness, strength, i, values[i].x, expected.x);
        if (max_abs(to_vec3(values[i]) - expected) > 1e-4 * (max_abs(expected) + 1e-3)) FAIL("f");
        if (max_abs(to_vec3(values[i]) * o.z - to_vec3(swapped[i]) * l.z) > 1e-4 * max_abs(expected) * o.z) {
          FAIL("reciprocity");
        }
      }
    }
  }
}

TEST_CASE("sheen is the formula of KHR_materials_sheen, and reciprocal", "[kernel][bsdf]") {
  NEEDS_OPENCL_DEVICE();
  Random random(96);
  BsdfProbe const probe;
  std::size_t const count = scaled_count(4000);
  for (double const roughness : {0.07, 0.15, 0.3, 0.5, 0.8, 1.0}) {
    double const alpha = roughness * roughness;
    auto const masking = [&](double x) {  // Lambda, as the extension's text has it
      auto const mixed = [&](double rough, double smooth) { return std::lerp(rough, smooth, std::pow(1 - alpha, 2)); };
      auto const fit = [&](double y) {
        return mixed(21.5473, 25.3245) / (1 + mixed(3.82987, 3.32435) * std::pow(y, mixed(0.19823, 0.16801))) +
               mixed(-1.9776, -1.27393) * y + mixed(-4.32054, -4.85967);
      };
      return x < 0.5 ? std::exp(fit(x)) : std::exp(2 * fit(0.5) - fit(1 - x));
    };
    BsdfCase const surface{"", with_sheen(black_bsdf(), 0.9, roughness, true)};
    Directions const directions = random_directions(random, count);
    std::vector<float4> const values = probe.evaluate(surface, directions.viewers, directions.lights);
    std::vector<float4> const swapped = probe.evaluate(surface, directions.lights, directions.viewers);
    for (std::size_t i = 0; i < count; ++i) {
      Vec3 const o = to_vec3(directions.viewers[i]), l = to_vec3(directions.lights[i]);
      if (std::abs(l.z) < 2e-3 || o.z < 2e-3) continue;
      Vec3 const h = glm::normalize(o + l);
      double const sine = std::hypot(h.x, h.y);
      double const f = (2 + 1 / alpha) * std::pow(sine, 1 / alpha) / (2 * pi) /
                       ((1 + masking(o.z) + masking(std::abs(l.z))) * 4 * o.z * l.z);
      Vec3 const expected = l.z > 0 ? f * l.z * to_vec3(surface.parameters.sheen) : Vec3(0);
      Vec3 const found = to_vec3(values[i]);
      CAPTURE(roughness, i, o.z, l.z, found.x, expected.x);
      if (found.x > 1.0001 * expected.x + 1e-6) FAIL("more than the formula");
      // It reflects more than arrives where thin fuzz is met at a grazing angle, and only there.
      if (roughness < 0.3 && std::min(o.z, l.z) < 0.15) continue;
      if (max_abs(found - expected) > 1e-4 * max_abs(expected) + 1e-6) FAIL("f");
      if (max_abs(found * o.z - to_vec3(swapped[i]) * l.z) > 1e-4 * max_abs(expected) + 1e-6) FAIL("reciprocity");
    }
  }
}

TEST_CASE("a solid refracts by Walter's formula, from outside and from within", "[kernel][bsdf]") {
  NEEDS_OPENCL_DEVICE();
  Random random(95);
  BsdfProbe const probe;
  std::size_t const count = scaled_count(500);
  for (double const roughness : {0.2, 0.4, 0.7, 1.0}) {
    for (double const ior : {1.1, 1.5, 2.4}) {
      for (bool const from_outside : {true, false}) {
        BsdfCase const surface{"", transmitting(layered_bsdf(1, 0, roughness), 1, ior), from_outside};
        double const n_o = from_outside ? 1 : ior, n_i = from_outside ? ior : 1, eta = n_o / n_i;
        double const alpha = surface.parameters.alpha, f0 = surface.parameters.f0[0];
        for (double const degrees : viewer_angles_degrees) {
          Vec3 const o = viewer_at(degrees);
          std::vector<float4> lights;
          while (lights.size() < count) {  // refracted at a microfacet
            Vec3 h = random.direction() * alpha;
            h = glm::normalize(Vec3(h.x, h.y, 1));
            double const cosine = glm::dot(o, h), rest = 1 - eta * eta * (1 - cosine * cosine);
            Vec3 const l =
                cosine > 0 && rest > 0 ? (eta * cosine - std::sqrt(rest)) * h - eta * o : -random.direction();
            lights.push_back(to_float4(l));
          }
          auto const values = probe.evaluate(surface, std::vector<float4>(count, to_float4(o)), lights);
          // Light that microfacets refract again is put to that which they do once.
          double const gain = 1 / kept_by_solid(alpha, n_o, n_i, f0, o.z);
          double first_ratio = 0;
          for (std::size_t i = 0; i < count; ++i) {
            Vec3 const l = to_vec3(lights[i]);
            if (l.z > -1e-2) continue;
            double const once = refraction(alpha, n_o, n_i, f0, o, l);
            CAPTURE(roughness, ior, from_outside, degrees, i, values[i].x, once, gain);
            if (once < 1e-3) {
              if (values[i].x > 2e-3 * gain) FAIL("light from nowhere");
              continue;
            }
            double const ratio = values[i].x / once;
            if (first_ratio == 0) first_ratio = ratio;
            // Where both sides bend alike, the half vector is the difference of two large ones.
            if (std::abs(ratio - first_ratio) > 4e-3 * first_ratio) FAIL("f");
          }
          CAPTURE(roughness, ior, from_outside, degrees);
          if (first_ratio > 0) CHECK(first_ratio == Approx(gain).epsilon(0.04));  // of its table
        }
      }
    }
  }
}

TEST_CASE("the BSDF keeps no more light than arrives, by quadrature", "[kernel][bsdf][statistics]") {
  NEEDS_OPENCL_DEVICE();
  BsdfProbe const probe(quickest_lanes());
  for (BsdfCase const& surface : bsdf_cases(some_roughnesses)) {
    BsdfParameters const& p = surface.parameters;
    for (double const angle : {0.0, 60.0, 80.0}) {
      INFO(surface.name << ", seen from " << angle << " degrees");
      double const albedo = integrate(probe, surface, viewer_at(angle)).albedo.r;
      double const all = p.is_layered != 0 ? std::max(p.diffuse[0] + p.translucent[0] + p.transmitted[0], p.metal[0])
                                           : p.diffuse[0] + p.f0[0];
      CHECK(albedo <= (p.is_layered == 0 ? all + 1e-3 : p.ior != 1 ? 1.005 : 1.002));  // of the solids' table
      CHECK(albedo > 0.3 * all);
    }
  }
}

// 5 of each 100,000 right densities fail: 0.2 % in all.
TEST_CASE("samples of the BSDF have the density that it says (chi-square)", "[kernel][bsdf][statistics]") {
  NEEDS_OPENCL_DEVICE();
  Random random(91);
  BsdfProbe const probe(quickest_lanes());
  for (BsdfCase const& surface : bsdf_cases(some_roughnesses)) {
    check_density(probe, surface, 60, scaled_count(300000), random);
  }
}
namespace {
void check_densities_from_everywhere(std::size_t samples) {
  Random random(94);
  BsdfProbe const probe(quickest_lanes());
  for (BsdfCase const& surface : bsdf_cases()) {
    for (double const angle : viewer_angles_degrees) check_density(probe, surface, angle, samples, random);
  }
}
}  // namespace
TEST_CASE("samples of the BSDF have the density that it says, from everywhere", "[kernel][bsdf][statistics][long]") {
  NEEDS_OPENCL_DEVICE();
  check_densities_from_everywhere(scaled_count(400000));
}
TEST_CASE("many samples of the BSDF have the density that it says, from everywhere",
          "[kernel][bsdf][statistics][long][.]") {
  NEEDS_OPENCL_DEVICE();
  check_densities_from_everywhere(scaled_count(1000000));
}

TEST_CASE("the weights of the BSDF's samples are f cos / pdf, and shares for mirror and glass", "[kernel][bsdf]") {
  NEEDS_OPENCL_DEVICE();
  Random random(92);
  BsdfProbe const probe;
  std::size_t const count = scaled_count(5000);
  for (BsdfCase const& surface : bsdf_cases()) {
    BsdfParameters const& p = surface.parameters;
    std::vector<float4> viewers;
    for (std::size_t i = 0; i < count; ++i) {
      Vec3 o = random.direction();
      o.z = std::abs(o.z) + 1e-4;
      viewers.push_back(to_float4(glm::normalize(o)));
    }
    auto const samples = probe.sample(surface, viewers, random_uniforms(random, count));
    std::vector<float4> const values = probe.evaluate(surface, viewers, samples.directions);
    auto const choices = probe.choices(surface, viewers);
    double const eta = surface.from_outside ? 1 / p.ior : p.ior;
    for (std::size_t i = 0; i < count; ++i) {
      Vec3 const o = to_vec3(viewers[i]), l = to_vec3(samples.directions[i]), weight = to_vec3(samples.weights[i]);
      INFO(surface.name << ", sample " << i);
      if (std::abs(glm::length(l) - 1) > 1e-5) FAIL("no unit vector");
      double const pdf = samples.directions[i].w;
      if (pdf > 0) {
        Vec3 const expected = to_vec3(values[i]) / double(values[i].w);
        if (max_abs(weight - expected) > 1e-3 * (1e-3 + max_abs(expected))) FAIL("weight");
        if (std::abs(pdf - values[i].w) > 1e-4 * pdf) FAIL("density");
        continue;
      }
      if (p.mirror + p.glass == 0 || weight == Vec3(0)) {
        if (weight != Vec3(0)) FAIL("a lost sample weighs something");
        continue;
      }
      // The share over its probability, so both weigh the same.
      if (std::abs(weight.x * choices[i].delta() - p.mirror - p.glass) > 1e-4) FAIL("weight of mirror or glass");
      if (l.z > 0) {
        if (max_abs(l - Vec3(-o.x, -o.y, o.z)) > 1e-5) FAIL("mirrored");
      } else if (max_abs(Vec3(l.x, l.y, 0) + eta * Vec3(o.x, o.y, 0)) > 1e-5) {
        FAIL("Snell's law");
      }
    }
  }
}

// The table of what solids reflect from within is too coarse for the critical angle: paths would be chosen there that
// hardly count, and others count for many.
TEST_CASE("nearly smooth solids choose what they mirror from within as often as there is light of it",
          "[kernel][bsdf]") {
  NEEDS_OPENCL_DEVICE();
  double const ior = 1.5, critical_cosine = std::sqrt(1 - 1 / (ior * ior));
  BsdfCase const surface{"solid", transmitting(layered_bsdf(1, 0, 0.1), 1, ior), false};
  std::vector<float4> viewers;
  std::vector<double> expected;
  double const least = 0.01;  // some microfacets always do the other
  for (double cosine = 0.3; cosine < 1; cosine += 0.005) {
    double const refracted = 1 - ior * ior * (1 - cosine * cosine);
    double const mirrored = refracted <= 0 ? 1 : schlick(0.04, std::sqrt(refracted));
    if (std::abs(cosine - critical_cosine) < 0.01) continue;  // where it rises steeply
    viewers.push_back(to_float4(Vec3(std::sqrt(1 - cosine * cosine), 0, cosine)));
    expected.push_back(std::max(mirrored, least) / (std::max(mirrored, least) + std::max(1 - mirrored, least)));
  }
  auto const choices = BsdfProbe().choices(surface, viewers);
  for (std::size_t i = 0; i < viewers.size(); ++i) {
    INFO("cosine " << viewers[i].z);
    CHECK(choices[i].glossy == Approx(expected[i]).margin(0.005));
  }
}

TEST_CASE("sixteen samples of the BSDF at once are those of one by one, at the edges too",
          "[kernel][bsdf][layouts][lanes]") {
  NEEDS_OPENCL_DEVICE();
  Random random(93);
  BsdfProbe const one, sixteen(16);
  std::size_t const count = (scaled_count(5000) + 15) / 16 * 16;
  std::vector<BsdfCase> cases = bsdf_cases();
  for (double const ior : {1.0, 1.0005, 1.5}) {  // as smooth as can be
    for (bool const from_outside : {true, false}) {
      cases.push_back({"smooth solid", transmitting(layered_bsdf(1, 0, 0), 1, ior), from_outside});
    }
  }
  cases.push_back({"black", black_bsdf()});
  for (BsdfCase const& surface : cases) {
    std::vector<float4> viewers;
    auto uniforms = random_uniforms(random, count);
    for (std::size_t i = 0; i < count; ++i) {
      Vec3 o = random.direction();
      if (i % 8 != 0) o.z = std::abs(o.z);
      if (i % 5 == 0) o = {std::sqrt(1 - 1e-14), 0, 1e-7};
      viewers.push_back(to_float4(o));
      auto const edge = [](bool is_low) { return is_low ? 0 : 0x1.fffffep-1f; };
      if (i % 3 == 0) uniforms[i] = {edge(i % 7 < 3), edge(i % 2 == 0), edge(i % 4 < 2), 0};
    }
    auto const a = one.sample(surface, viewers, uniforms);
    auto const b = sixteen.sample(surface, viewers, uniforms);
    INFO(surface.name);
    CHECK(std::memcmp(a.weights.data(), b.weights.data(), count * sizeof(float4)) == 0);
    CHECK(std::memcmp(a.directions.data(), b.directions.data(), count * sizeof(float4)) == 0);
    auto const values = one.evaluate(surface, viewers, a.directions);
    auto const values_of_sixteen = sixteen.evaluate(surface, viewers, a.directions);
    CHECK(std::memcmp(values.data(), values_of_sixteen.data(), count * sizeof(float4)) == 0);
    for (std::size_t i = 0; i < count; ++i) {
      INFO("sample " << i);
      Vec3 const weight = to_vec3(a.weights[i]);
      if (!(max_abs(weight) < 1e3) || std::min({weight.x, weight.y, weight.z}) < 0) FAIL("weight");
      if (!std::isfinite(a.directions[i].w)) FAIL("density");
      if (viewers[i].z <= 0 && weight != Vec3(0)) FAIL("seen from below");
    }
  }
}
