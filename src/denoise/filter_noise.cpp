#include <utility>

#include "core/parallel_ranges.hpp"
#include "denoise/noise_planes.hpp"

namespace lichtraum {
namespace {

/// Calls pass(x, y) for every pixel.
template <class Pass>
void run_pass(device::NoiseFilterLayout const& layout, Pass const& pass) {
  constexpr std::size_t rows_per_thread = 8;
  for_parallel_ranges(layout.height, rows_per_thread, [&](std::size_t begin, std::size_t end) {
    for (std::size_t y = begin; y < end; ++y) {
      for (int x = 0; x < int(layout.width); ++x) pass(x, int(y));
    }
  });
}

}  // namespace

std::vector<float> filter_noise(NoisyPicture const& picture) {
  NoisePlanes planes = noise_planes(picture);
  auto const& layout = planes.layout;
  float const* const guides = planes.guides.data();
  float* const luminance = planes.luminance.data();
  run_pass(layout, [&](int x, int y) { device::estimate_variance(layout, x, y, guides, planes.light.data()); });
  for (int level = 0; level < int(NOISE_FILTER_LEVELS); ++level) {
    int const step = 1 << level;
    float const* const light = planes.light.data();
    run_pass(layout, [&](int x, int y) { device::smooth_luminance(layout, step, x, y, guides, light, luminance); });
    run_pass(layout, [&](int x, int y) {
      device::filter_level(layout, step, x, y, guides, light, luminance, planes.filtered.data());
    });
    planes.light.swap(planes.filtered);
  }
  return radiance_of(planes, picture);
}

}  // namespace lichtraum
