#pragma once

#include <cstdint>

#include "lichtraum/background.hpp"
#include "lichtraum/film.hpp"

namespace lichtraum::app {

/// How much of what a picture shows is pure white, as it is brighter than the picture can store.
class Whiteness {
 public:
  /// Pixels of it, developed so.
  void add(Image const& pixels, Development const& development);

  /// 0..1, of the pixels that show the scene: `seen` of all, and everything where the background is an environment.
  /// Where the background itself is white, so many white pixels as show nothing else do not count.
  double share(double seen, Background const& background, Development const& development) const;

 private:
  std::uint64_t pixels_ = 0;
  std::uint64_t white_ = 0;
};

}  // namespace lichtraum::app
