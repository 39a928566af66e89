#pragma once

#include <algorithm>
#include <vector>

#include "lichtraum/pbr_model.hpp"

namespace lichtraum {

/// Which texture coordinates the material uses, ascending: the device keeps these only, and counts in them.
inline std::vector<int> used_texcoords(PbrModel const& material) {
  std::vector<int> sets;
  for (auto const slot : texture_slots) {
    if (material.*slot) sets.push_back((material.*slot).texcoord);
  }
  if (material.anisotropy > 0) sets.push_back(material.anisotropy_texture.texcoord);  // also without the texture
  std::sort(sets.begin(), sets.end());
  sets.erase(std::unique(sets.begin(), sets.end()), sets.end());
  return sets;
}

}  // namespace lichtraum
