#pragma once

#include "io/ply/ply_header.hpp"
#include "lichtraum/mesh_geometry.hpp"

namespace lichtraum::ply {

/// Reads vertices and faces (also as strips). What is wrong is a warning; where the data ends too early, what was read
/// until then counts. The indices are not checked yet. Colours become linear, texture coordinates count from above.
MeshGeometry read_data(std::string_view bytes, Header const& header, Diagnostics& diagnostics);

}  // namespace lichtraum::ply
