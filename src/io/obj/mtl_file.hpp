#pragma once

#include <glm/vec2.hpp>
#include <optional>
#include <string>
#include <vector>

#include "io/text/diagnostics.hpp"
#include "lichtraum/math.hpp"

namespace lichtraum::obj {

/// A picture as an MTL file names it, with those of its options that are used.
struct MtlTexture {
  std::string file;  ///< empty: none
  Line line;         ///< where it is named, for messages
  glm::dvec2 offset{0};
  glm::dvec2 scale{1};
  bool clamp = false;
};

/// A material as written; nothing where the file says nothing.
struct MtlMaterial {
  std::string name;
  std::optional<Rgb> ka, kd, ks, ke;
  std::optional<double> ns, ni, d;  ///< d: 1 is opaque; also from Tr = 1 - d
  std::optional<double> metallic, roughness, clearcoat, clearcoat_roughness;
  std::optional<double> illum;
  MtlTexture map_kd, map_ke, map_d, map_pr, map_pm, norm;
};

/// Reads the text of an MTL file; the materials keep views of it. What cannot be read is a warning and left out.
std::vector<MtlMaterial> read_mtl(std::string_view text, Diagnostics& diagnostics);

}  // namespace lichtraum::obj
