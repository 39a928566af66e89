#pragma once

#include "io/ply/face_attributes.hpp"
#include "io/ply/ply_header.hpp"
#include "lichtraum/bounds.hpp"

namespace lichtraum::ply {

struct Data {
  MeshGeometry geometry;
  FaceAttributes faces;
  Bounds extent;            ///< of the positions as written, those that are finite
  float largest_color = 0;  ///< of those that are floats
  bool are_splats = false;
  std::size_t faint_splats = 0;  ///< left out: more than half of the light goes through them
};

/// What a first look at the data may show to be needed.
struct Reading {
  Vec3 origin{0};                            ///< taken off all positions
  double float_white = 1;                    ///< the largest value of colours that are floats
  std::vector<bool> const* drawn = nullptr;  ///< which vertices count for the extent; null: all
};

/// Reads vertices and faces (also as strips). What is wrong is a warning; where the data ends too early, what was read
/// until then counts. The indices are not checked yet. Colours become linear, texture coordinates count from above.
Data read_data(std::string_view bytes, Header const& header, Diagnostics& diagnostics, Reading const& reading);

}  // namespace lichtraum::ply
