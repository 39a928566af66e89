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
    opacity,  ///< of a Gaussian splat, before the logistic function
    picture,
    corners,    ///< a list: the vertices of a face
    texcoords,  ///< a list: u and v for each corner of a face
    slot_count,
    none = slot_count
  };

  /// How a number of a colour becomes one from 0 to 1; others stay as they are.
  struct Range {
    double divisor = 1;
    double offset = 0;
    bool is_clamped = false;
    bool is_float_color = false;
  };

  /// `float_white`: the largest value of colours that are floats.
  Columns(Element const& element, double float_white);
  bool has_colors() const { return has[red] && has[green] && has[blue]; }

  std::vector<Slot> slots;    ///< of each property
  std::vector<Range> ranges;  ///< likewise
  std::array<bool, slot_count + 1> has{};
  /// The colours are those of Gaussian splats (Kerbl et al. 2023, "3D Gaussian Splatting for Real-Time Radiance Field
  /// Rendering"): the first spherical harmonic of each channel, in sRGB's units, less 0.5.
  bool are_splats = false;
};

}  // namespace lichtraum::ply
