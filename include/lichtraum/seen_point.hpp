#pragma once

#include "lichtraum/api.hpp"
#include "lichtraum/renderer.hpp"

namespace LICHTRAUM_API lichtraum {

/// What a ray through a picture meets first.
struct SeenPoint {
  std::uint32_t object = 0;  ///< its number, see DrawnObjects
  double distance = 0;       ///< from the camera
  Vec3 position{0};          ///< in the world
  Vec3 normal{0};            ///< see FilmPlane::normal
};

/// What is seen in the middle of a pixel of the picture that `view` asks for; nothing where there is nothing. Of `view`
/// camera and resolution count.
std::optional<SeenPoint> look_at_pixel(Renderer& renderer, RenderRequest view, int x, int y);

}  // namespace lichtraum
