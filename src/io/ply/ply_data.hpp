#pragma once

#include "io/ply/face_attributes.hpp"
#include "io/ply/ply_header.hpp"
#include "lichtraum/bounds.hpp"

namespace lichtraum::ply {

struct Data {
  MeshGeometry geometry;
  FaceAttributes faces;
  Bounds extent;  ///< of the positions as written
};

/// Reads vertices and faces (also as strips). What is wrong is a warning; where the data ends too early, what was read
/// until then counts. The indices are not checked yet. Colours become linear, texture coordinates count from above.
/// `origin` is taken off all positions.
Data read_data(std::string_view bytes, Header const& header, Diagnostics& diagnostics, Vec3 const& origin = Vec3(0));

}  // namespace lichtraum::ply
