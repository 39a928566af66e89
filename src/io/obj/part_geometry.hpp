#pragma once

#include <memory>

#include "io/obj/obj_file.hpp"

namespace lichtraum::obj {

/// Turns the corners of parts, which number positions, texture coordinates and normals each for themselves, into meshes
/// with one number for all, each of its own vertices only.
class PartGeometry {
 public:
  explicit PartGeometry(ObjFile const& file);
  std::shared_ptr<MeshGeometry const> of(Part const& part);

 private:
  void add_vertex(Corner const& corner, MeshGeometry& out) const;
  void index_positions(Part const& part, MeshGeometry& out);
  void index_corners(Part const& part, MeshGeometry& out);

  ObjFile const& file_;
  std::vector<Float3> linear_colors_;
  std::vector<std::uint32_t> vertex_of_position_;  ///< all none between two parts
};

}  // namespace lichtraum::obj
