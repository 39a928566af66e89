#include "lichtraum/shape.hpp"

#include <ostream>

#include "core/format_numbers.hpp"
#include "lichtraum/shapes.hpp"

namespace lichtraum {
namespace {

class Printer final : public ShapeVisitor {
 public:
  explicit Printer(std::ostream& out) : out_(out) {}

  void visit(Sphere const& sphere) override {
    out_ << fmt::format("sphere '{}': center {}, radius {}", sphere.name(), format_numbers(sphere.center()),
                        sphere.radius());
    print_material(sphere);
  }

  void visit(Box const& box) override {
    out_ << fmt::format("box '{}': min {}, max {}", box.name(), format_numbers(box.min()), format_numbers(box.max()));
    print_material(box);
  }

  void visit(Triangle const& triangle) override {
    auto const& [a, b, c] = triangle.vertices();
    out_ << fmt::format("triangle '{}': {}, {}, {}", triangle.name(), format_numbers(a), format_numbers(b),
                        format_numbers(c));
    print_material(triangle);
  }

  void visit(Mesh const& mesh) override {
    std::size_t const count = mesh.geometry()->triangle_count();
    out_ << fmt::format("mesh '{}': {} {}", mesh.name(), count, count == 1 ? "triangle" : "triangles");
    print_material(mesh);
  }

  void visit(Composite const& composite) override {
    std::size_t const count = composite.children().size();
    out_ << fmt::format("composite '{}': {} {}", composite.name(), count, count == 1 ? "child" : "children");
  }

 private:
  void print_material(Shape const& shape) {
    if (shape.material()) out_ << fmt::format(", material '{}'", shape.material()->name());
  }

  std::ostream& out_;
};

}  // namespace

std::string_view name_of(ShapeKind kind) {
  switch (kind) {
    case ShapeKind::sphere:
      return "sphere";
    case ShapeKind::box:
      return "box";
    case ShapeKind::triangle:
      return "triangle";
    case ShapeKind::mesh:
      return "mesh";
    case ShapeKind::composite:
      return "composite";
  }
  return {};
}

Transform const& Shape::world_from_object() const {
  static Transform const identity;
  return world_from_object_ ? *world_from_object_ : identity;
}

void Shape::apply(Transform const& t) { set_world_from_object(t * world_from_object()); }

void Shape::set_world_from_object(Transform const& t) {
  world_from_object_ = t.is_identity() ? nullptr : std::make_unique<Transform>(t);
}

Ray Shape::object_from_world(Ray const& ray) const {
  if (!world_from_object_) return ray;
  Mat4 const& inverse = world_from_object_->inverse_matrix();
  return {Vec3(inverse * glm::dvec4(ray.origin, 1)), Mat3(inverse) * ray.direction};
}

std::ostream& operator<<(std::ostream& out, Shape const& shape) {
  Printer printer(out);
  shape.accept(printer);
  return out;
}

}  // namespace lichtraum
