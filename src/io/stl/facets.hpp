#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "io/text/diagnostics.hpp"
#include "lichtraum/bounds.hpp"
#include "lichtraum/mesh_geometry.hpp"

namespace lichtraum::stl {

/// The corners of its facets, three each, in the file's order; all are finite.
struct Solid {
  std::string name;  ///< may be empty
  std::vector<Float3> corners;
};

/// Whether the bytes are as many as a binary STL file's, which has at least one facet.
bool has_binary_size(std::string_view bytes);

/// Whether bytes of an STL file are binary. Those may begin with "solid" like ASCII ones.
bool is_binary(std::string_view bytes);

struct Solids {
  std::vector<Solid> solids;
  Bounds extent;  ///< of the corners as written
};

/// Reads a binary file, as one solid. What is wrong is reported with its byte; what is whole is kept. `origin` is taken
/// off all corners.
Solids read_binary(std::string_view bytes, Diagnostics& diagnostics, Vec3 const& origin = Vec3(0));

/// Reads an ASCII file. What is wrong is reported with its line; what is whole is kept. `origin` as above.
Solids read_ascii(std::string_view text, Diagnostics& diagnostics, Vec3 const& origin = Vec3(0));

/// A mesh that has one vertex for all corners at the same place. It shades flat, like any without normals.
std::shared_ptr<MeshGeometry const> merged(std::vector<Float3> corners);

}  // namespace lichtraum::stl
