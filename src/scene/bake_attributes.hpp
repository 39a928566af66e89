#pragma once

#include "lichtraum/shapes.hpp"
#include "scene/flat_scene.hpp"

namespace lichtraum {

/// Triangles, or vertices: fewer are not worth a thread.
inline constexpr std::size_t min_elements_of_thread = std::size_t(1) << 15;

/// Appends what shading interpolates between the vertices of `mesh`: normals, and of tangents, colours and texture
/// coordinates what the material uses. Nothing where there is none of it. The mesh's triangles are those of `object`
/// from number `first` on; `positions` are its vertices in the object's frame: triangles with a corner that is not
/// finite were left out. `places`: where in a triangle each of its corners was put.
/// Throws Error{scene} for more than 2^32 floats of vertices.
void bake_attributes(Mesh const& mesh, Transform const& object_from_mesh, std::vector<Float3> const& positions,
                     std::size_t const (&places)[3], std::size_t first, FlatObject& object);

/// Appends the colours that `vertices` of the geometry have, if any, and if the material uses them, for the last of
/// `count` primitives: `each` for one of them (points: 1, lines: 2). `colors` is the list of the object that belongs to
/// these. Throws Error{scene} for more than 2^32 floats of vertices.
void bake_colors(MeshGeometry const& geometry, Material const* material, std::vector<std::uint32_t> const& vertices,
                 std::size_t each, std::size_t count, BigVector<device::uint>& colors, FlatObject& object);

}  // namespace lichtraum
