#include "scene/object_numbers.hpp"

#include <algorithm>

namespace lichtraum {

ObjectNumbers::ObjectNumbers(FlatScene const& scene) {
  std::uint64_t in_instances = 0;
  for (FlatInstance const& instance : scene.instances) {
    FlatObject const& object = scene.objects[instance.object];
    instances_.push_back({instance.world_shapes_before, instance.world_shapes_before + in_instances, object.first_shape,
                          object.shape_count});
    in_instances += object.shape_count;
  }
}

std::uint64_t ObjectNumbers::in_world(std::uint64_t shape) const {
  auto const next = std::upper_bound(instances_.begin(), instances_.end(), shape,
                                     [](std::uint64_t s, Instance const& i) { return s < i.world_shapes_before; });
  if (next == instances_.begin()) return shape + 1;
  Instance const& last = *std::prev(next);
  return shape + 1 + last.numbers_before - last.world_shapes_before + last.shape_count;
}

std::uint64_t ObjectNumbers::in_instance(std::size_t instance, std::uint64_t shape) const {
  Instance const& placed = instances_[instance];
  return placed.numbers_before + shape - placed.first_shape + 1;
}

std::optional<std::uint32_t> ObjectNumbers::instance_of(std::uint64_t object) const {
  auto const next = std::lower_bound(instances_.begin(), instances_.end(), object,
                                     [](Instance const& i, std::uint64_t n) { return i.numbers_before < n; });
  if (next == instances_.begin()) return std::nullopt;
  auto const last = std::prev(next);
  if (object > last->numbers_before + last->shape_count) return std::nullopt;
  return std::uint32_t(last - instances_.begin());
}

}  // namespace lichtraum
