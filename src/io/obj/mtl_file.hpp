#pragma once

#include <glm/vec2.hpp>
#include <optional>
#include <string>
#include <vector>

#include "io/text/diagnostics.hpp"
#include "lichtraum/pbr_model.hpp"

namespace lichtraum::obj {

/// A picture as an MTL file names it, with those of its options that are used.
struct MtlTexture {
  std::string file;       ///< empty: none
  std::string bare_file;  ///< without what may be options after it, where they do not belong
  Line line;              ///< where it is named, for messages
  glm::dvec2 offset{0};
  glm::dvec2 scale{1};
  bool clamp = false;
  double multiplier = 1;                      ///< -bm: of heights and normals
  std::shared_ptr<TextureImage const> image;  ///< null until it has been decoded, or where it cannot be
};

/// A material as written; nothing where the file says nothing.
struct MtlMaterial {
  std::string name;
  std::optional<Rgb> ka, kd, ks, ke, tf;
  std::optional<double> ns, ni;
  std::optional<double> d, tr;  ///< d: 1 is opaque; tr: the opposite, though some write it as d
  std::optional<double> metallic, roughness, clearcoat, clearcoat_roughness;
  std::optional<double> illum;
  MtlTexture map_kd, map_ke, map_d, map_pr, map_pm, map_bump, norm;
};

/// Every picture of a material.
inline constexpr MtlTexture MtlMaterial::*mtl_textures[] = {
    &MtlMaterial::map_kd, &MtlMaterial::map_ke,   &MtlMaterial::map_d, &MtlMaterial::map_pr,
    &MtlMaterial::map_pm, &MtlMaterial::map_bump, &MtlMaterial::norm,
};

/// Reads the text of an MTL file; the materials keep views of it. What cannot be read is a warning and left out.
std::vector<MtlMaterial> read_mtl(std::string_view text, Diagnostics& diagnostics);

}  // namespace lichtraum::obj
