#pragma once

#include <iosfwd>
#include <optional>
#include <string>

#include "lichtraum/api.hpp"
#include "lichtraum/bounds.hpp"
#include "lichtraum/ray.hpp"
#include "lichtraum/transform.hpp"

namespace LICHTRAUM_API lichtraum {

struct Resolution {
  int width = 0;   ///< pixels
  int height = 0;  ///< pixels
  friend bool operator==(Resolution const&, Resolution const&) = default;
};

/// What a camera keeps in pictures of any proportions, where that is not its horizontal opening angle or its width.
struct CameraFit {
  enum class Side { width, height, longer };
  struct Framed {
    Bounds box;  ///< finite
    /// What the picture's middle shows. Without it the box's image is in the middle: as far from the left edge as from
    /// the right, and from the upper as from the lower.
    std::optional<Vec3> look_at = std::nullopt;
    /// The axis, through that or the box's center, around which the camera turns: it sees all of the box from anywhere
    /// there. Zero: it stays.
    Vec3 turn_axis{0};
    Vec3 center() const { return look_at.value_or(box.center()); }
  };

  Side side = Side::width;       ///< along which the picture has that opening angle, or that length
  double fov_degrees = 45;       ///< 0 < fov < 180
  std::optional<Framed> framed;  ///< the camera moves, without turning, until it sees all of this
  /// Above 0: an orthographic camera's, how long that side is in the camera's own frame. Where the camera frames
  /// something, it takes what that needs.
  double extent = 0;
};

/// What makes a picture sharp at one distance only.
struct Lens {
  double aperture = 0;        ///< diameter in units of the world, >= 0; 0: a pinhole, everything is sharp
  double focus_distance = 1;  ///< of the plane that is sharp, along the camera's axis in units of the world, > 0
  friend bool operator==(Lens const&, Lens const&) = default;
};

/// A pinhole camera, one with a thin lens, or one whose rays are parallel: an orthographic one, which sees what lies
/// before its plane z = 0. In its own frame it sits at the origin and looks along -z with +y up.
class Camera {
 public:
  /// 45 degrees wide at the origin, without a name.
  Camera() = default;
  /// `fov_x_degrees` is the full horizontal opening angle, 0 < fov < 180, else throws std::invalid_argument.
  Camera(std::string name, double fov_x_degrees, Transform const& world_from_camera = {},
         std::optional<Resolution> resolution = std::nullopt);

  /// An orthographic camera whose pictures show so much across: `width` in units of its own frame, above 0 and finite,
  /// else throws std::invalid_argument.
  static Camera orthographic(std::string name, double width, Transform const& world_from_camera = {},
                             std::optional<Resolution> resolution = std::nullopt);

  std::string const& name() const { return name_; }
  bool is_orthographic() const { return width_ > 0; }
  double fov_x_degrees() const { return fov_x_degrees_; }  ///< 0 of an orthographic camera
  double width() const { return width_; }                  ///< of an orthographic camera's pictures; 0 of others
  /// How much it sees across, so far ahead; both in units of its own frame.
  double width_at(double distance) const;
  std::optional<Resolution> const& resolution() const { return resolution_; }
  Transform const& world_from_camera() const { return world_from_camera_; }
  void set_world_from_camera(Transform const& t) { world_from_camera_ = t; }

  std::optional<CameraFit> const& fit() const { return fit_; }
  /// Throws std::invalid_argument for an opening angle that is none, or an extent that is negative or not finite.
  void set_fit(CameraFit const& fit);
  /// The camera of a picture of that size: its projection and its place are those that its `fit` asks for, which it no
  /// longer has.
  Camera fitted(Resolution const& size) const;

  Lens const& lens() const { return lens_; }
  /// Throws std::invalid_argument for numbers that are out of range or not finite.
  void set_lens(Lens const& lens);

  /// The world-space ray (unit direction) through the image point (x, y) of a `size` picture. Coordinates are in
  /// pixels from the top left corner: the centre of the first pixel is (0.5, 0.5). Pixels are square. `lens_x`,
  /// `lens_y`: where it goes through the lens, in its unit disc, +y up (pbrt 5.2.3). An orthographic camera's rays
  /// begin in its plane (pbrt 5.2.1).
  Ray generate_ray(double x, double y, Resolution const& size, double lens_x = 0, double lens_y = 0) const;

 private:
  std::string name_;
  double fov_x_degrees_ = 45;
  double width_ = 0;
  std::optional<Resolution> resolution_;
  Transform world_from_camera_;
  std::optional<CameraFit> fit_;
  Lens lens_;
};

std::ostream& operator<<(std::ostream& out, Camera const& camera);

}  // namespace lichtraum
