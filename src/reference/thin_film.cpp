#include "reference/thin_film.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/elementary.hpp"
#include "core/square.hpp"

namespace lichtraum {
namespace {

/// The paper's equation 10: the CIE's X, Y and Z of cos(2 pi way / wavelength + shift). `way` in nm.
Vec3 sensitivity(double way, double shift) {
  struct Gaussian {
    int row;
    double value, position, variance;
  };
  constexpr Gaussian gaussians[] = {{0, 5.4856e-13, 1.6810e6, 4.3278e9},
                                    {0, 9.7470e-14, 2.2399e6, 4.5282e9},
                                    {1, 4.4201e-13, 1.7953e6, 9.3046e9},
                                    {2, 5.2481e-13, 2.2084e6, 6.6121e9}};
  double const phase = 2 * std::numbers::pi * way * 1e-9;
  Vec3 xyz(0);
  for (auto const& [row, value, position, variance] : gaussians) {
    xyz[row] += value * std::sqrt(2 * std::numbers::pi * variance) * cos_of(position * phase + shift) *
                exp_of(-variance * square(phase));
  }
  return xyz;
}

Rgb srgb_of(Vec3 const& xyz) {
  return {3.2404542 * xyz.x - 1.5371385 * xyz.y - 0.4985314 * xyz.z,
          -0.9692660 * xyz.x + 1.8760108 * xyz.y + 0.0415560 * xyz.z,
          0.0556434 * xyz.x - 0.2040259 * xyz.y + 1.0572252 * xyz.z};
}

/// What two media reflect of light without polarization, whose indices and cosines these are (Fresnel).
double fresnel(double ior1, double cosine1, double ior2, double cosine2) {
  double const s = (ior1 * cosine1 - ior2 * cosine2) / (ior1 * cosine1 + ior2 * cosine2);
  double const p = (ior2 * cosine1 - ior1 * cosine2) / (ior2 * cosine1 + ior1 * cosine2);
  return (square(s) + square(p)) / 2;
}

}  // namespace

Rgb thin_film_reflectance(double ior, double thickness_nm, double cosine, Rgb const& f0) {
  double const cosine2 = std::sqrt(1 - (1 - square(cosine)) / square(ior));
  double const way = 2 * ior * thickness_nm * cosine2;
  double const r12 = fresnel(1, cosine, ior, cosine2);
  double const t121 = 1 - r12;
  Rgb reflectance;
  for (int c = 0; c < 3; ++c) {
    double const root = std::sqrt(std::min(f0[c], 1 - 1e-9));
    double const base = (1 + root) / (1 - root);
    double const head_on = square((base - ior) / (base + ior));
    double const grazing = square(square(1 - cosine2)) * (1 - cosine2);
    double const r23 = head_on + (1 - head_on) * grazing;
    double const phase = std::numbers::pi + (base < ior ? std::numbers::pi : 0);
    double const r123 = std::min(r12 * r23, 0.9999);
    double const rs = square(t121) * r23 / (1 - r123);
    double sum = r12 + rs;
    for (int order = 1; order <= 2; ++order) {
      double const color = srgb_of(sensitivity(order * way, order * phase))[c] / srgb_of(sensitivity(0, 0))[c];
      sum += 2 * (rs - t121) * (order == 1 ? std::sqrt(r123) : r123) * color;
    }
    reflectance[c] = std::clamp(sum, 0.0, 1.0);
  }
  return reflectance;
}

}  // namespace lichtraum
