#include "accel/sampled_splits.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <utility>

#include "accel/bins.hpp"
#include "accel/half_area.hpp"
#include "core/big_vector.hpp"
#include "core/parallel_ranges.hpp"

namespace lichtraum {
namespace {

/// So many are looked at, which takes a few milliseconds of one thread,
constexpr std::size_t sample_size = 1 << 15;
/// and those that have more than this share of the surface of all: a split that does not see them leaves them among
/// many small ones, and rays enter what is around both (a fourth more nodes in a kitchen).
constexpr float large_share = 1.f / (1 << 14);
/// Fewer tell too little.
constexpr std::size_t min_sample = 64;
/// Leaves most of BVH_MAX_DEPTH to what is in the cells.
constexpr std::size_t max_depth = 24;
/// Primitives are taken and sorted in chunks of this size, so that their order does not depend on the number of
/// threads.
constexpr std::size_t chunk_size = 1 << 14;

std::size_t chunks_of(std::size_t primitives) { return (primitives + chunk_size - 1) / chunk_size; }

/// work(number, begin, end) for each chunk, on every core.
template <class Work>
void for_chunks(std::size_t primitives, Work const& work) {
  for_parallel_ranges(chunks_of(primitives), 1, [&](std::size_t first, std::size_t last) {
    for (std::size_t chunk = first; chunk < last; ++chunk) {
      work(chunk, chunk * chunk_size, std::min((chunk + 1) * chunk_size, primitives));
    }
  });
}

/// In memory, as an axis that is not known beforehand is looked at.
std::array<float, 4> center_of(BuildPrimitive const& primitive) {
  return std::bit_cast<std::array<float, 4>>(LaneBounds(primitive).center());
}

float half_area_of(LaneBounds const& bounds) {
  Lanes const size = bounds.max - bounds.min;
  return half_area(size[0], size[1], size[2]);
}

std::vector<BuildPrimitive> take_sample(std::span<BuildPrimitive const> primitives, LaneBounds const& all) {
  std::size_t const stride = std::max<std::size_t>(1, primitives.size() / sample_size);
  float const small = large_share * half_area_of(all);
  std::vector<std::vector<BuildPrimitive>> taken(chunks_of(primitives.size()));
  for_chunks(primitives.size(), [&](std::size_t chunk, std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      if (i % stride == 0 || half_area_of(LaneBounds(primitives[i])) > small) taken[chunk].push_back(primitives[i]);
    }
  });
  std::vector<BuildPrimitive> sample;
  for (auto const& of_chunk : taken) sample.insert(sample.end(), of_chunk.begin(), of_chunk.end());
  // Where most are large, no single one matters.
  if (std::size_t const step = sample.size() / sample_size; step > 1) {
    std::size_t size = 0;
    for (std::size_t i = 0; i < sample.size(); i += step) sample[size++] = sample[i];
    sample.resize(size);
  }
  return sample;
}

}  // namespace

SampledSplits::SampledSplits(std::span<BuildPrimitive const> primitives, LaneBounds const& all) {
  auto sample = take_sample(primitives, all);
  divide(sample, 0);
}

void SampledSplits::divide(std::span<BuildPrimitive> sample, std::size_t depth) {
  auto const number = std::uint32_t(nodes_.size());
  nodes_.push_back({.children = {number, number}});
  if (sample.size() < min_sample || depth == max_depth) return;
  LaneBounds centers;
  for (BuildPrimitive const& primitive : sample) centers.add_point(LaneBounds(primitive).center());
  Binning const binning(centers);
  Bins bins;
  bins.add(sample, binning);
  Split const split = bins.best_split();
  if (!std::isfinite(split.cost)) return;
  Node node{std::uint32_t(split.axis), binning.position(split.axis, split.bin), {}};
  auto const right = std::partition(sample.begin(), sample.end(), [&](BuildPrimitive const& primitive) {
    return node.is_left(center_of(primitive));
  });
  if (right == sample.begin() || right == sample.end()) return;  // by rounding
  node.children[0] = number + 1;
  divide({sample.begin(), right}, depth + 1);
  node.children[1] = std::uint32_t(nodes_.size());
  divide({right, sample.end()}, depth + 1);
  nodes_[number] = node;
}

void SampledSplits::find_cells(std::span<BuildPrimitive const> primitives, std::span<std::uint32_t> cells) const {
  // Which side comes next is as good as random: so there is no branch for it, and several go down at once, as each
  // would wait for its own steps.
  constexpr std::size_t batch = 8;
  for (std::size_t begin = 0; begin < primitives.size(); begin += batch) {
    std::size_t const count = std::min(batch, primitives.size() - begin);
    std::array<std::array<float, 4>, batch> centers{};
    for (std::size_t i = 0; i < count; ++i) centers[i] = center_of(primitives[begin + i]);
    std::array<std::uint32_t, batch> at{};
    std::uint32_t moved = 1;
    while (moved != 0) {
      moved = 0;
      for (std::size_t i = 0; i < batch; ++i) {
        Node const& node = nodes_[at[i]];
        std::uint32_t const next = node.children[node.is_left(centers[i]) ? 0 : 1];
        moved |= next ^ at[i];
        at[i] = next;
      }
    }
    std::copy_n(at.begin(), count, cells.begin() + std::ptrdiff_t(begin));
  }
}

std::vector<std::size_t> SampledSplits::sort_into_cells(std::span<BuildPrimitive const> from,
                                                        std::span<BuildPrimitive> to) const {
  BigVector<std::uint32_t> cells(from.size());
  std::vector<std::size_t> places(chunks_of(from.size()) * size());  // by chunk and cell; first how many there are
  for_chunks(from.size(), [&](std::size_t chunk, std::size_t begin, std::size_t end) {
    std::span const found(cells.data() + begin, end - begin);
    find_cells(from.subspan(begin, end - begin), found);
    for (std::uint32_t const cell : found) ++places[chunk * size() + cell];
  });
  std::vector<std::size_t> first;
  std::size_t next = 0;
  for (std::size_t cell = 0; cell < size(); ++cell) {
    first.push_back(next);
    for (std::size_t i = cell; i < places.size(); i += size()) next += std::exchange(places[i], next);
  }
  first.push_back(next);
  for_chunks(from.size(), [&](std::size_t chunk, std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) to[places[chunk * size() + cells[i]]++] = from[i];
  });
  return first;
}

}  // namespace lichtraum
