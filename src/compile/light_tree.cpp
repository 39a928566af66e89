#include "compile/light_tree.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>

namespace lichtraum {
namespace {

double squared_diagonal(Bounds const& bounds) {
  Vec3 const diagonal = bounds.max - bounds.min;
  return bounds.is_empty() ? 0 : glm::dot(diagonal, diagonal);
}

/// Where lights lie together, and how bright they are.
struct Extent {
  Bounds bounds;
  double intensity = 0;

  void add(Bounds const& more_bounds, double more_intensity) {
    bounds.add(more_bounds);
    intensity += more_intensity;
  }
  double cost() const { return intensity * squared_diagonal(bounds); }
};

/// What becomes a child of a node.
struct Cluster {
  std::span<LightLeaf> leaves;
  Extent extent;

  explicit Cluster(std::span<LightLeaf> all) : leaves(all) {
    for (LightLeaf const& leaf : leaves) extent.add(leaf.bounds, leaf.intensity);
  }
  /// What is to be gained by dividing it: little for one that is dim, or small.
  double gain() const { return leaves.size() > 1 ? extent.cost() : -1; }
};

constexpr std::size_t bin_count = 16;

/// Where to divide a cluster: the surface area heuristic, with intensity for the number of primitives, and for the area
/// the square of the diagonal, as points have none. Returns the first leaf of the second part.
std::size_t divide(Cluster const& cluster) {
  std::span<LightLeaf> const leaves = cluster.leaves;
  Bounds centers;
  for (LightLeaf const& leaf : leaves) centers.add(leaf.bounds.center());
  Vec3 const width = centers.max - centers.min;
  Vec3 scale(0);  // flat along an axis: all in the first bin
  for (int axis = 0; axis < 3; ++axis) {
    if (width[axis] > 0) scale[axis] = double(bin_count) / width[axis];
  }
  std::array<std::array<Extent, bin_count>, 3> bins;
  for (LightLeaf const& leaf : leaves) {
    Vec3 const place = (leaf.bounds.center() - centers.min) * scale;
    for (int axis = 0; axis < 3; ++axis) {
      bins[std::size_t(axis)][std::min(std::size_t(place[axis]), bin_count - 1)].add(leaf.bounds, leaf.intensity);
    }
  }
  double best_cost = std::numeric_limits<double>::infinity();
  int best_axis = 0;
  double best_end = 0;
  for (int axis = 0; axis < 3; ++axis) {
    auto const& along = bins[std::size_t(axis)];
    std::array<double, bin_count> costs_above{};
    Extent above, below;
    for (std::size_t i = bin_count - 1; i > 0; --i) {
      above.add(along[i].bounds, along[i].intensity);
      costs_above[i] = above.cost();
    }
    for (std::size_t i = 1; i < bin_count && width[axis] > 0; ++i) {
      below.add(along[i - 1].bounds, along[i - 1].intensity);
      double const cost = below.cost() + costs_above[i];
      if (cost < best_cost) {
        best_cost = cost;
        best_axis = axis;
        best_end = centers.min[axis] + width[axis] * double(i) / double(bin_count);
      }
    }
  }
  auto const second = std::partition(leaves.begin(), leaves.end(),
                                     [&](LightLeaf const& leaf) { return leaf.bounds.center()[best_axis] < best_end; });
  std::size_t const count = std::size_t(second - leaves.begin());
  return count > 0 && count < leaves.size() ? count : leaves.size() / 2;  // all in one place
}

/// The parts that become a node's children.
std::vector<Cluster> parts_of(std::span<LightLeaf> leaves) {
  std::vector<Cluster> parts{Cluster(leaves)};
  while (parts.size() < LIGHT_TREE_CHILDREN) {
    auto const widest = std::ranges::max_element(parts, {}, &Cluster::gain);
    if (widest->leaves.size() < 2) break;
    std::size_t const middle = divide(*widest);
    std::span<LightLeaf> const all = widest->leaves;
    *widest = Cluster(all.first(middle));
    parts.emplace_back(all.subspan(middle));
  }
  return parts;
}

struct Facing {
  Vec3 axis{0};
  double spread = 1;
};

/// Normals say as much as their opposites.
Facing facing_of(std::span<LightLeaf const> leaves) {
  Vec3 const first = leaves.front().normal;
  auto const turned = [](Vec3 const& normal, Vec3 const& like) {
    return glm::dot(normal, like) < 0 ? -normal : normal;
  };
  Vec3 sum(0);
  for (LightLeaf const& leaf : leaves) {
    if (leaf.normal == Vec3(0)) return {};
    sum += leaf.intensity * turned(leaf.normal, first);
  }
  double const length = glm::length(sum);
  if (!(length > 0)) return {};
  Facing facing{sum / length, 0};
  for (LightLeaf const& leaf : leaves) {
    facing.spread = std::max(facing.spread, glm::length(turned(leaf.normal, facing.axis) - facing.axis));
  }
  return facing.spread < 1 ? facing : Facing{};
}

}  // namespace

BigVector<device::LightTreeNode> make_light_tree(std::vector<LightLeaf> leaves, double diagonal) {
  double const total = Cluster(leaves).extent.intensity;
  double const least_radius = 1e-6 * diagonal;
  BigVector<device::LightTreeNode> nodes(1, device::LightTreeNode{});
  std::vector<std::span<LightLeaf>> open{leaves};  // what is below nodes[i] is open[i]; no recursion, as it may be deep
  for (std::size_t i = 0; i < open.size(); ++i) {
    std::vector<Cluster> const parts = parts_of(open[i]);
    for (std::size_t lane = 0; lane < parts.size(); ++lane) {
      Cluster const& part = parts[lane];
      Vec3 const center = part.extent.bounds.center();
      Facing const facing = facing_of(part.leaves);
      device::LightTreeNode& node = nodes[i];
      for (int axis = 0; axis < 3; ++axis) {
        node.center[axis][lane] = float(center[axis]);
        node.axis[axis][lane] = float(facing.axis[axis]);
      }
      node.radius[lane] = float(std::max(0.5 * std::sqrt(squared_diagonal(part.extent.bounds)), least_radius));
      node.spread[lane] = float(facing.spread);
      node.intensity[lane] = float(part.extent.intensity / total);
      if (part.leaves.size() == 1) {
        node.children[lane] = LIGHT_TREE_LEAF | part.leaves.front().number;
      } else {
        node.children[lane] = device::uint(nodes.size());
        open.push_back(part.leaves);
        nodes.push_back({});
      }
    }
    // As far as none is there, no division by 0.
    for (std::size_t lane = parts.size(); lane < LIGHT_TREE_CHILDREN; ++lane) nodes[i].radius[lane] = 1;
  }
  return nodes;
}

}  // namespace lichtraum
