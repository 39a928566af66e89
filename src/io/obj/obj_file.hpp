#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "io/drawn.hpp"
#include "io/text/diagnostics.hpp"
#include "lichtraum/math.hpp"
#include "lichtraum/mesh_geometry.hpp"

namespace lichtraum::obj {

/// A corner of a triangle, an end of a line, or a point: numbers into the lists of an ObjFile, or `none`.
struct Corner {
  static constexpr std::uint32_t none = 0xFFFFFFFF;
  std::uint32_t position = none;
  std::uint32_t texcoord = none;
  std::uint32_t normal = none;
};

/// What one object or group has of one material: triangles, lines, or points.
struct Part {
  std::string name;                             ///< of the object and the group; may be empty
  std::string material;                         ///< empty: none
  std::vector<Corner> corners;                  ///< three per triangle, two per line, one per point
  std::vector<std::uint32_t> smoothing_groups;  ///< one per triangle; 0: it is flat where it has no normals
};

/// A word of the text that a later step may find wrong.
struct Mention {
  Line line;
  Token word;
};

/// What an OBJ file says, faces cut into triangles. Every index in `parts` is within its list, every position that they
/// name finite.
struct ObjFile {
  Drawn draws = Drawn::triangles;  ///< what `parts` are
  std::optional<Vec3> origin;      ///< taken off all positions (far_origin)
  std::vector<Float3> positions;
  std::vector<Float3> colors;  ///< as written; empty or as many as positions
  std::vector<Float2> texcoords;
  std::vector<Float3> normals;          ///< of unit length, or 0 where the file has nonsense
  std::vector<Part> parts;              ///< none is empty
  std::vector<Mention> libraries;       ///< `mtllib`: all words after it
  std::vector<Mention> used_materials;  ///< `usemtl`: each name once
};

/// Reads the text of an OBJ file. What cannot be read is a warning and left out.
ObjFile read_obj(std::string_view text, Diagnostics& diagnostics);

/// Puts the lines together that a backslash at their end continues; line numbers stay as they are.
void join_continued_lines(std::string& text);

}  // namespace lichtraum::obj
