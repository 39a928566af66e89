/// Interference in thin films: the paper's formulas in double precision, and the waves that they sum up.

#include <complex>

#include "bsdf_probe.hpp"
#include "reference/thin_film.hpp"
#include "support/catch.hpp"
#include "support/skip.hpp"

using namespace lichtraum;
using namespace lichtraum::test;

namespace {

struct FilmCase {
  double ior, thickness_nm, cosine;
  Rgb f0;
};

std::vector<Vec3> reflectances(std::vector<FilmCase> const& cases) {
  std::vector<float4> films, bases, found(cases.size());
  for (FilmCase const& c : cases) {
    films.push_back(to_float4(Vec3(c.ior, c.thickness_nm, c.cosine)));
    bases.push_back(to_float4(c.f0));
  }
  ProbeProgram("bsdf.cl", "-D LANES=1").run("probe_thin_film", cases.size(), {in(films), in(bases), out(found)});
  std::vector<Vec3> result;
  for (float4 const& v : found) result.push_back(to_vec3(v));
  return result;
}

std::vector<FilmCase> random_cases(std::size_t count) {
  Random random(2017);
  std::vector<FilmCase> cases;
  for (std::size_t i = 0; i < count; ++i) {
    cases.push_back({random.uniform(1, 2.5),
                     random.uniform(0, 1200),
                     random.uniform(0.02, 1),
                     {random.uniform(), random.uniform(), std::pow(random.uniform(), 4)}});
  }
  return cases;
}

double schlick(double f0, double cosine) { return f0 + (1 - f0) * std::pow(1 - cosine, 5); }

/// The film's two sides: the amplitudes that they reflect, coming from air, and the way through it and back.
struct Sides {
  double upper, lower, way_meters;
};
Sides sides_of(FilmCase const& film, double f0) {
  double const within = std::sqrt(1 - (1 - film.cosine * film.cosine) / (film.ior * film.ior));
  double const s = (film.cosine - film.ior * within) / (film.cosine + film.ior * within);
  double const p = (film.ior * film.cosine - within) / (film.ior * film.cosine + within);
  double const base = (1 + std::sqrt(f0)) / (1 - std::sqrt(f0));
  double const lower = std::sqrt(schlick(std::pow((base - film.ior) / (base + film.ior), 2), within));
  return {std::sqrt((s * s + p * p) / 2), std::copysign(lower, base - film.ior),
          2e-9 * film.ior * film.thickness_nm * within};
}

/// Of one wavelength: all waves that leave the film, summed. The wavenumber in 1/m.
double reflectance_of_wave(Sides const& sides, double wavenumber) {
  std::complex<double> const late = sides.lower * std::polar(1.0, 2 * pi * sides.way_meters * wavenumber);
  return std::norm((sides.upper + late) / (1.0 + sides.upper * late));
}

/// How much is left out by ending the series of orders after the second, at most.
double omitted_orders(Sides const& sides) {
  double const r = std::abs(sides.upper * sides.lower), passed = 1 - sides.upper * sides.upper;
  double const returned = passed * passed * sides.lower * sides.lower / (1 - r * r);
  return 2 * std::abs(returned - passed) * r * r * r / (1 - r);
}

}  // namespace

TEST_CASE("thin films reflect what the formulas say in double precision", "[kernel][bsdf]") {
  NEEDS_OPENCL_DEVICE();
  auto const cases = random_cases(scaled_count(20000));
  auto const found = reflectances(cases);
  double error = 0;
  for (std::size_t i = 0; i < cases.size(); ++i) {
    auto const& [ior, thickness_nm, cosine, f0] = cases[i];
    error = std::max(error, max_abs(found[i] - thin_film_reflectance(ior, thickness_nm, cosine, f0)));
    REQUIRE(glm::all(glm::greaterThanEqual(found[i], Vec3(0))));
    REQUIRE(glm::all(glm::lessThanEqual(found[i], Vec3(1))));
  }
  CHECK(error < 1e-4);  // phases of 60 radians as floats, times colours of up to 4
}

TEST_CASE("thin films reflect the mean over wavelengths of all their waves", "[kernel][bsdf]") {
  NEEDS_OPENCL_DEVICE();
  // The observer's Gaussians of the wavenumber, as the paper has them, and X, Y, Z and X again in sRGB.
  constexpr std::array<double, 4> value{5.4856e-13, 4.4201e-13, 5.2481e-13, 9.7470e-14};
  constexpr std::array<double, 4> position{1.6810e6, 1.7953e6, 2.2084e6, 2.2399e6};
  constexpr std::array<double, 4> variance{4.3278e9, 9.3046e9, 6.6121e9, 4.5282e9};
  constexpr std::array<std::array<double, 4>, 3> srgb{{{3.2404542, -1.5371385, -0.4985314, 3.2404542},
                                                       {-0.9692660, 1.8760108, 0.0415560, -0.9692660},
                                                       {0.0556434, -0.2040259, 1.0572252, 0.0556434}}};
  auto const cases = random_cases(scaled_count(500));
  auto const found = reflectances(cases);
  for (std::size_t i = 0; i < cases.size(); ++i) {
    for (std::size_t c = 0; c < 3; ++c) {
      Sides const sides = sides_of(cases[i], cases[i].f0[int(c)]);
      double sum = 0, white = 0, size = 0;
      for (std::size_t g = 0; g < value.size(); ++g) {
        double mean = 0, total = 0;
        for (int k = -80; k <= 80; ++k) {
          double const deviations = k / 16.0, density = std::exp(-deviations * deviations / 2);
          mean += density * reflectance_of_wave(sides, position[g] + deviations * std::sqrt(2 * variance[g]));
          total += density;
        }
        double const weight = srgb[c][g] * value[g] * std::sqrt(variance[g]);
        sum += weight * mean / total;
        white += weight;
        size += std::abs(weight);
      }
      INFO("ior " << cases[i].ior << ", " << cases[i].thickness_nm << " nm, cosine " << cases[i].cosine << ", f0 "
                  << cases[i].f0[int(c)]);
      CHECK(std::abs(found[i][int(c)] - std::clamp(sum / white, 0.0, 1.0)) <=
            omitted_orders(sides) * size / white + 1e-4);
    }
  }
}

TEST_CASE("a film that bends no light shows what is below, whatever its thickness", "[kernel][bsdf]") {
  NEEDS_OPENCL_DEVICE();
  auto cases = random_cases(scaled_count(1000));
  for (FilmCase& film : cases) film.ior = 1;
  auto const found = reflectances(cases);
  for (std::size_t i = 0; i < cases.size(); ++i) {
    for (int c = 0; c < 3; ++c) {
      CHECK(found[i][c] == Approx(schlick(cases[i].f0[c], cases[i].cosine)).margin(1e-5));
    }
  }
}

TEST_CASE("thin films on glass: a quarter of a wave takes reflections away, half a wave does nothing",
          "[kernel][bsdf]") {
  NEEDS_OPENCL_DEVICE();
  // Index 1.5 under 1.2247, its root; green's waves are 557 nm long in air.
  double const quarter_nm = 557 / (4 * std::sqrt(1.5));
  auto const found =
      reflectances({{std::sqrt(1.5), quarter_nm, 1, Rgb(0.04)}, {std::sqrt(1.5), 2 * quarter_nm, 1, Rgb(0.04)}});
  CHECK(found[0].g < 0.002);
  CHECK(found[0].r > found[0].g);
  CHECK(found[0].b > found[0].g);
  CHECK(found[1].g > 0.03);
}
