#pragma once

#include <algorithm>
#include <cmath>
#include <optional>

#include "lichtraum/renderer.hpp"

namespace lichtraum::view {

/// The order in which a view gets its pictures: coarse ones at once, then every pixel, then more and more samples.
class Refinement {
 public:
  static constexpr int coarsest_side = 16;
  /// What a view ends with when nothing else is asked for.
  static constexpr Sampling finest_by_default{Sampling::Pattern::seeded, 256};

  struct Pass {
    bool is_first = false;
    int pixel_side = 1;  ///< one ray for so many pixels along each axis
    Sampling sampling;   ///< of all samples since the first; seeded ones go on from those of the pass before
  };

  /// Whether a film of one pass can be gone on with in the next: the samples of a grid, and the one in the middle of a
  /// pixel, depend on how many there are.
  static bool grows(Sampling const& sampling) {
    return sampling.pattern == Sampling::Pattern::seeded && sampling.count > 1;
  }

  /// The next pass; nothing when the picture is as good as it gets.
  std::optional<Pass> next() {
    if (is_new_) {
      last_ = {true, first_side_, {}};
    } else if (last_.pixel_side > 1) {
      last_ = {false, last_.pixel_side / 2, {}};
    } else if (last_.sampling.count < finest_.count) {
      // Each of them takes as long as all before, so that looking at them in between costs little.
      bool const grows = finest_.pattern == Sampling::Pattern::seeded;
      last_ = {false, 1, {finest_.pattern, grows ? std::min(2 * last_.sampling.count, finest_.count) : finest_.count}};
    } else {
      return std::nullopt;
    }
    is_new_ = false;
    return last_;
  }

  /// With a view that was moved. `first_side`: of the coarsest pass. `finest`: of the last one.
  void restart(int first_side, Sampling const& finest) {
    first_side_ = first_side;
    finest_ = finest;
    is_new_ = true;
  }

  /// The smallest first side whose pass takes no longer than wanted, when a pixel takes so long.
  static int first_side_for(Resolution const& view, double seconds_per_pixel, double wanted_seconds) {
    double const pixels = double(view.width) * double(view.height);
    double const side = std::ceil(std::sqrt(pixels * seconds_per_pixel / wanted_seconds));
    return int(std::clamp(side, 1.0, double(coarsest_side)));
  }

  /// The request for a pass of a view.
  static RenderRequest request(RenderRequest view, Pass const& pass) {
    auto const coarse = [&](int length) { return (length + pass.pixel_side - 1) / pass.pixel_side; };
    view.resolution = {coarse(view.resolution.width), coarse(view.resolution.height)};
    view.region = whole_picture(view.resolution);
    view.sampling = pass.sampling;
    return view;
  }

 private:
  int first_side_ = 8;
  Sampling finest_ = finest_by_default;
  Pass last_;
  bool is_new_ = true;
};

}  // namespace lichtraum::view
