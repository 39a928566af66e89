#pragma once

#include <array>

#include "io/ply/ply_header.hpp"

namespace lichtraum::ply {

/// How the properties of a vertex, an edge or a face become a row of numbers, and lists beside it.
struct Columns {
  enum Slot : std::size_t {
    x,
    y,
    z,
    nx,
    ny,
    nz,
    u,
    v,
    begin,
    end,
    red,
    green,
    blue,
    alpha,
    picture,
    corners,    ///< a list: the vertices of a face
    texcoords,  ///< a list: u and v for each corner of a face
    slot_count,
    none = slot_count
  };

  /// How a number of a colour becomes one from 0 to 1; others stay as they are.
  struct Range {
    double divisor = 1;
    bool is_float_color = false;
  };

  /// `float_white`: the largest value of colours that are floats.
  Columns(Element const& element, double float_white);
  bool has_colors() const { return has[red] && has[green] && has[blue]; }

  std::vector<Slot> slots;    ///< of each property
  std::vector<Range> ranges;  ///< likewise
  std::array<bool, slot_count + 1> has{};
};

}  // namespace lichtraum::ply
