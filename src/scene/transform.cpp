#include "lichtraum/transform.hpp"

#include <cmath>
#include <glm/ext/matrix_transform.hpp>
#include <glm/matrix.hpp>
#include <glm/trigonometric.hpp>
#include <stdexcept>

#include "core/elementary.hpp"
#include "scene/check_finite.hpp"
#include "scene/unit_vector.hpp"

namespace lichtraum {
namespace {

bool is_finite(Mat4 const& m) {
  for (int column = 0; column < 4; ++column) {
    for (int row = 0; row < 4; ++row) {
      if (!std::isfinite(m[column][row])) return false;
    }
  }
  return true;
}

/// Rodrigues' rotation formula, for an axis of unit length.
Mat3 about(Vec3 const& axis, double radians) {
  double const c = cos_of(radians);
  Vec3 const across = sin_of(radians) * axis;
  Vec3 const along = (1 - c) * axis;
  return {{c + along.x * axis.x, along.x * axis.y + across.z, along.x * axis.z - across.y},
          {along.y * axis.x - across.z, c + along.y * axis.y, along.y * axis.z + across.x},
          {along.z * axis.x + across.y, along.z * axis.y - across.x, c + along.z * axis.z}};
}

}  // namespace

Transform Transform::translation(Vec3 const& offset) {
  check_finite(offset, "the offset of a translation");
  return Transform(glm::translate(Mat4(1), offset), glm::translate(Mat4(1), -offset));
}

Transform Transform::rotation(double angle_degrees, Vec3 const& axis) {
  if (!is_direction(axis)) throw std::invalid_argument("the axis of a rotation must be finite and not zero");
  check_finite(angle_degrees, "the angle of a rotation");
  double const angle = glm::radians(std::fmod(angle_degrees, 360.0));
  Mat4 const matrix(about(unit_vector(axis), angle));
  return Transform(matrix, glm::transpose(matrix));
}

Transform Transform::scaling(Vec3 const& factors) {
  Vec3 const inverse = 1.0 / factors;
  for (int axis = 0; axis < 3; ++axis) {
    if (factors[axis] == 0 || !std::isfinite(factors[axis]) || !std::isfinite(inverse[axis])) {
      throw std::invalid_argument("a scale factor must be finite and not zero");
    }
  }
  return Transform(glm::scale(Mat4(1), factors), glm::scale(Mat4(1), inverse));
}

Transform Transform::from_matrix(Mat4 const& matrix) {
  if (glm::transpose(matrix)[3] != glm::dvec4(0, 0, 0, 1)) {
    throw std::invalid_argument("the matrix is not affine: its last row is not 0 0 0 1");
  }
  // The 3x3 part alone, at a size around 1: its determinant then neither underflows nor overflows.
  Mat3 const linear(matrix);
  double largest = 0;
  for (int column = 0; column < 3; ++column) {
    for (int row = 0; row < 3; ++row) largest = std::max(largest, std::abs(linear[column][row]));
  }
  // Columns of unit length enclose a body of some volume, or lie in a plane but for rounding.
  constexpr double least_volume = 1e-15;
  Mat3 directions;
  for (int column = 0; column < 3; ++column) directions[column] = unit_vector(linear[column]);
  if (!(std::abs(glm::determinant(directions)) >= least_volume)) {
    throw std::invalid_argument("the matrix has no inverse");
  }
  Mat3 const linear_inverse = glm::inverse(linear / largest) / largest;
  Mat4 inverse(linear_inverse);
  inverse[3] = glm::dvec4(-(linear_inverse * Vec3(matrix[3])), 1);
  if (!is_finite(matrix) || !is_finite(inverse)) throw std::invalid_argument("the matrix has no inverse");
  return Transform(matrix, inverse);
}

Transform Transform::look_along(Vec3 const& eye, Vec3 const& direction, Vec3 const& up) {
  if (!is_direction(direction)) throw std::invalid_argument("the direction of view must be finite and not zero");
  if (!is_direction(up)) throw std::invalid_argument("the up vector must be finite and not zero");
  if (are_parallel(direction, up)) throw std::invalid_argument("the up vector is parallel to the direction of view");
  check_finite(eye, "the place of a view");
  Vec3 const back = -unit_vector(direction);
  Vec3 const x = glm::normalize(glm::cross(unit_vector(up), back));
  Mat4 rotation(1);
  rotation[0] = glm::dvec4(x, 0);
  rotation[1] = glm::dvec4(glm::cross(back, x), 0);
  rotation[2] = glm::dvec4(back, 0);
  return translation(eye) * Transform(rotation, glm::transpose(rotation));
}

bool Transform::is_identity() const { return matrix_ == Mat4(1); }

}  // namespace lichtraum
