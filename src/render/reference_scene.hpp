#pragma once

#include <memory>
#include <string_view>
#include <vector>

#include "lichtraum/renderer.hpp"
#include "render/scene_shading.hpp"

namespace lichtraum {

/// What the reference renderer keeps of a scene: a copy of its graph, and what shading needs.
struct ReferenceScene : SceneShading {
  std::vector<std::shared_ptr<Shape const>> roots;
  std::vector<Light> lights;  ///< all but ambient ones
};

/// All but ambient ones.
std::vector<Light> casting_shadows(std::vector<Light> const& lights);

/// All roots, or the shape called `root`, as they are: nothing is copied. Throws Error{usage} for an unknown root.
ReferenceScene make_reference_scene(Scene const& scene, std::string_view root);

/// What a walk over the graph finds. It visits each shape once, however many paths lead there.
struct GraphSummary {
  SceneStatistics statistics;  ///< only the counts of shapes and instances
  /// In the world; min > max when nothing is drawn. A composite's box is the box around its children's boxes: under a
  /// rotation it may be larger than its contents.
  Vec3 bounds_min{0};
  Vec3 bounds_max{0};
  std::uint64_t drawn_primitives = 0;  ///< one for each path; saturates (see GraphNode)
};

GraphSummary summarise(std::vector<std::shared_ptr<Shape const>> const& roots);

}  // namespace lichtraum
