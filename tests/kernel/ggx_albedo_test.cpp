/// The table of what GGX reflects in all, against a quadrature of another form.

#include "bsdf_probe.hpp"
#include "support/catch.hpp"
#include "support/skip.hpp"

using namespace lichtraum;
using namespace lichtraum::test;

namespace {

struct Albedo {
  double a = 0, b = 0;
};

/// Over all normals of microfacets, by their distribution: those that the viewer does not see, and those that mirror
/// light from below the surface, count nothing.
Albedo reflected_by_ggx(double alpha, double cosine) {
  constexpr int steps = 400, turns = 400;
  auto const lambda = [&](double z) { return (std::sqrt(1 + alpha * alpha * (1 - z * z) / (z * z)) - 1) / 2; };
  double const sine = std::sqrt(1 - cosine * cosine);
  Albedo sum;
  for (int i = 0; i < steps; ++i) {
    double const rest = (i + 0.5) / steps;  // 1 - u is its square: many of the steep ones
    double const tangent = alpha * std::sqrt(1 - rest * rest) / rest;
    double const z = 1 / std::sqrt(1 + tangent * tangent);
    for (int k = 0; k < turns; ++k) {
      double const facing = sine * tangent * z * std::cos(pi * (k + 0.5) / turns) + cosine * z;
      double const cosine_in = 2 * facing * z - cosine;
      if (facing <= 0 || cosine_in <= 0) continue;
      double const weight = 2 * rest * facing / (cosine * z) / (1 + lambda(cosine) + lambda(cosine_in));
      double const grazing = std::pow(1 - facing, 5);
      sum.a += (1 - grazing) * weight;
      sum.b += grazing * weight;
    }
  }
  return {sum.a / (steps * turns), sum.b / (steps * turns)};
}

}  // namespace

TEST_CASE("the table of GGX's albedo is right between its entries", "[kernel][bsdf]") {
  NEEDS_OPENCL_DEVICE();
  Random random(96);
  std::vector<float> alphas, cosines;
  for (std::size_t i = 0; i < 300; ++i) {
    double const roughness = random.uniform(0.1, 1);
    alphas.push_back(float(roughness * roughness));
    cosines.push_back(float(random.uniform(0.03, 1)));
  }
  for (float const alpha : {0.01f, 1.0f}) {  // its edges
    for (float const cosine : {0.033f, 1.0f}) {
      alphas.push_back(alpha);
      cosines.push_back(cosine);
    }
  }
  std::vector<std::array<float, 2>> found(alphas.size());
  ProbeProgram("bsdf.cl", "-D LANES=1").run("probe_ggx_albedo", found.size(), {in(alphas), in(cosines), out(found)});
  for (std::size_t i = 0; i < found.size(); ++i) {
    Albedo const expected = reflected_by_ggx(alphas[i], cosines[i]);
    CAPTURE(alphas[i], cosines[i], expected.a, expected.b, found[i][0], found[i][1]);
    // Between entries the table is straight, where a and b bend.
    CHECK(std::abs(found[i][0] - expected.a) < 2.5e-3);
    CHECK(std::abs(found[i][1] - expected.b) < 2.5e-3);
    CHECK(std::abs(double(found[i][0]) + found[i][1] - expected.a - expected.b) < 2.5e-3);
  }
}
