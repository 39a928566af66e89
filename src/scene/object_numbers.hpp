#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "scene/flat_scene.hpp"

namespace lichtraum {

/// From where a hit is in a FlatScene to the object's number as DrawnObjects counts: what is an instance there has
/// taken its numbers in the middle of the world's. Needs 32 bytes an instance and nothing else.
class ObjectNumbers {
 public:
  ObjectNumbers() = default;
  explicit ObjectNumbers(FlatScene const& scene);

  /// Of a shape of the world itself.
  std::uint64_t in_world(std::uint64_t shape) const;
  /// Of a shape of the object that FlatScene::instances[instance] shows.
  std::uint64_t in_instance(std::size_t instance, std::uint64_t shape) const;
  /// The place in FlatScene::instances of what an object belongs to; nothing for one of the world itself.
  std::optional<std::uint32_t> instance_of(std::uint64_t object) const;

 private:
  struct Instance {
    std::uint64_t world_shapes_before;
    std::uint64_t numbers_before;  // in all
    std::uint64_t first_shape;
    std::uint64_t shape_count;
  };
  std::vector<Instance> instances_;
};

}  // namespace lichtraum
