#pragma once

#include "lichtraum/api.hpp"
#include "lichtraum/math.hpp"

namespace LICHTRAUM_API lichtraum {

/// What rays see that hit nothing.
struct Background {
  enum class Kind {
    colors,       ///< the camera's rays: from `top` at the picture's upper edge to `bottom` at its lower one, whatever
                  ///< their direction; mirrors and glass show the mean of both
    environment,  ///< the environment's light; only with an integrator that draws one
  };

  Kind kind = Kind::colors;
  Rgb top{0};     ///< linear radiance
  Rgb bottom{0};  ///< linear radiance

  Background() = default;
  Background(Rgb const& color) : top(color), bottom(color) {}
  Background(Rgb const& upper, Rgb const& lower) : top(upper), bottom(lower) {}
  static Background environment() {
    Background background;
    background.kind = Kind::environment;
    return background;
  }

  Rgb mean() const { return 0.5 * top + 0.5 * bottom; }
  friend bool operator==(Background const&, Background const&) = default;
};

}  // namespace lichtraum
