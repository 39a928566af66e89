#include "app/scene_summary.hpp"

#include <algorithm>
#include <limits>
#include <unordered_map>
#include <unordered_set>
#include <vector>

namespace lichtraum::app {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

std::uint64_t ShapeCounts::*const all_counts[] = {&ShapeCounts::spheres,        &ShapeCounts::boxes,
                                                  &ShapeCounts::triangles,      &ShapeCounts::meshes,
                                                  &ShapeCounts::mesh_triangles, &ShapeCounts::composites};

void add_saturating(ShapeCounts& counts, ShapeCounts const& more) {
  for (auto const count : all_counts) counts.*count = std::min(counts.*count + more.*count, SceneSummary::uncountable);
}

struct Box3 {
  Vec3 min{infinity};
  Vec3 max{-infinity};

  void add(Vec3 const& point) {
    min = glm::min(min, point);
    max = glm::max(max, point);
  }
  void add(Box3 const& box, Transform const& transform) {
    if (!(box.min.x <= box.max.x)) return;
    for (int corner = 0; corner < 8; ++corner) {
      add(transform.point({corner & 1 ? box.max.x : box.min.x, corner & 2 ? box.max.y : box.min.y,
                           corner & 4 ? box.max.z : box.min.z}));
    }
  }
};

/// What a shape draws, all below it included, in its own frame.
struct Below {
  ShapeCounts counts;
  Box3 box;
};

class Summariser final : public ShapeVisitor {
 public:
  /// Of `shape` and all below it, without recursion: a graph may be 100,000 composites deep.
  Below const& of(Shape const& shape) {
    std::vector<Shape const*> open{&shape};
    while (!open.empty()) {
      Shape const& top = *open.back();
      if (known_.count(&top) != 0) {
        open.pop_back();
        continue;
      }
      missing_.clear();
      top.accept(*this);
      if (missing_.empty()) {
        known_.emplace(&top, result_);
        add_saturating(defined, own_);
        open.pop_back();
      } else {
        open.insert(open.end(), missing_.begin(), missing_.end());
      }
    }
    return known_.at(&shape);
  }

  ShapeCounts defined;  // each shape seen so far, once

 private:
  void visit(Sphere const& sphere) override {
    begin(&ShapeCounts::spheres);
    result_.box.add(sphere.center() - Vec3(sphere.radius()));
    result_.box.add(sphere.center() + Vec3(sphere.radius()));
  }
  void visit(Box const& box) override {
    begin(&ShapeCounts::boxes);
    result_.box.add(box.min());
    result_.box.add(box.max());
  }
  void visit(Triangle const& triangle) override {
    begin(&ShapeCounts::triangles);
    for (Vec3 const& vertex : triangle.vertices()) result_.box.add(vertex);
  }
  void visit(Mesh const& mesh) override {
    begin(&ShapeCounts::meshes);
    own_.mesh_triangles = result_.counts.mesh_triangles = mesh.geometry()->triangle_count();
    for (auto const& position : mesh.geometry()->positions) result_.box.add({position[0], position[1], position[2]});
  }
  void visit(Composite const& composite) override {
    begin(&ShapeCounts::composites);
    for (auto const& child : composite.children()) {
      auto const found = known_.find(child.get());
      if (found == known_.end()) {
        missing_.push_back(child.get());
        continue;
      }
      add_saturating(result_.counts, found->second.counts);
      result_.box.add(found->second.box, child->world_from_object());
    }
  }

  void begin(std::uint64_t ShapeCounts::*kind) {
    own_ = {};
    own_.*kind = 1;
    result_ = {own_, {}};
  }

  std::unordered_map<Shape const*, Below> known_;
  std::vector<Shape const*> missing_;  // children that must be known first
  ShapeCounts own_;
  Below result_;
};

std::vector<TextureImage const*> textures_of(Scene const& scene) {
  std::vector<TextureImage const*> images;
  std::unordered_set<TextureImage const*> known;
  for (auto const& material : scene.materials) {
    if (!material->pbr()) continue;
    for (auto const slot : texture_slots) {
      auto const& texture = ((*material->pbr()).*slot).texture;
      if (texture && texture->image && known.insert(texture->image.get()).second)
        images.push_back(texture->image.get());
    }
  }
  return images;
}

}  // namespace

SceneSummary summarise(Scene const& scene) {
  Summariser summariser;
  SceneSummary summary;
  Box3 bounds;
  for (auto const& root : scene.roots()) {
    Below const& below = summariser.of(*root);
    add_saturating(summary.drawn, below.counts);
    bounds.add(below.box, root->world_from_object());
  }
  for (auto const& shape : scene.shapes) summariser.of(*shape);
  summary.defined = summariser.defined;
  summary.bounds_min = bounds.min;
  summary.bounds_max = bounds.max;
  summary.textures = textures_of(scene);
  summary.scene = &scene;
  return summary;
}

}  // namespace lichtraum::app
