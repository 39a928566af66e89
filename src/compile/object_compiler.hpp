#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include "accel/bvh.hpp"
#include "compile/scene_buffers.hpp"

namespace lichtraum {

/// Puts the primitives, hierarchies and attributes of one object after the other into a scene's buffers.
class ObjectCompiler {
 public:
  /// Objects that are the same in `previous` have their hierarchies from there; null: none are.
  ObjectCompiler(TreeLayout layout, SceneBuffers const* previous) : previous_(previous) { buffers_.layout = layout; }

  /// An object's primitives are in the buffers, its hierarchy is not built yet.
  struct Pending {
    ContentHasher content;
    PrimitiveRanges ranges;
    std::vector<BuildPrimitive> instances;
    std::vector<BuildPrimitive> unbounded_instances;
  };

  /// Moves the object's primitives into the buffers.
  std::unique_ptr<Pending> take(FlatObject&& object);
  CompiledObject const& build(std::unique_ptr<Pending> pending);
  /// `number`: of FlatScene::instances.
  void add_instance(std::size_t number, FlatInstance const& instance, CompiledObject const& object, Pending& world);
  /// Which kinds of shapes there are.
  void note_features();
  /// Once everything is built: attributes in the order of the layout's triangles and spheres.
  void finish();

  SceneBuffers& buffers() { return buffers_; }

 private:
  /// How many there were when an object's primitives were taken.
  struct FirstOfObject {
    std::size_t triangle, sphere, ellipsoid, cylinder;
  };

  /// Those of the primitives taken last.
  void take_attributes(FlatObject&& object, FirstOfObject const& first_of);
  /// Builds its hierarchy.
  CompiledObject add(Pending&& pending);
  CompiledObject const* find_in_previous(ContentHash const& content) const;
  CompiledObject add_binary(Bvh&& bvh);
  CompiledObject add_wide(Bvh const& bvh);
  /// The same object of the previous scene, wherever it was there.
  CompiledObject copy(CompiledObject const& known);
  /// Adds to what the object's nodes say of where their children are; modulo 2^32, so it may be negative.
  void move_nodes(CompiledObject const& object, device::uint nodes, device::uint leaves, device::uint sphere_blocks);

  SceneBuffers const* previous_;
  SceneBuffers buffers_;
  std::vector<double> instances_crowding_;            // by number, of the object that each places
  std::vector<std::size_t> instances_stack_sizes_;    // the same
  BigVector<device::TriangleAttributes> attributes_;  // of the triangles taken so far, as those are counted
  BigVector<device::uint> sphere_colors_;             // of the spheres
};

}  // namespace lichtraum
