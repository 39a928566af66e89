#include "io/obj/material_from_mtl.hpp"

#include <algorithm>
#include <cmath>

#include "core/largest_channel.hpp"

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

/// What a picture is multiplied with: 1 without a number, or with the 0 that some exporters write beside it. Without
/// the picture such a 0 says nothing.
std::optional<Rgb> factor(std::optional<Rgb> const& color, MtlTexture const& picture) {
  bool const is_filler = !picture.file.empty() && color == Rgb(0);
  if (color && !is_filler) return color;
  return picture.image ? std::optional(Rgb(1)) : std::nullopt;
}

/// 1: no light passes through.
double opacity_of(MtlMaterial const& source, bool refracts) {
  if (refracts && source.ni.value_or(1) > 1 && source.d.value_or(1) == 1 && !source.tr) {
    return 1 - std::clamp(largest_channel(source.tf.value_or(Rgb(1))), 0.0, 1.0);
  }
  // `d` counts where both are written: Tr is not in the specification, and many write 1 for what is opaque.
  bool const tr_means_opacity = source.tr == 1 && !refracts;
  double const through = source.tr && !tr_means_opacity ? *source.tr : 0;
  return std::clamp(source.d.value_or(1 - through), 0.0, 1.0);
}

/// Of a body that reflects so much of the light that falls straight on it (Fresnel); at least as glass.
double ior_of_mirror(double reflectance) {
  double const r = std::sqrt(std::clamp(reflectance, 0.04, 0.95));
  return (1 + r) / (1 - r);
}

/// `norm` before `map_Bump`, which may hold normals or heights.
void set_normals(PbrModel& pbr, MtlMaterial const& source, MadePictures& made) {
  MtlTexture const& texture = source.norm.image ? source.norm : source.map_bump;
  if (!texture.image) return;
  if (&texture == &source.norm || made.is_normal_map(texture.image)) {
    pbr.normal_texture = slot(texture, texture.image);
    pbr.normal_scale = std::clamp(texture.multiplier, 0.0, 4.0);
  } else {
    pbr.normal_texture = slot(texture, made.normals_from(texture.image, texture.multiplier, texture.clamp));
  }
}

/// What Blinn's exponent is as GGX's roughness (Walter et al. 2007), with alpha the square of the roughness.
double roughness_from(double m) { return std::sqrt(std::sqrt(2 / (4 * m + 2))); }

/// What Blender writes for the highlight of glass and paint.
constexpr double usual_ks = 0.5;

}  // namespace

std::shared_ptr<Material> material_from_mtl(MtlMaterial const& source, MtlUse const& use, MadePictures& made) {
  int const illum = int(std::clamp(source.illum.value_or(2), 0.0, 10.0));
  Rgb const kd = factor(source.kd, source.map_kd).value_or(Rgb(0.8));
  // Exporters that know no ambient light write 1 1 1: taken as written, it would wash out every colour.
  Rgb const ka = !source.ka || *source.ka == Rgb(1) ? kd : *source.ka;
  bool const has_highlight = illum >= 2;
  Rgb const ks = has_highlight ? source.ks.value_or(Rgb(0)) : Rgb(0);
  double const m = std::max(source.ns.value_or(1), 0.0);
  bool const mirrors = illum >= 3 && illum <= 7;
  bool const refracts = illum == 6 || illum == 7;
  double const opacity = opacity_of(source, refracts);
  double const ni = source.ni.value_or(1);
  double const ior = ni > 0 ? ni : 1;
  Rgb const emission = factor(source.ke, source.map_ke).value_or(Rgb(0));

  bool const is_physical = source.metallic || source.roughness || source.clearcoat;
  bool const has_pictures = std::ranges::any_of(mtl_textures, [&](auto map) { return (source.*map).image != nullptr; });
  bool const is_absent = opacity == 0 && !refracts;
  // By paths, Phong's highlight mirrors as much of all around as it does of lamps: half of it, with Blender's Ks.
  bool const is_body = !use.is_part_of_scene && !mirrors && opacity == 1;
  if (!is_physical && !has_pictures && !use.has_colors && !is_absent && !is_body) {
    PhongModel phong{.ka = ka, .kd = kd, .ks = ks, .m = m};
    phong.transmit = 1 - opacity;
    phong.reflect = mirrors ? std::clamp(largest_channel(ks), 0.0, opacity) : 0;
    phong.ior = refracts ? ior : 1;
    phong.emission = emission;
    return std::make_shared<Material>(source.name, phong);
  }
  PbrModel pbr;
  pbr.base_color = glm::min(kd, Rgb(1));
  pbr.alpha = opacity;
  pbr.base_color_texture = slot(source.map_kd.image ? source.map_kd : source.map_d,
                                made.with_channel(source.map_kd.image, Channel::alpha, source.map_d.image));
  auto const of_roughness = made.with_channel(nullptr, Channel::green, source.map_pr.image);
  auto const of_both = made.with_channel(of_roughness, Channel::blue, source.map_pm.image);
  pbr.metallic_roughness_texture = slot(source.map_pr.image ? source.map_pr : source.map_pm, of_both);
  // A picture of them counts instead of the number: exporters write 0 beside it.
  double const own_roughness = has_highlight ? roughness_from(m) : 1;
  pbr.roughness = of_roughness ? 1 : std::clamp(source.roughness.value_or(own_roughness), 0.0, 1.0);
  pbr.metallic = of_both != of_roughness ? 1 : std::clamp(source.metallic.value_or(0), 0.0, 1.0);
  pbr.clearcoat = std::clamp(source.clearcoat.value_or(0), 0.0, 1.0);
  pbr.clearcoat_roughness = std::clamp(source.clearcoat_roughness.value_or(0), 0.0, 1.0);
  set_normals(pbr, source, made);
  pbr.emissive = emission;
  pbr.emissive_texture = slot(source.map_ke, source.map_ke.image);
  if (refracts) {  // a body, not a film
    pbr.alpha = 1;
    pbr.transmission = 1 - opacity;
    pbr.thickness = 1;
  } else if (opacity < 1 || source.map_d.image) {
    pbr.alpha_mode = AlphaMode::blend;
  }
  if (refracts) {
    pbr.ior = std::max(ior, 1.0);
  } else if (illum == 3) {
    pbr.ior = ior_of_mirror(largest_channel(ks));
  } else {
    pbr.ior = ior > 1 ? ior : 1.5;  // 1 is written for what bends no rays, and would take the highlight away
  }
  double const strongest = largest_channel(ks);
  pbr.specular = mirrors ? double(strongest > 0) : std::min(strongest / usual_ks, 1.0);
  pbr.double_sided = true;
  return std::make_shared<Material>(source.name, std::move(pbr));
}

}  // namespace lichtraum::obj
