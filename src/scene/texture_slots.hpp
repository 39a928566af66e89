#pragma once

#include <algorithm>
#include <vector>

#include "lichtraum/pbr_material.hpp"

namespace lichtraum {

/// Every texture slot of a material.
inline std::vector<TextureSlot const*> texture_slots(PbrMaterial const& m) {
  return {&m.base_color_texture,
          &m.metallic_roughness_texture,
          &m.normal_texture,
          &m.occlusion_texture,
          &m.emissive_texture,
          &m.transmission_texture,
          &m.specular_texture,
          &m.specular_color_texture,
          &m.thickness_texture,
          &m.clearcoat_texture,
          &m.clearcoat_roughness_texture,
          &m.clearcoat_normal_texture,
          &m.sheen_color_texture,
          &m.sheen_roughness_texture,
          &m.anisotropy_texture,
          &m.iridescence_texture,
          &m.iridescence_thickness_texture};
}

/// Which texture coordinates the material uses, ascending: the device keeps these only, and counts in them.
inline std::vector<int> used_texcoords(PbrMaterial const& material) {
  std::vector<int> sets;
  for (TextureSlot const* slot : texture_slots(material)) {
    if (*slot) sets.push_back(slot->texcoord);
  }
  std::sort(sets.begin(), sets.end());
  sets.erase(std::unique(sets.begin(), sets.end()), sets.end());
  return sets;
}

}  // namespace lichtraum
