#include "scene/bake.hpp"

#include <cmath>
#include <optional>

#include "scene/device_conversion.hpp"

namespace lichtraum {
namespace {

/// The factor by which a similarity (rotations, mirrors, one scale for all axes) scales, or nothing for another map.
std::optional<double> similarity_scale(Transform const& t) {
  constexpr double tolerance = 1e-7;  // a float has 24 bits: less than this moves no stored radius
  Mat3 const m(t.matrix());
  double const s2 = glm::dot(m[0], m[0]);
  auto const is = [&](double value, double expected) { return std::abs(value - expected) <= tolerance * s2; };
  bool const orthogonal = is(glm::dot(m[0], m[1]), 0) && is(glm::dot(m[1], m[2]), 0) && is(glm::dot(m[2], m[0]), 0);
  bool const uniform = is(glm::dot(m[1], m[1]), s2) && is(glm::dot(m[2], m[2]), s2);
  if (!orthogonal || !uniform) return std::nullopt;
  return std::sqrt(s2);
}

template <std::size_t N>
bool all_finite(float const (&values)[N]) {
  for (float const value : values) {
    if (!std::isfinite(value)) return false;
  }
  return true;
}

bool is_finite(device::AffineTransform const& t) {
  for (device::float4 const& row : {t.row_x, t.row_y, t.row_z}) {
    if (!all_finite({row.x, row.y, row.z, row.w})) return false;
  }
  return true;
}

class Baker final : public ShapeVisitor {
 public:
  Baker(Transform const& object_from_shape, device::PrimitiveTag tag, FlatObject& object)
      : object_from_shape_(object_from_shape), tag_(tag), object_(object) {}

  bool fits() const { return fits_; }

  void visit(Sphere const& sphere) override {
    if (auto const scale = similarity_scale(object_from_shape_)) {
      device::SpherePrimitive primitive{};
      store(object_from_shape_.point(sphere.center()), primitive.center);
      primitive.radius = float(*scale * sphere.radius());
      primitive.tag = tag_;
      fits_ = all_finite(primitive.center) && std::isnormal(primitive.radius);
      if (fits_) object_.spheres.push_back(primitive);
    } else {
      device::EllipsoidPrimitive primitive{};
      auto const object_from_unit =
          object_from_shape_ * Transform::translation(sphere.center()) * Transform::scaling(Vec3(sphere.radius()));
      primitive.unit_from_object = device_transform(object_from_unit.inverse());
      primitive.tag = tag_;
      fits_ = is_finite(primitive.unit_from_object);
      if (fits_) object_.ellipsoids.push_back(primitive);
    }
  }

  void visit(Box const& box) override {
    device::BoxPrimitive primitive{};
    primitive.box_from_object = device_transform(object_from_shape_.inverse());
    store(box.min(), primitive.min);
    store(box.max(), primitive.max);
    primitive.tag = tag_;
    fits_ = is_finite(primitive.box_from_object) && all_finite(primitive.min) && all_finite(primitive.max);
    if (fits_) object_.boxes.push_back(primitive);
  }

  void visit(Triangle const& triangle) override {
    device::TrianglePrimitive primitive{};
    for (std::size_t i = 0; i < 3; ++i) {
      store(object_from_shape_.point(triangle.vertices()[i]), primitive.vertices[i]);
      fits_ = fits_ && all_finite(primitive.vertices[i]);
    }
    primitive.tag = tag_;
    if (fits_) object_.triangles.push_back(primitive);
  }

  void visit(Composite const&) override {}  // no leaf: flatten unfolds it

 private:
  Transform const& object_from_shape_;
  device::PrimitiveTag tag_;
  FlatObject& object_;
  bool fits_ = true;
};

}  // namespace

bool bake(Shape const& shape, Transform const& object_from_shape, device::PrimitiveTag tag, FlatObject& object) {
  Baker baker(object_from_shape, tag, object);
  shape.accept(baker);
  return baker.fits();
}

}  // namespace lichtraum
