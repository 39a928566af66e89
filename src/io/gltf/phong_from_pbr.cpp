#include "io/gltf/phong_from_pbr.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>

namespace lichtraum::gltf {
namespace {

// IEC 61966-2-1, the decoding of one component.
double linear_from_srgb(double c) { return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4); }

std::array<double, 256> const& srgb_table() {
  static std::array<double, 256> const table = [] {
    std::array<double, 256> values{};
    for (std::size_t i = 0; i < values.size(); ++i) values[i] = linear_from_srgb(double(i) / 255);
    return values;
  }();
  return table;
}

/// The mean over all texels, each weighed by its alpha when `by_alpha`; linear.
glm::dvec4 mean_of(TextureSlot const& slot, bool is_srgb, bool by_alpha) {
  if (!slot) return glm::dvec4(1);
  auto const& rgba = slot.texture->image->rgba;
  std::array<std::array<std::uint64_t, 256>, 4> histogram{};
  for (std::size_t i = 0; i + 3 < rgba.size(); i += 4) {
    std::uint64_t const weight = by_alpha ? rgba[i + 3] : 1;
    for (std::size_t c = 0; c < 3; ++c) histogram[c][rgba[i + c]] += weight;
    ++histogram[3][rgba[i + 3]];
  }
  glm::dvec4 mean(0);
  for (int c = 0; c < 4; ++c) {
    double sum = 0, weight = 0;
    for (std::size_t value = 0; value < 256; ++value) {
      auto const count = double(histogram[std::size_t(c)][value]);
      sum += count * (is_srgb && c < 3 ? srgb_table()[value] : double(value) / 255);
      weight += count;
    }
    mean[c] = weight > 0 ? sum / weight : 1;
  }
  return mean;
}

}  // namespace

Material phong_from_pbr(std::string name, std::shared_ptr<PbrMaterial const> pbr) {
  glm::dvec4 const base =
      pbr->base_color * mean_of(pbr->base_color_texture, true, pbr->alpha_mode != AlphaMode::opaque);
  glm::dvec4 const surface = mean_of(pbr->metallic_roughness_texture, false, false);
  Rgb const color = glm::clamp(Rgb(base), Rgb(0), Rgb(1));
  double const metallic = std::clamp(pbr->metallic * surface.b, 0.0, 1.0);
  double const roughness = std::clamp(pbr->roughness * surface.g, 0.0, 1.0);
  Rgb const emission = pbr->emissive * Rgb(mean_of(pbr->emissive_texture, true, false));

  auto const finished = [&](Rgb const& ka, Rgb const& kd, Rgb const& ks, double m, Rgb const& emitted) {
    Material material(std::move(name), ka, kd, ks, m);
    material.set_emission(emitted);
    material.set_pbr(pbr);
    return material;
  };
  if (pbr->unlit) return finished(Rgb(0), Rgb(0), Rgb(0), 1, color);

  // Reflectance at normal incidence (Schlick 1994), with KHR_materials_ior and KHR_materials_specular.
  double const ratio = (pbr->ior - 1) / (pbr->ior + 1);
  Rgb const dielectric = glm::min(ratio * ratio * pbr->specular_color, Rgb(1)) * pbr->specular;
  Rgb const f0 = glm::mix(dielectric, color, metallic);
  // GGX's alpha = roughness^2 as a Blinn exponent is 2 / alpha^2 - 2 (Walter et al. 2007); Phong's lobe about the
  // mirrored direction needs a quarter of it. (m + 8) / 8 keeps the highlight's energy; above 1 it would burn out.
  double const alpha = std::max(roughness * roughness, 0.02);
  double const m = std::max((2 / (alpha * alpha) - 2) / 4, 0.0);
  Rgb const ks = glm::min(f0 * ((m + 8) / 8), Rgb(1));
  // A metal shows nothing but its surroundings, which a scene of a few lights has not: two fifths of its colour stay.
  Rgb const kd = color * (1 - 0.6 * metallic);
  Material material = finished(kd, kd, ks, m, emission);

  double const opacity = pbr->alpha_mode == AlphaMode::blend ? std::clamp(base.a, 0.0, 1.0) : 1;
  double const transmission =
      std::clamp(pbr->transmission * mean_of(pbr->transmission_texture, false, false).r, 0.0, 1.0);
  double const transmit = 1 - opacity * (1 - transmission * (1 - metallic));
  double const mirror = metallic * std::pow(1 - roughness, 2) * 0.6 * (1 - transmit);
  bool const is_body = pbr->thickness > 0 && transmission > 0;
  material.set_mirror_and_glass(mirror, transmit, is_body && pbr->ior > 0 ? pbr->ior : 1);
  return material;
}

}  // namespace lichtraum::gltf
