#include "accel/wide_layout.hpp"

#include <algorithm>
#include <array>
#include <future>
#include <limits>

namespace lichtraum {
namespace {

using device::BvhChild;
using device::uint;

/// What lies below a binary node, or in a binary leaf.
struct Content {
  uint first = 0;  ///< reference
  uint count = 0;
  bool only_triangles = true;

  bool is_block() const { return only_triangles && count <= BLOCK_LANES; }
  void add(Content const& other) {
    first = count == 0 ? other.first : first;  // left to right
    count += other.count;
    only_triangles = only_triangles && other.only_triangles;
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
  /// Puts two in the place of one.
  void replace(std::size_t place, Candidate const& first, Candidate const& second) {
    for (std::size_t i = size_++; i > place + 1; --i) items_[i] = items_[i - 1];
    items_[place] = first;
    items_[place + 1] = second;
  }

 private:
  std::array<Candidate, WIDE_CHILDREN> items_;
  std::size_t size_ = 0;
};

float half_area(BvhChild const& child) {
  float const x = child.max[0] - child.min[0], y = child.max[1] - child.min[1], z = child.max[2] - child.min[2];
  return x * y + y * z + z * x;
}

bool is_absent(BvhChild const& child) { return !(child.min[0] <= child.max[0]); }

class Collapser {
 public:
  explicit Collapser(Bvh const& bvh) : bvh_(bvh), contents_(bvh.nodes.size()) {
    // Depth-first order: children come after their parents.
    for (std::size_t i = bvh.nodes.size(); i-- > 0;) {
      for (BvhChild const& child : bvh.nodes[i].children) {
        if (!is_absent(child)) contents_[i].add(content_of(child));
      }
    }
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
          node.children[lane] = PRIMITIVE_TRIANGLE << WIDE_INDEX_BITS | uint(wide_.blocks.size());
          wide_.blocks.push_back({candidate.content.first, candidate.content.count});
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
  Content content_of(BvhChild const& child) const {
    if (child.count == 0) return contents_[child.first];
    Content content{child.first, child.count, true};
    for (uint i = 0; i < child.count; ++i) {
      if (bvh_.references[child.first + i].kind != PRIMITIVE_TRIANGLE) content.only_triangles = false;
    }
    return content;
  }

  static bool can_open(Candidate const& candidate) {
    return !candidate.content.is_block() && candidate.content.count > 1;
  }

  /// The children of the wide node that begins at a binary node.
  Candidates gather(uint binary) const {
    Candidates children;
    for (BvhChild const& child : bvh_.nodes[binary].children) {
      if (!is_absent(child)) children.push_back({child, content_of(child)});
    }
    while (children.size() < WIDE_CHILDREN) {
      std::size_t best = children.size();
      for (std::size_t i = 0; i < children.size(); ++i) {
        if (!can_open(children[i])) continue;
        if (best == children.size() || half_area(children[i].child) > half_area(children[best].child)) best = i;
      }
      if (best == children.size()) break;
      auto const& [left, right] = bvh_.nodes[children[best].child.first].children;  // only a root has absent ones
      children.replace(best, {left, content_of(left)}, {right, content_of(right)});
    }
    return children;
  }

  Bvh const& bvh_;
  std::vector<Content> contents_;
  WideBvh wide_;
};

}  // namespace

WideBvh collapse(Bvh const& bvh) { return Collapser(bvh).run(); }

namespace {

void fill_block(WideBvh::Block const& block, std::span<device::PrimitiveReference const> references,
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

void fill_blocks(std::span<WideBvh::Block const> blocks, std::span<device::PrimitiveReference const> references,
                 std::span<device::TrianglePrimitive const> triangles, std::span<device::TriangleBlock> filled,
                 std::span<device::PrimitiveTag> tags) {
  constexpr std::size_t part_size = 1 << 14;
  if (blocks.size() > part_size) {
    std::size_t const half = blocks.size() / 2;
    auto rest = std::async(std::launch::async, [&] {
      fill_blocks(blocks.subspan(half), references, triangles, filled.subspan(half), tags.subspan(half * BLOCK_LANES));
    });
    fill_blocks(blocks.first(half), references, triangles, filled, tags);
    return;
  }
  for (std::size_t b = 0; b < blocks.size(); ++b) {
    fill_block(blocks[b], references, triangles, filled[b], &tags[b * BLOCK_LANES]);
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

}  // namespace lichtraum
