#include "compile/material_table.hpp"

#include <algorithm>
#include <cstring>
#include <iterator>
#include <unordered_map>

#include "lichtraum/error.hpp"
#include "scene/device_conversion.hpp"
#include "scene/pbr_evaluation.hpp"
#include "scene/texture_lookup.hpp"
#include "scene/used_texcoords.hpp"
#include "shared/scene_arrays.h"

namespace lichtraum {
namespace {

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

/// All but its textures.
device::PbrMaterial pbr_factors(PbrMaterial const& m) {
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
  out.thickness = float(m.thickness);
  out.dispersion = float(m.dispersion);
  out.attenuation_distance = float(m.attenuation_distance.value_or(0));
  store(m.attenuation_color, out.attenuation_color);
  out.clearcoat = float(m.clearcoat);
  out.clearcoat_roughness = float(m.clearcoat_roughness);
  store(m.sheen_color, out.sheen_color);
  out.sheen_roughness = float(m.sheen_roughness);
  out.anisotropy = float(m.anisotropy);
  out.anisotropy_rotation = float(m.anisotropy_rotation_radians);
  out.iridescence = float(m.iridescence);
  out.iridescence_ior = float(m.iridescence_ior);
  out.iridescence_thickness_minimum = float(m.iridescence_thickness_minimum_nm);
  out.iridescence_thickness_maximum = float(m.iridescence_thickness_maximum_nm);
  return out;
}

/// A slot of a material, and its place on the device.
struct SlotPlace {
  TextureSlot PbrMaterial::*host;
  device::TextureSlot device::PbrMaterial::*device;
};
using HostMaterial = PbrMaterial;
using DeviceMaterial = device::PbrMaterial;
constexpr SlotPlace slot_places[] = {
    {&HostMaterial::base_color_texture, &DeviceMaterial::base_color_texture},
    {&HostMaterial::metallic_roughness_texture, &DeviceMaterial::metallic_roughness_texture},
    {&HostMaterial::normal_texture, &DeviceMaterial::normal_texture},
    {&HostMaterial::occlusion_texture, &DeviceMaterial::occlusion_texture},
    {&HostMaterial::emissive_texture, &DeviceMaterial::emissive_texture},
    {&HostMaterial::transmission_texture, &DeviceMaterial::transmission_texture},
    {&HostMaterial::specular_texture, &DeviceMaterial::specular_texture},
    {&HostMaterial::specular_color_texture, &DeviceMaterial::specular_color_texture},
    {&HostMaterial::thickness_texture, &DeviceMaterial::thickness_texture},
    {&HostMaterial::clearcoat_texture, &DeviceMaterial::clearcoat_texture},
    {&HostMaterial::clearcoat_roughness_texture, &DeviceMaterial::clearcoat_roughness_texture},
    {&HostMaterial::clearcoat_normal_texture, &DeviceMaterial::clearcoat_normal_texture},
    {&HostMaterial::sheen_color_texture, &DeviceMaterial::sheen_color_texture},
    {&HostMaterial::sheen_roughness_texture, &DeviceMaterial::sheen_roughness_texture},
    {&HostMaterial::anisotropy_texture, &DeviceMaterial::anisotropy_texture},
    {&HostMaterial::iridescence_texture, &DeviceMaterial::iridescence_texture},
    {&HostMaterial::iridescence_thickness_texture, &DeviceMaterial::iridescence_thickness_texture},
};
static_assert(std::size(slot_places) == std::size(texture_slots));

device::PbrMaterial pbr_material(PbrMaterial const& m, Textures& textures) {
  std::vector<int> const sets = used_texcoords(m);
  device::PbrMaterial out = pbr_factors(m);
  for (SlotPlace const& place : slot_places) out.*place.device = textures.slot(m.*place.host, sets);
  return out;
}

}  // namespace

device::PhongMaterial phong_material(Material const& material) {
  device::PhongMaterial out{};
  store(material.ka(), out.ka);
  store(material.kd(), out.kd);
  store(material.ks(), out.ks);
  out.m = float(material.m());
  out.reflect = float(material.reflect());
  out.transmit = float(material.transmit());
  out.ior = float(material.ior());
  store(material.emission(), out.emission);
  return out;
}

device::PbrMaterial pbr_material(PbrMaterial const& material, device::PbrMaterial const& before) {
  device::PbrMaterial out = pbr_factors(material);
  for (SlotPlace const& place : slot_places) out.*place.device = before.*place.device;
  return out;
}

device::uint features_of(Material const& material) {
  device::uint features = float(material.transmit()) > 0 ? SCENE_TRANSPARENCY : 0;
  if (!material.pbr()) return features;
  features |= SCENE_PBR;
  if (has_cutouts(*material.pbr()) || filters(*material.pbr())) features |= SCENE_CUTOUTS;
  if (filters(*material.pbr())) features |= SCENE_TRANSPARENCY;
  return features;
}

MaterialTable make_material_table(std::vector<std::shared_ptr<Material const>> const& materials) {
  MaterialTable table;
  Textures textures(table);
  for (auto const& material : materials) {
    Material const shown = material ? *material : Material();
    table.phong.push_back(phong_material(shown));
    table.features |= features_of(shown);
    if (!shown.pbr()) continue;
    table.pbr.resize(table.phong.size(), {});  // what comes between has none
    table.pbr.back() = pbr_material(*shown.pbr(), textures);
  }
  if (!table.pbr.empty()) table.pbr.resize(table.phong.size(), {});
  return table;
}

}  // namespace lichtraum
