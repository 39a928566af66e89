#pragma once

#include <memory>
#include <optional>
#include <string>

#include "lichtraum/scene.hpp"

namespace lichtraum {

/// Of a size that was asked for.
inline constexpr char const* no_points_to_size = "it has no points and no lines; their size has no effect";

/// Leaves of the geometry what a point cloud shows: finite positions and their colours. Returns how many were not
/// finite.
std::size_t reduce_to_points(MeshGeometry& geometry);

/// A mesh, or, where the geometry has no triangles, lines or points. Those have no size until set_point_sizes.
std::shared_ptr<Shape> make_shape(std::string name, std::shared_ptr<MeshGeometry const> geometry,
                                  std::shared_ptr<Material const> material);

/// Whether there is anything that set_point_sizes would size.
bool has_points_or_lines(Scene const& scene);

/// Gives all points of the scene one diameter in the world (in the first place where a cloud is shown), and all lines
/// one: `size` thousandths of the diagonal of the box around the scene. Without a size, so much that points which lie
/// evenly on a surface as large as that box just overlap, but from 0.25 to 10 thousandths; lines between as many points
/// are about a fifth as thick, from 0.25 to 4.
void set_point_sizes(Scene& scene, std::optional<double> size);

}  // namespace lichtraum
