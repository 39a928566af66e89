#pragma once

#include <unordered_map>

#include "lichtraum/film.hpp"
#include "lichtraum/renderer.hpp"
#include "reference/scene.hpp"
#include "scene/object_numbers.hpp"

namespace lichtraum {

/// The numbers of a scene's instances and materials, as films have them.
struct ReferenceNumbers {
  ObjectNumbers objects;
  std::unordered_map<Material const*, std::uint32_t> materials;  ///< from 1
};

/// What one sample adds to the planes that are means; nothing where its ray hits nothing.
struct FirstSurface {
  double alpha = 0;
  Rgb albedo{0};
  Vec3 normal{0};
};

/// What a film holds of first surfaces, from the graph itself: the definition of its planes.
class ReferenceSurfaces {
 public:
  /// All must outlive it. Object numbers need a list of all that is drawn: 16 bytes an object.
  ReferenceSurfaces(ReferenceScene const& scene, ReferenceNumbers const& numbers, PlaneSet const& planes);

  /// Of a camera ray of unit direction, for Whitted's integrator.
  FirstSurface sample(Ray const& ray) const;

  struct Center {
    double depth = std::numeric_limits<double>::infinity();
    Vec3 position{0};
    std::uint32_t object = 0, instance = 0, material = 0;
  };
  /// Of a camera ray of unit direction. For paths, surfaces that are not double-sided hide their backs.
  Center center(Ray const& ray, Integrator integrator) const;

 private:
  /// One occurrence of a shape that is no composite.
  struct Leaf {
    Shape const* shape;
    std::size_t parent;  // its place in the transforms
  };
  void list_objects();
  std::uint64_t object_number(Ray const& ray) const;

  ReferenceScene const& scene_;
  ReferenceNumbers const& numbers_;
  std::vector<Transform> world_from_parent_;
  std::vector<Leaf> leaves_;
};

}  // namespace lichtraum
