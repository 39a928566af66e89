#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "lichtraum/model.hpp"

namespace lichtraum {

/// A mesh, lines, or points, of a model whose format knows no nodes.
struct ModelPart {
  std::string name;
  std::shared_ptr<MeshGeometry const> geometry;  ///< without triangles: lines or points
  std::shared_ptr<Material const> material;
};

/// Adds a Mesh, a LineSet or a PointCloud for each part, under one root called `name`, and a camera and lights that
/// show them. `point_size`: see set_point_sizes of io/points.hpp.
void add_parts(std::vector<ModelPart> parts, std::string const& name, Scene& scene,
               std::optional<double> point_size = std::nullopt);

/// A matt material that vertices' colours and textures may change.
PbrModel matt_pbr(Rgb const& color);

/// Of what has no colour of its own: anything lighter shows no form where the studio shines on it.
inline constexpr Rgb default_grey(0.5);

/// A grey, matt material; white where the vertices bring their own colours.
std::shared_ptr<Material> default_material(bool has_colors);

/// Warns when the options ask for what only glTF has, or for a size of points where the model has none.
void check_static(ModelOptions const& options, std::string const& file, bool has_points_or_lines,
                  std::vector<Diagnostic>& diagnostics);

}  // namespace lichtraum
