#pragma once

#include <cstdint>
#include <memory>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "lichtraum/api.hpp"
#include "lichtraum/scene.hpp"

namespace LICHTRAUM_API lichtraum {

/// The objects that a scene draws: each path from a root to a shape that is not a composite is one. They are numbered
/// from 1 in the order in which a walk down from the roots meets them, so those below one path of a composite follow
/// each other. What FilmPlane::object shows.
class DrawnObjects {
 public:
  DrawnObjects() = default;
  /// Of all roots, or of the shape called `root`. Keeps pointers to the shapes, which must not get other children.
  /// Throws Error{usage} for an unknown root.
  explicit DrawnObjects(Scene const& scene, std::string_view root = {});

  std::vector<std::shared_ptr<Shape const>> const& roots() const { return roots_; }
  /// How many there are in all, and below one occurrence of a shape (of one that is not a composite: 1). At most 2^62.
  std::uint64_t count() const { return count_; }
  std::uint64_t count_below(Shape const& shape) const;

  /// The way down to an object: which root, then which child of that, and so on. Empty for a number that none has.
  std::vector<std::uint32_t> path_of(std::uint64_t number) const;
  /// The shapes on such a way, the root first. Throws std::out_of_range when it leads nowhere.
  std::vector<std::shared_ptr<Shape const>> shapes_on(std::vector<std::uint32_t> const& path) const;

 private:
  std::vector<std::shared_ptr<Shape const>> roots_;
  std::uint64_t count_ = 0;
  std::unordered_map<Shape const*, std::uint64_t> counts_;  // below composites
};

}  // namespace lichtraum
