#include "lichtraum/camera.hpp"

#include <glm/trigonometric.hpp>
#include <ostream>
#include <stdexcept>

#include "core/elementary.hpp"
#include "core/format_numbers.hpp"
#include "scene/unit_vector.hpp"

namespace lichtraum {

Camera::Camera(std::string name, double fov_x_degrees, Transform const& world_from_camera,
               std::optional<Resolution> resolution)
    : name_(std::move(name)),
      fov_x_degrees_(fov_x_degrees),
      resolution_(resolution),
      world_from_camera_(world_from_camera) {
  if (!(fov_x_degrees > 0 && fov_x_degrees < 180)) {
    throw std::invalid_argument("a camera's opening angle must lie between 0 and 180 degrees");
  }
}

Ray Camera::generate_ray(double x, double y, Resolution const& size) const {
  double const pixel = 2 * tan_of(glm::radians(fov_x_degrees_) / 2) / size.width;  // its width at distance 1
  Vec3 const direction((x - size.width / 2.0) * pixel, (size.height / 2.0 - y) * pixel, -1);
  return {world_from_camera_.point(Vec3(0)), unit_vector(world_from_camera_.vector(direction))};
}

std::ostream& operator<<(std::ostream& out, Camera const& camera) {
  Vec3 const eye = camera.world_from_camera().point(Vec3(0));
  Vec3 const direction = unit_vector(camera.world_from_camera().vector(Vec3(0, 0, -1)));
  out << fmt::format("camera '{}': fov {} degrees, at {}, looking along {}", camera.name(), camera.fov_x_degrees(),
                     format_numbers(eye), format_numbers(direction));
  if (camera.resolution()) out << fmt::format(", {} x {}", camera.resolution()->width, camera.resolution()->height);
  return out;
}

}  // namespace lichtraum
