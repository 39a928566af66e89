#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "io/gltf/accessors.hpp"
#include "lichtraum/mesh_geometry.hpp"

namespace lichtraum::gltf {

/// What one morph target adds; lists are empty or as long as the positions.
struct MorphTarget {
  std::vector<Float3> positions;
  std::vector<Float3> normals;
  std::vector<Float3> tangents;
  std::vector<std::vector<Float2>> texcoords;  ///< of the geometry's sets
  std::vector<Float4> colors;
};

/// Up to four joints that move a vertex. A model may have several such sets for each vertex.
struct JointSet {
  std::vector<std::array<std::uint32_t, 4>> joints;
  std::vector<Float4> weights;
};

/// A primitive as the file holds it, before morphing and skinning.
struct Primitive {
  std::shared_ptr<MeshGeometry const> geometry;
  int material = -1;
  std::vector<MorphTarget> targets;
  std::vector<JointSet> joint_sets;
};

/// Reads primitives; those that name the same data share one geometry.
class Primitives {
 public:
  /// What has been read, and from which of the vertices that its accessors count.
  struct Known {
    std::shared_ptr<MeshGeometry const> geometry;
    std::size_t vertex_count = 0;
    std::shared_ptr<Accessors::Numbers const> kept;  ///< their numbers, ascending; null: all
  };
  /// By everything that decides it: attributes, indices, mode, compressed view.
  using Geometries = std::map<std::string, Known>;

  /// `known`: what was read before; what is read now is added.
  Primitives(Document const& document, Buffers& buffers, Accessors& accessors, Budget& budget, Findings& findings,
             Geometries& known)
      : document_(document),
        buffers_(buffers),
        accessors_(accessors),
        budget_(budget),
        findings_(findings),
        known_(known) {}

  /// Nothing when it has no triangles, lines or points that can be read: a finding says why. The geometry of lines and
  /// of points has no indices.
  std::optional<Primitive> read(int mesh, std::size_t primitive);

 private:
  struct Source;
  std::shared_ptr<MeshGeometry const> read_geometry(Source& source);
  bool decompress(Source& source);
  std::shared_ptr<MeshGeometry const> read_points(Source const& source, std::shared_ptr<MeshGeometry> geometry);
  std::shared_ptr<MeshGeometry const> read_lines(Source& source, std::shared_ptr<MeshGeometry> geometry);
  /// Of `indices`, `corners` for each triangle or line, as `noun` says. False: none is left.
  bool remove_faulty_parts(Source const& source, std::vector<std::uint32_t>& indices, std::size_t corners,
                           char const* noun, std::vector<Float3> const& positions);
  /// Into `source`, with what is kept for them. False where there are some that cannot be read.
  bool read_indices(Source& source);
  /// Without any, all vertices in their order.
  static std::vector<std::uint32_t> take_indices(Source& source);
  /// What of an accessor is read; null: all, also where it has too few elements.
  Accessors::Numbers const* kept_in(Source const& source, int accessor) const;
  template <std::size_t N>
  std::optional<std::vector<std::array<float, N>>> read_vectors(Source const& source, int accessor,
                                                                std::string const& place);
  template <std::size_t N>
  std::vector<std::array<float, N>> read_attribute(Source const& source, std::string const& name);
  std::vector<Float4> read_colors(Source const& source);
  /// Of what `geometry` has.
  std::vector<MorphTarget> read_targets(Source const& source, MeshGeometry const& geometry);
  struct TargetAttribute {
    int accessor = -1;  ///< -1: the target leaves it alone
    std::string place;
  };
  template <std::size_t N>
  std::vector<std::array<float, N>> read_deltas(Source const& source, TargetAttribute const& attribute);
  std::vector<Float4> read_color_deltas(Source const& source, TargetAttribute const& attribute);
  /// False, with a finding, where there are more or fewer than positions.
  bool has_delta_for_each(Source const& source, TargetAttribute const& attribute);
  std::vector<JointSet> read_joint_sets(Source const& source);

  Document const& document_;
  Buffers& buffers_;
  Accessors& accessors_;
  Budget& budget_;
  Findings& findings_;
  Geometries& known_;
};

}  // namespace lichtraum::gltf
