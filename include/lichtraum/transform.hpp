#pragma once

#include "lichtraum/api.hpp"
#include "lichtraum/math.hpp"

namespace LICHTRAUM_API lichtraum {

/// An invertible affine map from one frame to another, kept with its inverse. The inverse is composed along with the
/// map, never computed by elimination, so that scales of 1e-6 or 1e6 lose nothing. All that makes one throws
/// std::invalid_argument for numbers that are not finite.
class Transform {
 public:
  Transform() = default;

  static Transform translation(Vec3 const& offset);
  /// Right-handed, about an axis through the origin. Throws std::invalid_argument for an axis of length zero.
  static Transform rotation(double angle_degrees, Vec3 const& axis);
  /// Every factor must be non-zero: throws std::invalid_argument. Negative factors mirror.
  static Transform scaling(Vec3 const& factors);
  /// For matrices that come ready-made. Throws std::invalid_argument when `matrix` has no inverse or is not affine.
  static Transform from_matrix(Mat4 const& matrix);
  /// The frame at `eye` whose -z axis points along `direction` and whose +y axis lies in the plane of `up`. Throws
  /// std::invalid_argument when `direction` is zero or parallel to `up`.
  static Transform look_along(Vec3 const& eye, Vec3 const& direction, Vec3 const& up);

  Mat4 const& matrix() const { return matrix_; }
  Mat4 const& inverse_matrix() const { return inverse_; }
  Transform inverse() const { return Transform(inverse_, matrix_); }
  bool is_identity() const;

  Vec3 point(Vec3 const& p) const { return Vec3(matrix_ * glm::dvec4(p, 1)); }
  Vec3 vector(Vec3 const& v) const { return Mat3(matrix_) * v; }
  /// Maps a surface normal by the inverse transpose; the result is not normalised.
  Vec3 normal(Vec3 const& n) const { return glm::transpose(Mat3(inverse_)) * n; }

  /// (a * b) applies b first.
  friend Transform operator*(Transform const& a, Transform const& b) {
    return Transform(a.matrix_ * b.matrix_, b.inverse_ * a.inverse_);
  }

 private:
  Transform(Mat4 const& matrix, Mat4 const& inverse) : matrix_(matrix), inverse_(inverse) {}

  Mat4 matrix_{1};
  Mat4 inverse_{1};
};

}  // namespace lichtraum
