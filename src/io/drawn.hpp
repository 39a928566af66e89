#pragma once

namespace lichtraum {

/// What is drawn of a file whose format knows no scenes: triangles where it has any, else lines, else points.
enum class Drawn { triangles, lines, points };

/// Of a part that has no name.
constexpr char const* part_name(Drawn drawn) {
  switch (drawn) {
    case Drawn::triangles:
      return "mesh";
    case Drawn::lines:
      return "lines";
    case Drawn::points:
      return "points";
  }
  return "";
}

}  // namespace lichtraum
