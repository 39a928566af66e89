#pragma once

#include <cstdint>

#include "lichtraum/background.hpp"
#include "lichtraum/film.hpp"

namespace lichtraum::app {

/// How much of what a picture shows is brighter than it can store, and so pure white, or so dark that nobody sees it.
class ExtremePixels {
 public:
  /// Pixels of it, developed so.
  void add(Image const& pixels, Development const& development);

  /// 0..1, of the pixels that show the scene: `seen` of all, and everything where the background is an environment.
  /// Where the background itself is so, as many such pixels as show nothing else do not count.
  double white_share(double seen, Background const& background, Development const& development) const;
  double black_share(double seen, Background const& background, Development const& development) const;

 private:
  struct Counts {
    std::uint64_t white = 0;
    std::uint64_t black = 0;
  };
  static Counts count(Image const& pixels, Development const& development);
  static Counts count(Rgb const& radiance, Development const& development);
  double share(std::uint64_t Counts::*which, double seen, Background const& background,
               Development const& development) const;

  std::uint64_t pixels_ = 0;
  Counts counts_;
};

}  // namespace lichtraum::app
