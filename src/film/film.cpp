#include "lichtraum/film.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "core/huge_pages.hpp"

namespace lichtraum {
namespace {

void allocate(std::vector<float>& values, std::size_t count) {
  reserve_in_huge_pages(values, count);
  values.assign(count, 0.0f);
}

void add(std::vector<float>& sums, std::vector<float> const& block) {
  if (sums.empty()) sums.assign(block.size(), 0.0f);
  for (std::size_t i = 0; i < block.size(); ++i) sums[i] += block[i];
}

std::invalid_argument without(FilmPlane plane) {
  return std::invalid_argument(fmt::format("the film has no plane \"{}\"", info_of(plane).name));
}

}  // namespace

std::span<PlaneInfo const> plane_infos() {
  static std::array<PlaneInfo, plane_count> const infos{{
      {"radiance", PlaneRule::mean, false, {"R", "G", "B"}},
      {"alpha", PlaneRule::mean, false, {"A"}},
      {"albedo", PlaneRule::mean, false, {"albedo.R", "albedo.G", "albedo.B"}},
      {"normal", PlaneRule::mean, false, {"N.X", "N.Y", "N.Z"}},
      {"depth", PlaneRule::center, false, {"Z"}},
      {"position", PlaneRule::center, false, {"P.X", "P.Y", "P.Z"}},
      {"object", PlaneRule::center, true, {"object"}},
      {"instance", PlaneRule::center, true, {"instance"}},
      {"material", PlaneRule::center, true, {"material"}},
  }};
  return infos;
}

bool PlaneSet::has(PlaneRule rule) const {
  auto const planes = list();
  return std::any_of(planes.begin(), planes.end(), [&](FilmPlane plane) { return info_of(plane).rule == rule; });
}

std::vector<FilmPlane> PlaneSet::list() const {
  std::vector<FilmPlane> planes;
  for (std::size_t i = 0; i < plane_count; ++i) {
    if (has(FilmPlane(i))) planes.push_back(FilmPlane(i));
  }
  return planes;
}

Film::Film(Region const& region, PlaneSet const& planes, int first_sample)
    : region_(region), planes_(planes), samples_{first_sample, first_sample} {
  if (region.width < 0 || region.height < 0) throw std::invalid_argument("a film's sides are not negative");
  if (first_sample % block_size != 0) throw std::invalid_argument("a film begins where a block of samples does");
  for (FilmPlane const plane : planes.list()) {
    PlaneInfo const& info = info_of(plane);
    if (info.rule == PlaneRule::center && first_sample > 0) continue;
    if (info.is_number) {
      numbers_[std::size_t(plane)].assign(value_count(plane), 0);
    } else {
      allocate(sums_[std::size_t(plane)].open, value_count(plane));
    }
  }
}

std::vector<float> Film::sums_of_all(Sums sums) {
  for (auto const& block : sums.blocks) add(sums.closed, block);
  add(sums.closed, sums.open);
  return std::move(sums.closed);
}

std::size_t Film::value_count(FilmPlane plane) const {
  return info_of(plane).channels.size() * std::size_t(region_.width) * std::size_t(region_.height);
}

std::size_t Film::pixel_index(int x, int y) const {
  return std::size_t(y) * std::size_t(region_.width) + std::size_t(x);
}

std::span<float> Film::floats(FilmPlane plane) { return sums_[std::size_t(plane)].open; }
std::span<std::uint32_t> Film::numbers(FilmPlane plane) { return numbers_[std::size_t(plane)]; }
std::span<std::uint32_t const> Film::numbers(FilmPlane plane) const { return numbers_[std::size_t(plane)]; }

float Film::value(FilmPlane plane, int x, int y, int channel) const {
  PlaneInfo const& info = info_of(plane);
  if (sums_[std::size_t(plane)].open.empty()) throw without(plane);
  std::size_t const i = pixel_index(x, y) * info.channels.size() + std::size_t(channel);
  Sums const& sums = sums_[std::size_t(plane)];
  if (info.rule == PlaneRule::center) return sums.open[i];
  float sum = sums.closed.empty() ? 0.0f : sums.closed[i];
  for (auto const& block : sums.blocks) sum += block[i];
  return (sum + sums.open[i]) / float(samples_.count());
}

std::uint32_t Film::number(FilmPlane plane, int x, int y) const {
  if (numbers_[std::size_t(plane)].empty()) throw without(plane);
  return numbers_[std::size_t(plane)][pixel_index(x, y)];
}

std::vector<float> Film::values(FilmPlane plane) const {
  Sums const& sums = sums_[std::size_t(plane)];
  std::vector<float> values = sums.closed.empty() && sums.blocks.empty() ? sums.open : sums_of_all(sums);
  if (info_of(plane).rule == PlaneRule::mean) {
    for (float& value : values) value /= float(samples_.count());
  }
  return values;
}

void Film::set_end(int end) { samples_.end = end; }

void Film::drop_last_block() {
  for (FilmPlane const plane : planes_.list()) {
    if (info_of(plane).rule != PlaneRule::mean) continue;
    std::vector<float>& sums = sums_[std::size_t(plane)].open;
    std::fill(sums.begin(), sums.end(), 0.0f);
  }
  samples_.end -= samples_.end % block_size;
}

void Film::close_block() {
  for (FilmPlane const plane : planes_.list()) {
    if (info_of(plane).rule != PlaneRule::mean) continue;
    Sums& sums = sums_[std::size_t(plane)];
    if (samples_.first == 0) {
      add(sums.closed, sums.open);
    } else {
      sums.blocks.push_back(sums.open);
    }
    std::fill(sums.open.begin(), sums.open.end(), 0.0f);
  }
}

std::vector<float> Film::take_sums(FilmPlane plane) {
  Sums sums = std::exchange(sums_[std::size_t(plane)], {});
  if (sums.closed.empty() && sums.blocks.empty()) return std::move(sums.open);
  return sums_of_all(std::move(sums));
}

void Film::keep(PlaneSet const& planes) {
  for (FilmPlane const plane : planes_.list()) {
    if (planes.has(plane)) continue;
    sums_[std::size_t(plane)] = {};
    numbers_[std::size_t(plane)] = {};
  }
  planes_ = planes;
}

void Film::merge(Film const& next) {
  if (next.region_ != region_ || next.planes_ != planes_) {
    throw std::invalid_argument("only films of the same region and planes merge");
  }
  if (next.samples_.first != samples_.end || samples_.end % block_size != 0) {
    throw std::invalid_argument("a film that is merged begins where the other ends, at the border of a block");
  }
  if (!is_empty()) close_block();
  for (FilmPlane const plane : planes_.list()) {
    if (info_of(plane).rule != PlaneRule::mean) continue;
    Sums& sums = sums_[std::size_t(plane)];
    Sums const& more = next.sums_[std::size_t(plane)];
    for (auto const& block : more.blocks) {
      samples_.first == 0 ? add(sums.closed, block) : sums.blocks.push_back(block);
    }
    sums.open = more.open;
  }
  samples_.end = next.samples_.end;
}

Film Film::of_samples(Region const& region, PlaneSet const& planes, SampleRange const& samples) {
  Film film(region, planes, samples.first);
  film.samples_ = samples;
  int const closed_blocks = std::max(0, samples.count() - 1) / block_size;
  for (FilmPlane const plane : planes.list()) {
    if (info_of(plane).rule != PlaneRule::mean || closed_blocks == 0) continue;
    Sums& sums = film.sums_[std::size_t(plane)];
    if (samples.first == 0) {
      allocate(sums.closed, film.value_count(plane));
    } else {
      sums.blocks.assign(std::size_t(closed_blocks), std::vector<float>(film.value_count(plane)));
    }
  }
  return film;
}

std::vector<std::span<std::byte>> Film::arrays() {
  std::vector<std::span<std::byte>> all;
  auto const add_array = [&](auto& values) {
    if (!values.empty()) all.push_back(std::as_writable_bytes(std::span(values)));
  };
  for (FilmPlane const plane : planes_.list()) {
    Sums& sums = sums_[std::size_t(plane)];
    add_array(sums.closed);
    for (auto& block : sums.blocks) add_array(block);
    add_array(sums.open);
    add_array(numbers_[std::size_t(plane)]);
  }
  return all;
}

void Film::place(Film part) {
  auto const to = arrays(), from = part.arrays();
  Region const& small = part.region_;
  auto const lies_within = [](int at, int size, int whole_at, int whole_size) {
    return at >= whole_at && at - whole_at <= whole_size - size;
  };
  if (part.planes_ != planes_ || part.samples_ != samples_ || to.size() != from.size() ||
      !lies_within(small.x, small.width, region_.x, region_.width) ||
      !lies_within(small.y, small.height, region_.y, region_.height)) {
    throw std::invalid_argument("a part of a film has its planes and samples, and lies within it");
  }
  for (std::size_t i = 0; i < to.size(); ++i) {
    std::size_t const pixel_bytes = to[i].size() / (std::size_t(region_.width) * std::size_t(region_.height));
    std::size_t const row_bytes = pixel_bytes * std::size_t(small.width);
    for (int y = 0; y < small.height; ++y) {
      std::size_t const target = pixel_index(small.x - region_.x, small.y - region_.y + y) * pixel_bytes;
      std::copy_n(from[i].begin() + std::ptrdiff_t(row_bytes * std::size_t(y)), row_bytes,
                  to[i].begin() + std::ptrdiff_t(target));
    }
  }
}

}  // namespace lichtraum
