#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "lichtraum/model.hpp"

namespace lichtraum::app {

/// How many shapes there are of each kind.
struct ShapeCounts {
  std::uint64_t spheres = 0;
  std::uint64_t boxes = 0;
  std::uint64_t triangles = 0;
  std::uint64_t meshes = 0;
  std::uint64_t mesh_triangles = 0;
  std::uint64_t composites = 0;
};

/// What `lichtraum info` tells.
struct SceneSummary {
  ShapeCounts defined;  ///< each shape once
  ShapeCounts drawn;    ///< once for each path from a root: with all instances; saturates at `uncountable`
  Vec3 bounds_min{0};   ///< of a box around all that is drawn; min > max when nothing is
  Vec3 bounds_max{0};
  std::vector<TextureImage const*> textures;  ///< of all materials, each once, as they are in memory
  Scene const* scene = nullptr;
  ModelContents const* contents = nullptr;  ///< null: it is no model

  static constexpr std::uint64_t uncountable = std::uint64_t(1) << 62;
};

/// Linear in the size of the graph, however many instances it unfolds to. `scene` must outlive the result.
SceneSummary summarise(Scene const& scene);

std::string to_text(SceneSummary const& summary, std::string const& file);
std::string to_json(SceneSummary const& summary, std::string const& file);

}  // namespace lichtraum::app
