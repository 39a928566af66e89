#include "scene/pbr_evaluation.hpp"

#include <algorithm>
#include <glm/common.hpp>

#include "core/square.hpp"
#include "scene/device_conversion.hpp"
#include "shared/pbr_material.h"

namespace lichtraum {
namespace {

double unit(double x) { return std::clamp(x, 0.0, 1.0); }

}  // namespace

glm::dvec4 texel_at(TextureSlot const& slot, MeshPoint const& point, TexelContent content) {
  if (!slot) return glm::dvec4(1);
  auto const uv = point.texcoord(slot.texcoord);
  return uv ? look_up(slot, *uv, content) : glm::dvec4(1);
}

bool varies(PbrModel const& m) {
  return m.base_color_texture || m.metallic_roughness_texture || m.occlusion_texture || m.emissive_texture ||
         m.transmission_texture || m.specular_texture || m.specular_color_texture || m.clearcoat_texture ||
         m.clearcoat_roughness_texture;
}

bool varies_more(PbrModel const& m) {
  return m.sheen_color_texture || m.sheen_roughness_texture || m.anisotropy_texture || m.diffuse_transmission_texture ||
         m.diffuse_transmission_color_texture || m.iridescence_texture || m.iridescence_thickness_texture;
}

bool has_cutouts(PbrModel const& m) { return m.alpha_mode != AlphaMode::opaque; }

bool filters(PbrModel const& m) {
  return m.alpha_mode == AlphaMode::blend ||
         (m.transmission > 0 && (m.transmission_texture || m.metallic_roughness_texture));
}

bool may_be_pane(PbrModel const& m) {
  bool const is_thin = m.transmission > 0 && !(m.thickness > 0);
  bool const is_smooth = m.metallic_roughness_texture || square(m.roughness) <= double(MIN_ALPHA);
  bool const is_bare = !(m.clearcoat > 0 || m.sheen_color != Rgb(0) || m.iridescence > 0);
  bool const has_other_lobes = m.anisotropy > 0 || m.diffuse_transmission > 0 || m.emissive != Rgb(0);
  return !m.unlit && is_thin && is_smooth && is_bare && !has_other_lobes;
}

bool needs_tangents(PbrModel const& m) {
  bool const has_own_coat = m.clearcoat > 0 && (m.normal_texture || m.clearcoat_normal_texture);
  return !m.unlit && (m.anisotropy > 0 || has_own_coat);
}

double base_alpha(PbrModel const& m, MeshPoint const& point) {
  return m.alpha * point.color().a * texel_at(m.base_color_texture, point, TexelContent::color).a;
}

bool is_cut_out(PbrModel const& m, double alpha) {
  if (m.alpha_mode == AlphaMode::mask) return alpha < m.alpha_cutoff;
  return m.alpha_mode == AlphaMode::blend && !(alpha > 0);
}

device::PbrPoint evaluate(PbrModel const& m, MeshPoint const& point) {
  glm::dvec4 const base =
      glm::dvec4(m.base_color, m.alpha) * point.color() * texel_at(m.base_color_texture, point, TexelContent::color);
  glm::dvec4 const surface = texel_at(m.metallic_roughness_texture, point, TexelContent::data);
  double const transmission = unit(m.transmission * texel_at(m.transmission_texture, point, TexelContent::data).r);
  double const occlusion = texel_at(m.occlusion_texture, point, TexelContent::data).r;
  device::PbrPoint result{};
  store(glm::clamp(Rgb(base), Rgb(0), Rgb(1)), result.color);
  result.alpha = m.alpha_mode == AlphaMode::blend ? float(unit(base.a)) : 1.0f;
  result.metallic = float(unit(m.metallic * surface.b));
  result.roughness = float(unit(m.roughness * surface.g));
  result.transmission = float(transmission);
  result.occlusion = float(1 + m.occlusion_strength * (occlusion - 1));
  store(m.emissive * Rgb(texel_at(m.emissive_texture, point, TexelContent::color)), result.emission);
  result.ior = float(m.ior);
  result.refraction_ior = m.thickness > 0 && transmission > 0 && m.ior > 0 ? float(m.ior) : 1.0f;
  result.specular = float(m.specular * texel_at(m.specular_texture, point, TexelContent::data).a);
  store(m.specular_color * Rgb(texel_at(m.specular_color_texture, point, TexelContent::color)), result.specular_color);
  result.is_unlit = m.unlit ? 1 : 0;
  return result;
}

PhongModel phong_at(PbrModel const& material, MeshPoint const& point) {
  device::PbrPoint const evaluated = evaluate(material, point);
  device::PhongMaterial const phong = device::phong_from_pbr(&evaluated);
  PhongModel out;
#define LICHTRAUM_COLOR(name, initial) out.name = Rgb(phong.name[0], phong.name[1], phong.name[2]);
#define LICHTRAUM_SHARE(name, initial) out.name = phong.name;
#define LICHTRAUM_NUMBER(name, initial, least, most) out.name = phong.name;
  PHONG_FIELDS(LICHTRAUM_COLOR, LICHTRAUM_SHARE, LICHTRAUM_NUMBER)
#undef LICHTRAUM_COLOR
#undef LICHTRAUM_SHARE
#undef LICHTRAUM_NUMBER
  return out;
}

}  // namespace lichtraum
