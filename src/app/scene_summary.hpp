#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "lichtraum/graph_summary.hpp"
#include "lichtraum/job.hpp"
#include "lichtraum/model.hpp"

namespace lichtraum::app {

/// What `lichtraum info` tells.
struct SceneSummary {
  ShapeCounts defined;                        ///< each shape once
  ShapeCounts drawn;                          ///< once for each path from a root: with all instances
  Bounds bounds;                              ///< of all that is drawn
  std::size_t material_count = 0;             ///< of the scene and of models in it, each once
  std::vector<TextureImage const*> textures;  ///< of all materials, each once, as they are in memory
  /// Of the pictures that the scene asks for; of one where it asks for none.
  std::vector<IntegratorChoice> integrators;
  Background background;  ///< of pictures of a model, unless asked otherwise; else the scene's
  Scene const* scene = nullptr;
  ModelContents const* contents = nullptr;  ///< null: it is not a model
};

/// Linear in the size of the graph, however many instances it unfolds to. `scene` must outlive the result; `job` is for
/// it, and says the rest.
SceneSummary summarise(Scene const& scene, Job job);

std::string to_text(SceneSummary const& summary, std::string const& file);
std::string to_json(SceneSummary const& summary, std::string const& file);

}  // namespace lichtraum::app
