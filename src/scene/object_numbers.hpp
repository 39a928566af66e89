#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "scene/flat_scene.hpp"

namespace lichtraum {

/// From what the device says of a hit to the object's number as DrawnObjects counts: what is an instance there has
/// taken its numbers in the middle of the world's. Needs 32 bytes an instance and nothing else.
class ObjectNumbers {
 public:
  /// `instance` comes next in FlatScene::instances, and shows `object`. One that is not on the device still takes its
  /// numbers.
  void add_instance(FlatInstance const& instance, FlatObject const& object, bool is_on_device);

  /// Of a shape of the world itself.
  std::uint64_t in_world(std::uint64_t shape) const;
  /// Of a shape of the object that the device's instance of that number shows.
  std::uint64_t in_instance(std::uint64_t instance, std::uint64_t shape) const;
  /// The place in FlatScene::instances of the device's instance of that number.
  std::uint32_t flat_instance(std::uint64_t instance) const { return on_device_[instance]; }
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
  std::vector<std::uint32_t> on_device_;  // which of them are
};

}  // namespace lichtraum
