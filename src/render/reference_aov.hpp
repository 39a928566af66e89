#pragma once

#include "lichtraum/renderer.hpp"
#include "render/reference_scene.hpp"

namespace lichtraum {

/// What a pixel holds instead of a picture, from the graph itself: the definition of Aov.
class ReferenceAov {
 public:
  /// Both must outlive it. Object numbers need a list of all that is drawn: 16 bytes an object.
  ReferenceAov(ReferenceScene const& scene, Aov aov);

  /// For a camera ray of unit direction.
  Rgb trace(Ray const& ray, RayCounts& counts) const;

 private:
  /// One occurrence of a shape that is not a composite.
  struct Leaf {
    Shape const* shape;
    std::size_t parent;  // its place in the transforms
  };
  void list_objects();
  std::uint64_t object_number(Ray const& ray) const;

  ReferenceScene const& scene_;
  Aov aov_;
  std::vector<Transform> world_from_parent_;
  std::vector<Leaf> leaves_;
};

}  // namespace lichtraum
