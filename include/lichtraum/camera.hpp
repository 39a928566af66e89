#pragma once

#include <iosfwd>
#include <optional>
#include <string>

#include "lichtraum/ray.hpp"
#include "lichtraum/transform.hpp"

namespace lichtraum {

struct Resolution {
  int width = 0;   ///< pixels
  int height = 0;  ///< pixels
  friend bool operator==(Resolution const&, Resolution const&) = default;
};

/// A pinhole camera. In its own frame it sits at the origin and looks along -z with +y up.
class Camera {
 public:
  /// 45 degrees wide at the origin, without a name.
  Camera() = default;
  /// `fov_x_degrees` is the full horizontal opening angle, 0 < fov < 180, else throws std::invalid_argument.
  Camera(std::string name, double fov_x_degrees, Transform const& world_from_camera = {},
         std::optional<Resolution> resolution = std::nullopt);

  std::string const& name() const { return name_; }
  double fov_x_degrees() const { return fov_x_degrees_; }
  std::optional<Resolution> const& resolution() const { return resolution_; }
  Transform const& world_from_camera() const { return world_from_camera_; }
  void set_world_from_camera(Transform const& t) { world_from_camera_ = t; }

  /// The world-space ray (unit direction) through the image point (x, y) of a `size` picture. Coordinates are in
  /// pixels from the top left corner: the centre of the first pixel is (0.5, 0.5). Pixels are square.
  Ray generate_ray(double x, double y, Resolution const& size) const;

 private:
  std::string name_;
  double fov_x_degrees_ = 45;
  std::optional<Resolution> resolution_;
  Transform world_from_camera_;
};

std::ostream& operator<<(std::ostream& out, Camera const& camera);

}  // namespace lichtraum
