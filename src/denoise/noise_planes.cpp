#include "denoise/noise_planes.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/parallel_ranges.hpp"
#include "denoise/check_picture.hpp"

namespace lichtraum {
namespace {

constexpr std::size_t rows_per_thread = 64;
/// What divides radiance where a surface reflects less, and where nothing is.
constexpr float least_albedo = 0.1f;

float least_albedo_or(float albedo) { return std::max(finite(albedo), least_albedo); }

float inverse(float depth) { return depth > 0 ? std::min(1 / depth, largest_filtered_light) : 0; }

device::NoiseFilterLayout layout_of(Resolution const& size) {
  constexpr device::uint lanes = NOISE_FILTER_MARGIN;
  auto const width = device::uint(size.width), height = device::uint(size.height);
  // The last group of a row reaches as far to the right as any pixel does.
  device::uint const stride = (width + lanes - 1) / lanes * lanes + NOISE_FILTER_MARGIN;
  return {width, height, stride, NOISE_FILTER_MARGIN + stride * height + NOISE_FILTER_MARGIN};
}

/// Calls work(i, place): each pixel, and where it is in a plane.
template <class Work>
void for_each_pixel(device::NoiseFilterLayout const& layout, Work const& work) {
  for_parallel_ranges(layout.height, rows_per_thread, [&](std::size_t begin, std::size_t end) {
    for (std::size_t y = begin; y < end; ++y) {
      std::size_t const first = device::filter_place(layout, 0, int(y));
      for (std::size_t x = 0; x < layout.width; ++x) work(y * layout.width + x, first + x);
    }
  });
}

}  // namespace

NoisePlanes noise_planes(NoisyPicture const& picture) {
  check_picture(picture);
  NoisePlanes planes;
  planes.layout = layout_of(picture.size);
  std::size_t const plane = planes.layout.plane;
  planes.guides.assign(GUIDE_PLANES * plane, std::numeric_limits<float>::quiet_NaN());
  planes.light.assign(LIGHT_PLANES * plane, 0.0f);
  planes.filtered.assign(LIGHT_PLANES * plane, 0.0f);
  planes.luminance.assign(LUMINANCE_PLANES * plane, 0.0f);
  for_each_pixel(planes.layout, [&](std::size_t i, std::size_t place) {
    for (std::size_t c = 0; c < 3; ++c) {
      float const albedo = picture.albedo.empty() ? 1.0f : picture.albedo[3 * i + c];
      float const normal = picture.normal.empty() ? 0.0f : picture.normal[3 * i + c];
      planes.guides[(GUIDE_ALBEDO + c) * plane + place] = finite(albedo);
      planes.guides[(GUIDE_NORMAL + c) * plane + place] = finite(normal);
      planes.light[(LIGHT_COLOR + c) * plane + place] =
          std::clamp(finite(picture.radiance[3 * i + c]) / least_albedo_or(albedo), -largest_filtered_light,
                     largest_filtered_light);
    }
    planes.guides[GUIDE_INVERSE_DEPTH * plane + place] = picture.depth.empty() ? 0.0f : inverse(picture.depth[i]);
  });
  return planes;
}

std::vector<float> radiance_of(NoisePlanes const& planes, NoisyPicture const& picture) {
  std::vector<float> radiance(picture.radiance.size());
  for_each_pixel(planes.layout, [&](std::size_t i, std::size_t place) {
    for (std::size_t c = 0; c < 3; ++c) {
      float const albedo = picture.albedo.empty() ? 1.0f : picture.albedo[3 * i + c];
      radiance[3 * i + c] = planes.light[(LIGHT_COLOR + c) * planes.layout.plane + place] * least_albedo_or(albedo);
    }
  });
  return radiance;
}

}  // namespace lichtraum
