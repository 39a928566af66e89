#pragma once

#include "lichtraum/camera.hpp"

namespace lichtraum::view {

/// A camera that is moved by hand around a point. It begins as any camera of a scene, whatever its roll.
class OrbitCamera {
 public:
  /// `center`: roughly what is looked at; the camera goes around it where it is in the middle of the picture or little
  /// beside it, else around the point on the camera's axis nearest to it. `made_for`: the picture that the camera's
  /// opening angle is meant for. `up`: of any length but 0. `radius`: how far what is looked at reaches around
  /// `center`; 0: unknown. A camera in the midst of it, as in a room, goes around a point that is a share of that away.
  OrbitCamera(Camera camera, Vec3 const& center, Resolution const& made_for, Vec3 const& up = {0, 1, 0},
              double radius = 0);

  Camera const& camera() const { return camera_; }
  /// In front of the camera, on its axis or little beside it.
  Vec3 const& pivot() const { return pivot_; }
  double distance() const;

  /// Opens the angle, or makes an orthographic camera's picture wider, so that one of this size shows all that the one
  /// it was made for does: a wider one shows more at the sides, a narrower one more above and below.
  void fit_to(Resolution const& size);
  /// Around the line upwards through the pivot (to the right is positive: the scene turns to the left), and up towards
  /// its zenith, which it does not cross.
  void orbit(double right_degrees, double up_degrees);
  /// Camera and pivot, by shares of the picture's width at the pivot.
  void pan(double right, double up);
  /// Towards the pivot: 0.5 halves the distance, and what an orthographic camera sees across. > 0.
  void zoom(double factor);
  /// Moves along its own direction until it sees all of a ball in a picture of that size; an orthographic one takes the
  /// width that this needs.
  void frame(Vec3 const& center, double radius, Resolution const& size);

 private:
  void apply(Transform const& world_from_world);
  /// What it sees across, so far away.
  double width_at(double distance) const;
  /// Of an orthographic camera, in the picture that it is fitted to.
  void set_width(double width);

  Camera camera_;
  double fov_x_degrees_;  // in the picture that it was made for
  double width_;          // the same of an orthographic one
  Resolution made_for_;
  Vec3 up_;  // of length 1
  Vec3 pivot_;
};

/// Statements that define this camera in eSDF: `define camera`, with its lens, then, where it has them, a scale (per
/// axis, which is no standard, as a lens is none), a rotation and a translation, a line each. Its name is made one
/// word. A camera that was scaled after it was turned may be sheared as well: that is lost.
std::string camera_as_esdf(Camera const& camera, Resolution const& size);

}  // namespace lichtraum::view
