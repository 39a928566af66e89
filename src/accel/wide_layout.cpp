#include "accel/wide_layout.hpp"

#include <algorithm>
#include <array>
#include <future>
#include <limits>

#include "core/huge_pages.hpp"

namespace lichtraum {
namespace {

using device::BvhChild;
using device::uint;

/// What lies below a binary node, or in a binary leaf.
struct Content {
  static constexpr uint mixed_kind = 0xffffffffu;

  uint first = 0;  ///< reference
  uint count = 0;
  uint kind = PRIMITIVE_TRIANGLE;  ///< of all

  bool is_block() const { return count <= BLOCK_LANES && (kind == PRIMITIVE_TRIANGLE || kind == PRIMITIVE_SPHERE); }
  void add(Content const& other) {
    kind = count == 0 || kind == other.kind ? other.kind : mixed_kind;
    first = count == 0 ? other.first : first;  // left to right
    count += other.count;
  }
};

/// A child of a wide node that is being made.
struct Candidate {
  BvhChild child;
  Content content;
};

/// The children of a wide node that is being made, from left to right.
class Candidates {
 public:
  std::size_t size() const { return size_; }
  Candidate const& operator[](std::size_t i) const { return items_[i]; }
  void push_back(Candidate const& candidate) { items_[size_++] = candidate; }

 private:
  std::array<Candidate, WIDE_CHILDREN> items_;
  std::size_t size_ = 0;
};

/// What a subtree of the binary tree costs as at most n children of one wide node: the area of all wide nodes in it.
/// Nothing for a leaf, as blocks are the same whatever the nodes above them.
struct Costs {
  std::array<float, WIDE_CHILDREN> as{};               ///< by n; [0] is not used
  std::array<std::uint8_t, WIDE_CHILDREN> for_left{};  ///< how many of the n its left child gets; 0: it stays one child
};

float half_area_of_both(BvhChild const& a, BvhChild const& b) {
  std::array<float, 3> size;
  for (std::size_t i = 0; i < 3; ++i) size[i] = std::max(a.max[i], b.max[i]) - std::min(a.min[i], b.min[i]);
  return size[0] * size[1] + size[1] * size[2] + size[2] * size[0];
}

bool is_absent(BvhChild const& child) { return !(child.min[0] <= child.max[0]); }

class Collapser {
 public:
  explicit Collapser(Bvh const& bvh) : bvh_(bvh), contents_(bvh.nodes.size()), costs_(bvh.nodes.size()) {
    examine(0, bvh.nodes.size());
  }

  WideBvh run() {
    struct Open {
      uint binary;
      std::size_t parent;
      int lane;
      std::size_t stack_size;  ///< that the path to the parent needs
    };
    constexpr std::size_t none = std::numeric_limits<std::size_t>::max();
    std::vector<Open> open{{0, none, 0, 0}};
    reserve_in_huge_pages(wide_.nodes, bvh_.nodes.size() / 8);
    while (!open.empty()) {
      Open const top = open.back();
      open.pop_back();
      std::size_t const self = wide_.nodes.size();
      if (top.parent != none)
        wide_.nodes[top.parent].children[top.lane] = WIDE_KIND_NODE << WIDE_INDEX_BITS | uint(self);
      Candidates const children = gather(top.binary);
      device::WideNode& node = wide_.nodes.emplace_back();
      std::size_t const stack_size = top.stack_size + (std::max<std::size_t>(children.size(), 1) - 1);
      wide_.stack_size = std::max(wide_.stack_size, stack_size);
      std::size_t const first_open = open.size();
      for (int lane = 0; lane < WIDE_CHILDREN; ++lane) {
        bool const present = std::size_t(lane) < children.size();
        for (int axis = 0; axis < 3; ++axis) {
          node.bounds[2 * axis][lane] = present ? children[std::size_t(lane)].child.min[axis] : Bounds::infinity;
          node.bounds[2 * axis + 1][lane] = present ? children[std::size_t(lane)].child.max[axis] : -Bounds::infinity;
        }
        if (!present) continue;
        Candidate const& candidate = children[std::size_t(lane)];
        if (candidate.content.is_block()) {
          auto& blocks = candidate.content.kind == PRIMITIVE_SPHERE ? wide_.sphere_blocks : wide_.triangle_blocks;
          node.children[lane] = candidate.content.kind << WIDE_INDEX_BITS | uint(blocks.size());
          blocks.push_back({candidate.content.first, candidate.content.count});
        } else if (candidate.content.count == 1) {
          auto const& reference = bvh_.references[candidate.content.first];
          node.children[lane] = reference.kind << WIDE_INDEX_BITS | reference.index;
        } else {
          open.push_back({candidate.child.first, self, lane, stack_size});
        }
      }
      std::reverse(open.begin() + std::ptrdiff_t(first_open), open.end());
    }
    return std::move(wide_);
  }

 private:
  /// Finds contents and costs of the subtree that is nodes [root, end): nodes lie in depth-first order.
  void examine(std::size_t root, std::size_t end) {
    constexpr std::size_t part_size = 1 << 14;
    auto const& [left, right] = bvh_.nodes[root].children;
    std::size_t first_by_itself = end;
    if (end - root > part_size && left.count == 0 && right.count == 0) {
      auto other = std::async(std::launch::async, [&] { examine(right.first, end); });
      examine(left.first, right.first);
      other.get();
      first_by_itself = root + 1;
    }
    for (std::size_t i = first_by_itself; i-- > root;) {  // children before their parents
      for (BvhChild const& child : bvh_.nodes[i].children) {
        if (!is_absent(child)) contents_[i].add(content_of(child));
      }
      find_costs(i);
    }
  }

  Content content_of(BvhChild const& child) const {
    if (child.count == 0) return contents_[child.first];
    Content content;
    for (uint i = child.first; i < child.first + child.count; ++i) content.add({i, 1, bvh_.references[i].kind});
    return content;
  }

  bool is_leaf(BvhChild const& child) const { return child.count > 0 || contents_[child.first].is_block(); }

  Costs const& costs_of(BvhChild const& child) const {
    static constexpr Costs leaf{};
    return is_leaf(child) ? leaf : costs_[child.first];
  }

  struct Share {
    float cost = std::numeric_limits<float>::infinity();
    std::uint8_t for_left = 1;
  };
  /// The cheapest way to share n children among the two of a binary node.
  static Share best_share(Costs const& left, Costs const& right, std::size_t n) {
    Share best;
    for (std::size_t k = 1; k < n; ++k) {
      float const cost = left.as[k] + right.as[n - k];
      if (cost < best.cost) best = {cost, std::uint8_t(k)};
    }
    return best;
  }

  void find_costs(std::size_t binary) {
    auto const& [left, right] = bvh_.nodes[binary].children;
    if (is_absent(right) || contents_[binary].is_block()) return;
    Costs const& of_left = costs_of(left);
    Costs const& of_right = costs_of(right);
    Costs& costs = costs_[binary];
    costs.as[1] = half_area_of_both(left, right) + best_share(of_left, of_right, WIDE_CHILDREN).cost;
    for (std::size_t n = 2; n < WIDE_CHILDREN; ++n) {
      Share const share = best_share(of_left, of_right, n);
      bool const is_shared = share.cost < costs.as[1];
      costs.as[n] = is_shared ? share.cost : costs.as[1];
      costs.for_left[n] = is_shared ? share.for_left : std::uint8_t(0);
    }
  }

  /// The children of the wide node that begins at a binary node.
  Candidates gather(uint binary) const {
    Candidates children;
    auto const& [left, right] = bvh_.nodes[binary].children;
    if (is_absent(right)) {  // a root
      if (!is_absent(left)) children.push_back({left, content_of(left)});
      return children;
    }
    struct Part {
      BvhChild child;
      std::size_t share;  ///< it may become so many children
    };
    std::array<Part, WIDE_CHILDREN> open;
    std::size_t size = 0;
    auto const share_out = [&](device::BvhNode const& node, std::size_t n, std::size_t for_left) {
      open[size++] = {node.children[1], n - for_left};
      open[size++] = {node.children[0], for_left};
    };
    share_out(bvh_.nodes[binary], WIDE_CHILDREN, best_share(costs_of(left), costs_of(right), WIDE_CHILDREN).for_left);
    while (size > 0) {
      Part const part = open[--size];
      std::size_t const for_left = costs_of(part.child).for_left[part.share];
      if (for_left == 0) {
        children.push_back({part.child, content_of(part.child)});
      } else {
        share_out(bvh_.nodes[part.child.first], part.share, for_left);
      }
    }
    return children;
  }

  Bvh const& bvh_;
  std::vector<Content> contents_;
  std::vector<Costs> costs_;  // of nodes that do not become blocks
  WideBvh wide_;
};

}  // namespace

WideBvh collapse(Bvh const& bvh) { return Collapser(bvh).run(); }

namespace {

void fill_triangle_block(WideBvh::Block const& block, std::span<device::PrimitiveReference const> references,
                         std::span<device::TrianglePrimitive const> triangles, device::TriangleBlock& filled,
                         device::PrimitiveTag* tags) {
  for (uint lane = 0; lane < BLOCK_LANES; ++lane) {
    bool const present = lane < block.count;
    device::TrianglePrimitive const* triangle = present ? &triangles[references[block.first + lane].index] : nullptr;
    for (int corner = 0; corner < 3; ++corner) {
      for (int axis = 0; axis < 3; ++axis) {
        filled.vertices[corner][axis][lane] =
            present ? triangle->vertices[corner][axis] : std::numeric_limits<float>::quiet_NaN();
      }
    }
    tags[lane] = present ? triangle->tag : device::PrimitiveTag{};
  }
}

}  // namespace

void fill_triangle_blocks(std::span<WideBvh::Block const> blocks,
                          std::span<device::PrimitiveReference const> references,
                          std::span<device::TrianglePrimitive const> triangles, std::span<device::TriangleBlock> filled,
                          std::span<device::PrimitiveTag> tags) {
  constexpr std::size_t part_size = 1 << 14;
  if (blocks.size() > part_size) {
    std::size_t const half = blocks.size() / 2;
    auto rest = std::async(std::launch::async, [&] {
      fill_triangle_blocks(blocks.subspan(half), references, triangles, filled.subspan(half),
                           tags.subspan(half * BLOCK_LANES));
    });
    fill_triangle_blocks(blocks.first(half), references, triangles, filled, tags);
    return;
  }
  for (std::size_t b = 0; b < blocks.size(); ++b) {
    fill_triangle_block(blocks[b], references, triangles, filled[b], &tags[b * BLOCK_LANES]);
  }
}

void fill_block_attributes(std::span<WideBvh::Block const> blocks,
                           std::span<device::PrimitiveReference const> references,
                           std::span<device::TriangleAttributes const> attributes,
                           std::span<device::TriangleAttributes> filled) {
  for (std::size_t b = 0; b < blocks.size(); ++b) {
    for (uint lane = 0; lane < blocks[b].count; ++lane) {
      uint const triangle = references[blocks[b].first + lane].index;
      if (triangle < attributes.size()) filled[b * BLOCK_LANES + lane] = attributes[triangle];
    }
  }
}

void fill_sphere_blocks(std::span<WideBvh::Block const> blocks, std::span<device::PrimitiveReference const> references,
                        std::span<device::SpherePrimitive const> spheres, std::span<device::SphereBlock> filled) {
  for (std::size_t b = 0; b < blocks.size(); ++b) {
    for (uint lane = 0; lane < BLOCK_LANES; ++lane) {
      bool const present = lane < blocks[b].count;
      device::SpherePrimitive const sphere =
          present ? spheres[references[blocks[b].first + lane].index]
                  : device::SpherePrimitive{{}, std::numeric_limits<float>::quiet_NaN(), {}};
      for (int axis = 0; axis < 3; ++axis) filled[b].center[axis][lane] = sphere.center[axis];
      filled[b].radius[lane] = sphere.radius;
      filled[b].tags[lane] = sphere.tag;
    }
  }
}

}  // namespace lichtraum
