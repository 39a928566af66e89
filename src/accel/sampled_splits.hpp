#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "accel/lane_bounds.hpp"

namespace lichtraum {

/// The upper part of a hierarchy of many primitives: a tree of splits that are found from a sample of them, which is
/// enough for the surface area heuristic (Hunt, Mark and Stoll, "Fast kd-tree Construction with an Adaptive
/// Error-Bounded Heuristic", 2006). Then all are sorted into its leaves, the cells, in two passes, as samplesort does;
/// to divide them level by level takes two passes for each level, most of them through memory.
class SampledSplits {
 public:
  /// Fewer primitives stay in caches, and are divided level by level as quickly.
  static constexpr std::size_t min_size = 1 << 17;

  /// `all`: their bounds.
  SampledSplits(std::span<BuildPrimitive const> primitives, LaneBounds const& all);

  /// Splits and cells are numbered depth-first, so that the root is 0 and cells come from left to right.
  std::size_t size() const { return nodes_.size(); }
  bool is_cell(std::uint32_t number) const { return nodes_[number].children[0] == number; }
  /// Left and right of a split.
  std::array<std::uint32_t, 2> const& children(std::uint32_t number) const { return nodes_[number].children; }

  /// Copies the primitives that the splits are of, on every core; each cell gets at least one. Returns where it begins
  /// in `to`, by its number, and then the end. (A split's place is that of the next cell.)
  std::vector<std::size_t> sort_into_cells(std::span<BuildPrimitive const> from, std::span<BuildPrimitive> to) const;

 private:
  struct Node {
    std::uint32_t axis = 0;
    float position = 0;                       ///< centres below it are on the left
    std::array<std::uint32_t, 2> children{};  ///< a cell's are itself, so that a search may go on there
    bool is_left(std::array<float, 4> const& center) const { return center[axis] < position; }
  };

  void divide(std::span<BuildPrimitive> sample, std::size_t depth);
  /// The cell of each primitive.
  void find_cells(std::span<BuildPrimitive const> primitives, std::span<std::uint32_t> cells) const;

  std::vector<Node> nodes_;
};

}  // namespace lichtraum
