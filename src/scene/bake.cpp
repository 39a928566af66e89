#include "scene/bake.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <glm/matrix.hpp>
#include <iterator>
#include <numeric>
#include <optional>

#include "core/float3.hpp"
#include "core/huge_pages.hpp"
#include "core/parallel_ranges.hpp"
#include "scene/bake_attributes.hpp"
#include "scene/device_conversion.hpp"
#include "scene/unit_vector.hpp"

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

bool is_finite(device::TrianglePrimitive const& t) {
  return all_finite(t.vertices[0]) && all_finite(t.vertices[1]) && all_finite(t.vertices[2]);
}

/// The frame at `origin` whose y axis is `up`, and whose others are `width` long.
Transform upright_frame(Vec3 const& origin, Vec3 const& up, double width) {
  Vec3 const y = unit_vector(up);
  Vec3 const size = glm::abs(y);
  Vec3 const least = size.x <= size.y && size.x <= size.z ? Vec3(1, 0, 0)
                     : size.y <= size.z                   ? Vec3(0, 1, 0)
                                                          : Vec3(0, 0, 1);
  Vec3 const z = glm::normalize(glm::cross(least, y));
  Mat4 frame(1);
  frame[0] = glm::dvec4(width * glm::cross(y, z), 0);
  frame[1] = glm::dvec4(up, 0);
  frame[2] = glm::dvec4(width * z, 0);
  frame[3] = glm::dvec4(origin, 1);
  return Transform::from_matrix(frame);
}

class Baker final : public ShapeVisitor {
 public:
  Baker(Transform const& object_from_shape, device::PrimitiveTag tag, FlatObject& object)
      : object_from_shape_(object_from_shape), tag_(tag), object_(object) {}

  std::uint64_t left_out() const { return left_out_; }

  void visit(Sphere const& sphere) override {
    if (auto const scale = similarity_scale(object_from_shape_)) {
      device::SpherePrimitive primitive{};
      store(object_from_shape_.point(sphere.center()), primitive.center);
      primitive.radius = float(*scale * sphere.radius());
      primitive.tag = tag_;
      append(primitive, all_finite(primitive.center) && std::isnormal(primitive.radius), object_.spheres);
    } else {
      append_unit_shape(Transform::translation(sphere.center()) * Transform::scaling(Vec3(sphere.radius())),
                        object_.ellipsoids);
    }
  }

  void visit(Box const& box) override {
    device::BoxPrimitive primitive{};
    primitive.box_from_object = device_transform(object_from_shape_.inverse());
    store(box.min(), primitive.min);
    store(box.max(), primitive.max);
    primitive.tag = tag_;
    append(primitive, is_finite(primitive.box_from_object) && all_finite(primitive.min) && all_finite(primitive.max),
           object_.boxes);
  }

  void visit(Triangle const& triangle) override {
    device::TrianglePrimitive primitive{};
    bool fits = true;
    for (std::size_t i = 0; i < 3; ++i) {
      store(object_from_shape_.point(triangle.vertices()[i]), primitive.vertices[place_of_corner(i)]);
      fits = fits && all_finite(primitive.vertices[place_of_corner(i)]);
    }
    primitive.tag = tag_;
    append(primitive, fits, object_.triangles);
  }

  void visit(Cylinder const& cylinder) override {
    append_unit_shape(upright_frame(cylinder.p1(), cylinder.p2() - cylinder.p1(), cylinder.radius()),
                      object_.cylinders);
  }

  void visit(Cone const& cone) override {
    append_unit_shape(upright_frame(cone.base(), cone.tip() - cone.base(), cone.radius()), object_.cones);
  }

  void visit(Plane const& plane) override {
    append_unit_shape(upright_frame(plane.point(), unit_vector(plane.normal()), 1), object_.planes);
  }

  void visit(Mesh const& mesh) override {
    MeshGeometry const& geometry = *mesh.geometry();
    std::vector<Float3> const positions = mapped(geometry.positions);
    std::size_t const first = object_.triangles.size();
    std::size_t const places[] = {place_of_corner(0), place_of_corner(1), place_of_corner(2)};
    reserve_in_huge_pages(object_.triangles, first + geometry.triangle_count());
    object_.triangles.resize(first + geometry.triangle_count());
    std::atomic<bool> all_fit = true;
    for_parallel_ranges(geometry.triangle_count(), min_elements_of_thread, [&](std::size_t begin, std::size_t end) {
      bool fits = true;
      for (std::size_t i = begin; i < end; ++i) {
        device::TrianglePrimitive& primitive = object_.triangles[first + i];
        for (std::size_t corner = 0; corner < 3; ++corner) {
          Float3 const& p = positions[geometry.indices[3 * i + corner]];
          std::copy(p.begin(), p.end(), primitive.vertices[places[corner]]);
        }
        primitive.tag = tag_;
        fits = fits && is_finite(primitive);
      }
      if (!fits) all_fit = false;
    });
    if (!all_fit) {
      auto const begin = object_.triangles.begin() + std::ptrdiff_t(first);
      auto const kept = std::remove_if(begin, object_.triangles.end(), [](auto const& t) { return !is_finite(t); });
      left_out_ += std::uint64_t(object_.triangles.end() - kept);
      object_.triangles.erase(kept, object_.triangles.end());
    }
    bake_attributes(mesh, object_from_shape_, positions, places, first, object_);
  }

  void visit(PointCloud const& points) override {
    std::vector<std::uint32_t> all(points.geometry()->positions.size());
    std::iota(all.begin(), all.end(), 0u);
    add_balls(*points.geometry(), all, points.radius(), points.material().get());
  }

  void visit(LineSet const& set) override {
    MeshGeometry const& geometry = *set.geometry();
    add_balls(geometry, set.ends(), set.radius(), set.material().get());
    std::vector<std::uint32_t> kept;
    for (std::size_t i = 0; i < set.line_count(); ++i) {
      std::uint32_t const ends[] = {geometry.lines[2 * i], geometry.lines[2 * i + 1]};
      Vec3 const p1 = to_vec3(geometry.positions[ends[0]]);
      Vec3 const axis = to_vec3(geometry.positions[ends[1]]) - p1;
      if (!set.is_line(i) || axis == Vec3(0)) continue;
      std::size_t const before = object_.cylinders.size();
      append_unit_shape(upright_frame(p1, axis, set.radius()), object_.cylinders);
      if (object_.cylinders.size() > before) kept.insert(kept.end(), std::begin(ends), std::end(ends));
    }
    bake_colors(geometry, set.material().get(), kept, 2, object_.cylinders.size(), object_.cylinder_colors, object_);
  }

  void visit(Composite const&) override {}  // no leaf: flatten unfolds it

 private:
  template <class T>
  void append_unit_shape(Transform const& shape_from_unit, BigVector<T>& list) {
    T primitive{};
    primitive.unit_from_object = device_transform((object_from_shape_ * shape_from_unit).inverse());
    primitive.tag = tag_;
    append(primitive, is_finite(primitive.unit_from_object), list);
  }

  template <class T>
  void append(T const& primitive, bool fits, BigVector<T>& list) {
    if (fits) {
      list.push_back(primitive);
    } else {
      ++left_out_;
    }
  }

  /// Around those of `vertices` that are finite.
  void add_balls(MeshGeometry const& geometry, std::vector<std::uint32_t> const& vertices, double radius,
                 Material const* material) {
    if (auto const scale = similarity_scale(object_from_shape_)) {
      auto const place = [&](Vec3 const& center, auto& primitive) {
        store(object_from_shape_.point(center), primitive.center);
        primitive.radius = float(*scale * radius);
        return all_finite(primitive.center) && std::isnormal(primitive.radius);
      };
      add_placed(geometry, vertices, material, object_.spheres, object_.sphere_colors, place);
    } else {
      auto const place = [&](Vec3 const& center, auto& primitive) {
        Transform const shape_from_unit = Transform::translation(center) * Transform::scaling(Vec3(radius));
        primitive.unit_from_object = device_transform((object_from_shape_ * shape_from_unit).inverse());
        return is_finite(primitive.unit_from_object);
      };
      add_placed(geometry, vertices, material, object_.ellipsoids, object_.ellipsoid_colors, place);
    }
  }

  /// `place(center, primitive)` says whether the primitive fits the device's numbers.
  template <class T, class Place>
  void add_placed(MeshGeometry const& geometry, std::vector<std::uint32_t> const& vertices, Material const* material,
                  BigVector<T>& list, BigVector<device::uint>& colors, Place const& place) {
    reserve_in_huge_pages(list, list.size() + vertices.size());
    std::vector<std::uint32_t> kept;
    kept.reserve(vertices.size());
    for (std::uint32_t const i : vertices) {
      Vec3 const center = to_vec3(geometry.positions[i]);
      if (!std::isfinite(center.x + center.y + center.z)) continue;  // no point
      T primitive{};
      primitive.tag = tag_;
      bool const fits = place(center, primitive);
      append(primitive, fits, list);
      if (fits) kept.push_back(i);
    }
    bake_colors(geometry, material, kept, 1, list.size(), colors, object_);
  }

  /// Mirroring would turn the winding round: then the last two corners change places.
  std::size_t place_of_corner(std::size_t corner) const { return is_mirrored_ && corner != 0 ? 3 - corner : corner; }

  std::vector<Float3> mapped(std::vector<Float3> const& points) const {
    std::vector<Float3> result(points.size());
    for_parallel_ranges(points.size(), min_elements_of_thread, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) {
        Vec3 const p = object_from_shape_.point({points[i][0], points[i][1], points[i][2]});
        result[i] = {float(p.x), float(p.y), float(p.z)};
      }
    });
    return result;
  }

  Transform const& object_from_shape_;
  device::PrimitiveTag tag_;
  FlatObject& object_;
  bool is_mirrored_ = glm::determinant(Mat3(object_from_shape_.matrix())) < 0;
  std::uint64_t left_out_ = 0;
};

}  // namespace

std::uint64_t bake(Shape const& shape, Transform const& object_from_shape, device::PrimitiveTag tag,
                   FlatObject& object) {
  Baker baker(object_from_shape, tag, object);
  shape.accept(baker);
  return baker.left_out();
}

}  // namespace lichtraum
