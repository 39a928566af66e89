#pragma once

#include <vector>

#include "lichtraum/renderer.hpp"

namespace lichtraum::view {

/// What helps to find one's way in a picture, and is no part of it.
struct Overlays {
  bool grid = false;   ///< level with the lowest point, its lines a power of ten apart
  bool axes = false;   ///< of the world, from the origin: x red, y green, z blue
  bool edges = false;  ///< of objects, and where their surfaces turn or step
  Vec3 up{0, 1, 0};    ///< the grid's normal, of any length but 0

  /// What must be traced for them.
  PlaneSet planes() const;
  friend bool operator==(Overlays const&, Overlays const&) = default;
};

/// The overlays of a picture, which can be put on it again and again.
class OverlayLayer {
 public:
  OverlayLayer() = default;
  /// `film` holds overlays.planes() of the whole picture that the camera sees; `bounds` is what there is to see.
  OverlayLayer(Overlays const& overlays, Film const& film, Camera const& camera, Bounds const& bounds);

  /// Puts them on pixels as display_pixels makes them.
  void draw_on(std::vector<unsigned char>& pixels) const;

 private:
  void add_grid(Film const& film, Camera const& camera, Bounds const& bounds, Vec3 const& up);
  void add_axes(Film const& film, Camera const& camera, Bounds const& bounds);
  void add_edges(Film const& film);

  struct Pixel {
    float lines = 0;      // how much of it is covered by lines, which are dark on what is light, and light on the rest
    float axis = 0;       // by the axis
    int axis_number = 0;  // 0, 1, 2
  };
  Resolution size_;
  std::vector<Pixel> pixels_;
};

}  // namespace lichtraum::view
