#include "shared/tone_map.h"

#include <array>
#include <cmath>
#include <glm/mat3x3.hpp>
#include <limits>
#include <utility>

#include "lichtraum/math.hpp"
#include "support/catch.hpp"

// Tone maps against their definitions in double precision, and what each of them promises.

using namespace lichtraum;

namespace {

Vec3 toned(Vec3 const& c, device::uint tone_map) {
  auto const [r, g, b] = device::map_tone({float(c.x), float(c.y), float(c.z)}, tone_map);
  return {double(r), double(g), double(b)};
}

/// Rows, as they are printed.
Vec3 multiplied(std::array<Vec3, 3> const& rows, Vec3 const& v) {
  return {glm::dot(rows[0], v), glm::dot(rows[1], v), glm::dot(rows[2], v)};
}

Vec3 displayed(Vec3 const& v) { return glm::clamp(v, 0.0, 1.0); }

/// The specification's steps, one after the other.
Vec3 neutral(Vec3 c) {
  double const x = std::min({c.r, c.g, c.b});
  c -= x < 0.08 ? x - 6.25 * x * x : 0.04;
  double const p = std::max({c.r, c.g, c.b});
  if (p < 0.76) return displayed(c);
  double const n = 1 - 0.24 * 0.24 / (p - 0.52);
  double const g = 1 / (0.15 * (p - n) + 1);
  return displayed(glm::mix(Vec3(n), c * (n / p), g));
}

Vec3 aces(Vec3 c) {
  c = multiplied({Vec3(0.59719, 0.35458, 0.04823), Vec3(0.076, 0.90834, 0.01566), Vec3(0.0284, 0.13383, 0.83777)},
                 c / 0.6);
  for (int i = 0; i < 3; ++i) {
    c[i] = (c[i] * (c[i] + 0.0245786) - 0.000090537) / (c[i] * (0.983729 * c[i] + 0.432951) + 0.238081);
  }
  return displayed(multiplied(
      {Vec3(1.60475, -0.53108, -0.07367), Vec3(-0.10208, 1.10813, -0.00605), Vec3(-0.00327, -0.07276, 1.07602)}, c));
}

/// With the matrix to Rec. 2020 apart, as ITU-R BT.2087 prints it.
Vec3 agx(Vec3 c) {
  c = multiplied({Vec3(0.6274, 0.3293, 0.0433), Vec3(0.0691, 0.9195, 0.0114), Vec3(0.0164, 0.0880, 0.8956)}, c);
  c = multiplied({Vec3(0.856627153315983, 0.0951212405381588, 0.0482516061458583),
                  Vec3(0.137318972929847, 0.761241990602591, 0.101439036467562),
                  Vec3(0.11189821299995, 0.0767994186031903, 0.811302368396859)},
                 c);
  for (int i = 0; i < 3; ++i) {
    double const x = std::clamp((std::log2(std::max(c[i], 1e-10)) + 12.47393) / 16.5, 0.0, 1.0);
    c[i] = 15.5 * std::pow(x, 6) - 40.14 * std::pow(x, 5) + 31.96 * std::pow(x, 4) - 6.868 * std::pow(x, 3) +
           0.4298 * x * x + 0.1191 * x - 0.00232;
  }
  c = multiplied({Vec3(1.1271005818144368, -0.11060664309660323, -0.016493938717834573),
                  Vec3(-0.1413297634984383, 1.157823702216272, -0.016493938717834257),
                  Vec3(-0.1413297634984384, -0.11060664309660294, 1.2519364065950405)},
                 c);
  for (int i = 0; i < 3; ++i) c[i] = std::pow(std::max(c[i], 0.0), 2.2);
  return displayed(
      multiplied({Vec3(1.6605, -0.5876, -0.0729), Vec3(-0.1246, 1.1329, -0.0083), Vec3(-0.0182, -0.1006, 1.1187)}, c));
}

constexpr std::array curves{TONE_MAP_NEUTRAL, TONE_MAP_AGX, TONE_MAP_ACES};

double largest_difference(Vec3 const& a, Vec3 const& b) {
  Vec3 const d = glm::abs(a - b);
  return std::max({d.x, d.y, d.z});
}

}  // namespace

TEST_CASE("tone maps are their definitions", "[unit][develop]") {
  // BT.2087 has four digits.
  std::array<std::pair<Vec3 (*)(Vec3), double>, 3> const definitions{{{neutral, 1e-6}, {agx, 4e-4}, {aces, 1e-6}}};
  for (double r = 1e-4; r < 1e5; r *= 2.3) {
    for (double g = 1e-4; g < 1e5; g *= 3.1) {
      for (double b : {0.0, 0.003, 0.4, 1.0, 37.0}) {
        for (std::size_t i = 0; i < curves.size(); ++i) {
          INFO("tone map " << curves[i] << " of " << r << " " << g << " " << b);
          auto const [definition, tolerance] = definitions[i];
          if (largest_difference(toned({r, g, b}, curves[i]), definition({r, g, b})) > tolerance) FAIL("differs");
        }
      }
    }
  }
}

TEST_CASE("values of tone maps", "[unit][develop]") {
  auto const grey = [](double c, device::uint tone_map) { return toned(Vec3(c), tone_map).g; };
  // 1 - 0.24^2 / (0.96 - 0.52), and the same of 10.
  CHECK(grey(1, TONE_MAP_NEUTRAL) == Approx(0.8690909));
  CHECK(grey(10, TONE_MAP_NEUTRAL) == Approx(1 - 0.0576 / 9.44));
  CHECK(grey(0.04, TONE_MAP_NEUTRAL) == Approx(0.01));
  // 0.3 * 0.3245786 - 0.000090537 over 0.3 * 0.7280697 + 0.238081.
  CHECK(grey(0.18, TONE_MAP_ACES) == Approx(0.2131054));
  CHECK(grey(0.18, TONE_MAP_AGX) == Approx(0.2152).epsilon(5e-3));
  CHECK(toned({0, 1, 3}, TONE_MAP_REINHARD) == Vec3(0, 0.5, 0.75));
  CHECK(toned({-1, 1, 3}, TONE_MAP_NONE) == Vec3(-1, 1, 3));
}

TEST_CASE("the neutral tone map takes what dielectrics reflect off base colours", "[unit][develop]") {
  for (Vec3 const& c : {Vec3(0.08), Vec3(0.5), Vec3(0.79, 0.1, 0.3), Vec3(0.2, 0.7999, 0.08)}) {
    CHECK(largest_difference(toned(c, TONE_MAP_NEUTRAL), c - 0.04) < 1e-7);
  }
  CHECK(toned({0.7, 0, 0}, TONE_MAP_NEUTRAL) == Vec3(double(0.7f), 0, 0));
}

TEST_CASE("black stays black, what is beyond all limits is white", "[unit][develop]") {
  double const infinity = std::numeric_limits<double>::infinity();
  for (device::uint const curve : curves) {
    INFO("tone map " << curve);
    CHECK(toned(Vec3(0), curve) == Vec3(0));
    CHECK(toned(Vec3(-1), curve) == Vec3(0));
    CHECK(toned(Vec3(std::numeric_limits<double>::quiet_NaN()), curve) == Vec3(0));
    for (double const bright : {1e10, 1e30, 3.4e38, infinity}) {
      for (Vec3 const& c : {Vec3(bright), Vec3(bright, 0, 0), Vec3(0, bright, bright), Vec3(1, 1, bright)}) {
        Vec3 const white = toned(c, curve);
        INFO(c.x << " " << c.y << " " << c.z << " became " << white.x << " " << white.y << " " << white.z);
        CHECK(glm::all(glm::greaterThanEqual(white, Vec3(0))));
        CHECK(glm::all(glm::lessThanEqual(white, Vec3(1))));
      }
      CHECK(toned(Vec3(bright), curve).g > 0.99);
    }
  }
}

TEST_CASE("grey stays grey, and brighter light is never darker", "[unit][develop]") {
  for (device::uint const curve : curves) {
    for (Vec3 const& color : {Vec3(1), Vec3(1, 0.5, 0.25), Vec3(0.2, 1, 0.3), Vec3(0.1, 0.2, 1), Vec3(1, 0, 1)}) {
      double before = 0;
      for (double brightness = 1e-6; brightness < 1e6; brightness *= 1.01) {
        Vec3 const c = toned(brightness * color, curve);
        INFO("tone map " << curve << " of " << color.x << " " << color.y << " " << color.z << " times " << brightness);
        double const luminance = glm::dot(c, Vec3(0.2126, 0.7152, 0.0722));
        if (luminance < before - 1e-6) FAIL("darker");  // of roundings
        before = luminance;
        // The sums of a row of the fit for ACES are 1 to its five digits.
        if (color == Vec3(1) && std::max(std::abs(c.r - c.g), std::abs(c.b - c.g)) > 2e-5) FAIL("not grey");
      }
    }
  }
}
