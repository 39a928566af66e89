#pragma once

#include <optional>

#include "lichtraum/renderer.hpp"

namespace lichtraum::view {

/// The order in which a view gets its pictures: coarse ones at once, then every pixel, then smooth edges.
class Refinement {
 public:
  struct Pass {
    int pixel_side = 1;  ///< one ray for so many pixels along each axis
    int grid_side = 1;   ///< samples of a pixel along each axis
  };

  /// The next pass; nothing when the picture is as good as it gets.
  std::optional<Pass> next() {
    constexpr Pass passes[] = {{8, 1}, {4, 1}, {2, 1}, {1, 1}, {1, 2}, {1, 4}};
    if (done_ == std::size(passes)) return std::nullopt;
    return passes[done_++];
  }
  void restart() { done_ = 0; }

  /// The request for a pass of a view of `size`.
  static RenderRequest request(RenderRequest view, Pass const& pass) {
    auto const coarse = [&](int length) { return (length + pass.pixel_side - 1) / pass.pixel_side; };
    view.resolution = {coarse(view.resolution.width), coarse(view.resolution.height)};
    view.region = {0, 0, view.resolution.width, view.resolution.height};
    view.sampling = {Sampling::Pattern::grid, pass.grid_side * pass.grid_side};
    return view;
  }

 private:
  std::size_t done_ = 0;
};

}  // namespace lichtraum::view
