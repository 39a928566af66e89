#include "io/framing.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/trigonometric.hpp>
#include <limits>
#include <unordered_map>

namespace lichtraum {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr WorldBox empty_box{Vec3(infinity), Vec3(-infinity)};

std::array<Vec3, 8> corners_of(WorldBox const& box) {
  std::array<Vec3, 8> corners;
  for (std::size_t i = 0; i < 8; ++i) {
    corners[i] = {i & 1 ? box.max.x : box.min.x, i & 2 ? box.max.y : box.min.y, i & 4 ? box.max.z : box.min.z};
  }
  return corners;
}

void add(WorldBox& box, Vec3 const& p) {
  box.min = glm::min(box.min, p);
  box.max = glm::max(box.max, p);
}

void add(WorldBox& box, Transform const& transform, WorldBox const& inner) {
  if (inner.is_empty()) return;
  for (Vec3 const& corner : corners_of(inner)) add(box, transform.point(corner));
}

/// The box of a leaf in its own frame; a composite's is left empty.
class LeafBox final : public ShapeVisitor {
 public:
  WorldBox box = empty_box;
  Composite const* composite = nullptr;

  void visit(Sphere const& sphere) override {
    box = {sphere.center() - sphere.radius(), sphere.center() + sphere.radius()};
  }
  void visit(Box const& shape) override { box = {shape.min(), shape.max()}; }
  void visit(Triangle const& triangle) override {
    for (Vec3 const& vertex : triangle.vertices()) add(box, vertex);
  }
  void visit(Mesh const& mesh) override { box = {mesh.min(), mesh.max()}; }
  void visit(Composite const& shape) override { composite = &shape; }
};

/// The boxes of shapes in their own frames, children first, without recursion.
class Boxes {
 public:
  WorldBox const& of(Shape const& root) {
    std::vector<Shape const*> open{&root};
    while (!open.empty()) {
      Shape const& shape = *open.back();
      if (known_.contains(&shape)) {
        open.pop_back();
        continue;
      }
      LeafBox leaf;
      shape.accept(leaf);
      bool is_ready = true;
      if (leaf.composite) {
        for (auto const& child : leaf.composite->children()) {
          if (known_.contains(child.get())) continue;
          open.push_back(child.get());
          is_ready = false;
        }
        if (!is_ready) continue;
        for (auto const& child : leaf.composite->children()) {
          add(leaf.box, child->world_from_object(), known_.at(child.get()));
        }
      }
      known_.emplace(&shape, leaf.box);
      open.pop_back();
    }
    return known_.at(&root);
  }

 private:
  std::unordered_map<Shape const*, WorldBox> known_;
};

}  // namespace

WorldBox bounds_of(std::vector<std::shared_ptr<Shape const>> const& roots) {
  WorldBox box = empty_box;
  Boxes boxes;
  for (auto const& root : roots) add(box, root->world_from_object(), boxes.of(*root));
  return box;
}

Camera frame_box(std::string name, WorldBox const& box) {
  constexpr double fov_x_degrees = 45;
  constexpr double elevation_degrees = 15;
  constexpr double margin = 1.1;
  constexpr Resolution resolution{1024, 768};
  WorldBox const seen = box.is_empty() ? WorldBox{Vec3(-1), Vec3(1)} : box;
  Vec3 const center = 0.5 * seen.min + 0.5 * seen.max;
  double const elevation = glm::radians(elevation_degrees);
  Vec3 const back(0, std::sin(elevation), std::cos(elevation));  // from the centre to the camera
  Transform const world_from_camera_frame = Transform::look_along(Vec3(0), -back, Vec3(0, 1, 0));
  double const tan_x = std::tan(glm::radians(fov_x_degrees) / 2);
  double const tan_y = tan_x * resolution.height / resolution.width;
  double distance = 0;
  for (Vec3 const& corner : corners_of(seen)) {
    // As seen from the centre: x to the right, y up, z towards the camera.
    Vec3 const p = world_from_camera_frame.inverse().vector(corner - center);
    distance = std::max({distance, p.z + margin * std::abs(p.x) / tan_x, p.z + margin * std::abs(p.y) / tan_y});
  }
  if (!(distance > 0)) distance = 1;  // a single point
  return Camera(std::move(name), fov_x_degrees,
                Transform::translation(center + distance * back) * world_from_camera_frame, resolution);
}

std::vector<Light> studio_lights(WorldBox const& box) {
  WorldBox const lit = box.is_empty() ? WorldBox{Vec3(-1), Vec3(1)} : box;
  Vec3 const center = 0.5 * lit.min + 0.5 * lit.max;
  double const size = std::max(glm::length(lit.max - lit.min), 1e-30);
  // Far away for their size: nearly parallel light, so that no part of the model is much brighter than another.
  double const distance = 10 * size;
  return {Light::point("key", center + distance * glm::normalize(Vec3(0.6, 1, 0.9)), Rgb(0.8)),
          Light::point("fill", center + distance * glm::normalize(Vec3(-1, 0.3, 0.6)), Rgb(0.3)),
          Light::ambient("soft", Rgb(0.2))};
}

}  // namespace lichtraum
