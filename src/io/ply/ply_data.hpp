#pragma once

#include "io/ply/face_attributes.hpp"
#include "io/ply/ply_header.hpp"

namespace lichtraum::ply {

struct Data {
  MeshGeometry geometry;
  FaceAttributes faces;
};

/// Reads vertices and faces (also as strips). What is wrong is a warning; where the data ends too early, what was read
/// until then counts. The indices are not checked yet. Colours become linear, texture coordinates count from above.
Data read_data(std::string_view bytes, Header const& header, Diagnostics& diagnostics);

}  // namespace lichtraum::ply
