#include "compile/material_table.hpp"

#include <algorithm>
#include <cstring>
#include <unordered_map>

#include "lichtraum/error.hpp"
#include "scene/device_conversion.hpp"
#include "scene/pbr_evaluation.hpp"
#include "scene/texture_lookup.hpp"
#include "scene/used_texcoords.hpp"
#include "shared/frame.h"

namespace lichtraum {
namespace {

device::PhongMaterial phong_material(Material const& material) {
  device::PhongMaterial out{};
  out.ka = device_float4(material.ka(), material.m());
  out.kd = device_float4(material.kd(), material.reflect());
  out.ks = device_float4(material.ks(), material.transmit());
  out.ior = float(material.ior());
  store(material.emission(), out.emission);
  return out;
}

/// Collects textures, each once, and their pictures, each once.
class Textures {
 public:
  explicit Textures(MaterialTable& table) : table_(table) {}

  device::TextureSlot slot(TextureSlot const& source, std::vector<int> const& used_sets) {
    device::TextureSlot result{};
    result.texture = NO_TEXTURE;
    if (!source) return result;
    result.texture = number_of(source.texture);
    auto const place = std::find(used_sets.begin(), used_sets.end(), source.texcoord);
    result.texcoord = device::uint(place - used_sets.begin());
    // The columns of the affine map, read off its images of the origin and the axes.
    glm::dvec2 const origin = transform_coordinate(source, {0, 0});
    glm::dvec2 const u = transform_coordinate(source, {1, 0}) - origin;
    glm::dvec2 const v = transform_coordinate(source, {0, 1}) - origin;
    store(Vec3(u.x, v.x, origin.x), result.row_u);
    store(Vec3(u.y, v.y, origin.y), result.row_v);
    return result;
  }

 private:
  device::uint number_of(std::shared_ptr<Texture const> const& texture) {
    auto const [found, is_new] = textures_.emplace(texture.get(), device::uint(table_.textures.size()));
    if (!is_new) return found->second;
    TextureImage const& image = *texture->image;
    device::uint const sampling = device::uint(texture->wrap_s) | device::uint(texture->wrap_t) << 2 |
                                  (texture->filter == TextureFilter::linear ? FILTER_LINEAR : FILTER_NEAREST) << 4;
    table_.textures.push_back({first_texel(image), device::uint(image.width), device::uint(image.height), sampling});
    return found->second;
  }

  device::uint first_texel(TextureImage const& image) {
    auto const [found, is_new] = images_.emplace(&image, table_.texels.size());
    if (is_new) {
      std::size_t const count = image.rgba.size() / 4;
      if (table_.texels.size() + count > 0xFFFFFFFFu) {
        throw Error(ErrorKind::scene, "the textures have more than 2^32 texels; a smaller --max-texture helps");
      }
      table_.texels.resize(table_.texels.size() + count);
      // The host is little endian, as the device is: red is the lowest byte of a word.
      std::memcpy(table_.texels.data() + found->second, image.rgba.data(), 4 * count);
    }
    return device::uint(found->second);
  }

  MaterialTable& table_;
  std::unordered_map<Texture const*, device::uint> textures_;
  std::unordered_map<TextureImage const*, std::size_t> images_;
};

static_assert(int(TextureWrap::repeat) == WRAP_REPEAT && int(TextureWrap::mirrored_repeat) == WRAP_MIRRORED_REPEAT &&
              int(TextureWrap::clamp_to_edge) == WRAP_CLAMP_TO_EDGE);
static_assert(int(AlphaMode::opaque) == ALPHA_OPAQUE && int(AlphaMode::mask) == ALPHA_MASK &&
              int(AlphaMode::blend) == ALPHA_BLEND);

device::uint flags_of(PbrMaterial const& m) {
  return PBR_IS_PRESENT | (varies(m) ? PBR_VARIES : 0u) | (has_cutouts(m) ? PBR_CUTOUT : 0u) |
         (filters(m) ? PBR_FILTERS : 0u) | (m.unlit ? PBR_UNLIT : 0u) | (m.double_sided ? PBR_DOUBLE_SIDED : 0u) |
         (m.attenuation_distance ? PBR_HAS_ATTENUATION : 0u);
}

device::PbrMaterial pbr_material(PbrMaterial const& m, Textures& textures) {
  std::vector<int> const sets = used_texcoords(m);
  auto const slot = [&](TextureSlot const& source) { return textures.slot(source, sets); };
  device::PbrMaterial out{};
  out.flags = flags_of(m);
  out.alpha_mode = device::uint(m.alpha_mode);
  out.alpha_cutoff = float(m.alpha_cutoff);
  out.ior = float(m.ior);
  for (int c = 0; c < 4; ++c) out.base_color[c] = float(m.base_color[c]);
  store(m.emissive, out.emissive);
  out.metallic = float(m.metallic);
  out.roughness = float(m.roughness);
  out.normal_scale = float(m.normal_scale);
  out.occlusion_strength = float(m.occlusion_strength);
  out.transmission = float(m.transmission);
  out.specular = float(m.specular);
  store(m.specular_color, out.specular_color);
  out.base_color_texture = slot(m.base_color_texture);
  out.metallic_roughness_texture = slot(m.metallic_roughness_texture);
  out.normal_texture = slot(m.normal_texture);
  out.occlusion_texture = slot(m.occlusion_texture);
  out.emissive_texture = slot(m.emissive_texture);
  out.transmission_texture = slot(m.transmission_texture);
  out.specular_texture = slot(m.specular_texture);
  out.specular_color_texture = slot(m.specular_color_texture);
  out.thickness = float(m.thickness);
  out.dispersion = float(m.dispersion);
  out.attenuation_distance = float(m.attenuation_distance.value_or(0));
  store(m.attenuation_color, out.attenuation_color);
  out.thickness_texture = slot(m.thickness_texture);
  out.clearcoat = float(m.clearcoat);
  out.clearcoat_roughness = float(m.clearcoat_roughness);
  out.clearcoat_texture = slot(m.clearcoat_texture);
  out.clearcoat_roughness_texture = slot(m.clearcoat_roughness_texture);
  out.clearcoat_normal_texture = slot(m.clearcoat_normal_texture);
  store(m.sheen_color, out.sheen_color);
  out.sheen_roughness = float(m.sheen_roughness);
  out.sheen_color_texture = slot(m.sheen_color_texture);
  out.sheen_roughness_texture = slot(m.sheen_roughness_texture);
  out.anisotropy = float(m.anisotropy);
  out.anisotropy_rotation = float(m.anisotropy_rotation_radians);
  out.anisotropy_texture = slot(m.anisotropy_texture);
  out.iridescence = float(m.iridescence);
  out.iridescence_ior = float(m.iridescence_ior);
  out.iridescence_thickness_minimum = float(m.iridescence_thickness_minimum_nm);
  out.iridescence_thickness_maximum = float(m.iridescence_thickness_maximum_nm);
  out.iridescence_texture = slot(m.iridescence_texture);
  out.iridescence_thickness_texture = slot(m.iridescence_thickness_texture);
  return out;
}

}  // namespace

MaterialTable make_material_table(std::vector<std::shared_ptr<Material const>> const& materials) {
  MaterialTable table;
  Textures textures(table);
  for (auto const& material : materials) {
    table.phong.push_back(phong_material(material ? *material : Material()));
    if (table.phong.back().ks.w > 0) table.features |= SCENE_TRANSPARENCY;
    if (!material || !material->pbr()) continue;
    PbrMaterial const& pbr = *material->pbr();
    table.features |= SCENE_PBR;
    if (has_cutouts(pbr) || filters(pbr)) table.features |= SCENE_CUTOUTS;
    if (filters(pbr)) table.features |= SCENE_TRANSPARENCY;
    table.pbr.resize(table.phong.size());  // what comes between has none
    table.pbr.back() = pbr_material(pbr, textures);
  }
  if (!table.pbr.empty()) table.pbr.resize(table.phong.size());
  return table;
}

}  // namespace lichtraum
