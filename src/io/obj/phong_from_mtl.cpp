#include "io/obj/phong_from_mtl.hpp"

#include <algorithm>
#include <cmath>

namespace lichtraum::obj {
namespace {

TextureSlot slot(MtlTexture const& source, std::shared_ptr<TextureImage const> const& image) {
  if (!image) return {};
  Texture texture{image};
  if (source.clamp) texture.wrap_s = texture.wrap_t = TextureWrap::clamp_to_edge;
  TextureSlot result;
  result.texture = std::make_shared<Texture const>(std::move(texture));
  // MTL scales and moves coordinates that count from below, the reader has turned them round: v = 1 - v'.
  result.scale = source.scale;
  result.offset = {source.offset.x, 1 - source.scale.y - source.offset.y};
  return result;
}

/// What Blinn's exponent is as GGX's roughness (Walter et al. 2007), with alpha the square of the roughness.
double roughness_from(double m) { return std::sqrt(std::sqrt(2 / (4 * m + 2))); }

}  // namespace

std::shared_ptr<Material> phong_from_mtl(MtlMaterial const& source, MtlTextures const& textures) {
  int const illum = int(std::clamp(source.illum.value_or(2), 0.0, 10.0));
  Rgb const kd = source.kd.value_or(Rgb(textures.map_kd ? 1 : 0.8));
  // Exporters that know no ambient light write 1 1 1: taken as written, it would wash out every colour.
  Rgb const ka = !source.ka || *source.ka == Rgb(1) ? kd : *source.ka;
  bool const has_highlight = illum >= 2;
  Rgb const ks = has_highlight ? source.ks.value_or(Rgb(0)) : Rgb(0);
  double const m = std::max(source.ns.value_or(1), 0.0);
  double const opacity = std::clamp(source.d.value_or(1), 0.0, 1.0);
  bool const mirrors = illum >= 3 && illum <= 7;
  bool const refracts = illum == 6 || illum == 7;
  double const ni = source.ni.value_or(1);
  double const ior = ni > 0 ? ni : 1;

  auto material = std::make_shared<Material>(source.name, ka, kd, ks, m);
  double const transmit = 1 - opacity;
  double const reflect = mirrors ? std::clamp(std::max({ks.r, ks.g, ks.b}), 0.0, opacity) : 0;
  material->set_mirror_and_glass(reflect, transmit, refracts ? ior : 1);
  material->set_emission(source.ke.value_or(Rgb(0)));

  auto pbr = std::make_shared<PbrMaterial>();
  pbr->base_color = glm::dvec4(glm::min(kd, Rgb(1)), opacity);
  pbr->base_color_texture = slot(source.map_kd, textures.map_kd);
  pbr->metallic = std::clamp(source.metallic.value_or(0), 0.0, 1.0);
  pbr->roughness = std::clamp(source.roughness.value_or(has_highlight ? roughness_from(m) : 1), 0.0, 1.0);
  pbr->normal_texture = slot(source.norm, textures.norm);
  pbr->emissive = source.ke.value_or(Rgb(0));
  pbr->emissive_texture = slot(source.map_ke, textures.map_ke);
  if (refracts) {  // a body, not a film
    pbr->base_color.a = 1;
    pbr->transmission = transmit;
    pbr->thickness = 1;
  } else if (opacity < 1) {
    pbr->alpha_mode = AlphaMode::blend;
  }
  pbr->ior = ior >= 1 ? ior : 1.5;
  pbr->specular = ks == Rgb(0) ? 0 : 1;
  material->set_pbr(std::move(pbr));
  return material;
}

}  // namespace lichtraum::obj
