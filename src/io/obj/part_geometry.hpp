#pragma once

#include <memory>

#include "io/obj/obj_file.hpp"

namespace lichtraum::obj {

/// Turns the corners of parts, which number positions, texture coordinates and normals each for themselves, into
/// geometry with one number for all, each of its own vertices only.
class PartGeometry {
 public:
  explicit PartGeometry(ObjFile const& file);
  /// `has_picture`: of its colours. Where it is looked up, those of vertices are left out: programs that make both from
  /// photographs write the same in either, and both would darken each other.
  std::shared_ptr<MeshGeometry const> of(Part const& part, bool has_picture);

 private:
  void add_vertex(Corner const& corner, MeshGeometry& out) const;
  void index_positions(Part const& part, MeshGeometry& out);
  void index_corners(Part const& part, MeshGeometry& out);

  ObjFile const& file_;
  std::vector<Float3> linear_colors_;
  bool with_colors_ = false;                       ///< of the part at hand
  std::vector<std::uint32_t> vertex_of_position_;  ///< all none between two parts
};

}  // namespace lichtraum::obj
