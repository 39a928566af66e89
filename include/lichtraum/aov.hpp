#pragma once

#include "lichtraum/renderer.hpp"

namespace lichtraum {

/// What was rendered as `aov`, as something to look at, 0..1: depth from white (the nearest in the picture) to dark
/// (the farthest), a normal's coordinates from -1..1 as red, green and blue, a colour of its own for each object. Black
/// where nothing is. A picture stays as it is.
Image aov_as_picture(Image image, Aov aov);

/// What a ray through a picture meets first.
struct SeenPoint {
  std::uint64_t object = 0;  ///< its number, see DrawnObjects
  double distance = 0;       ///< from the camera
  Vec3 position{0};          ///< in the world
  Vec3 normal{0};            ///< see Aov::normal
};

/// What is seen in the middle of a pixel of the picture that `view` asks for; nothing where there is nothing. Of `view`
/// camera and resolution count.
std::optional<SeenPoint> look_at_pixel(Renderer& renderer, RenderRequest view, int x, int y);

}  // namespace lichtraum
