#include "compile/environment_table.hpp"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <limits>
#include <numbers>
#include <span>
#include <utility>

#include "compile/alias_table.hpp"
#include "core/elementary.hpp"
#include "core/luminance.hpp"
#include "core/parallel_ranges.hpp"
#include "lichtraum/orbit.hpp"

namespace lichtraum {
namespace {

using std::numbers::pi;

/// What of the sphere a texel of the row covers.
double solid_angle(EnvironmentMap const& map, std::size_t row) {
  auto const edge = [&](std::size_t number) { return cos_of(pi * double(number) / map.height); };
  return 2 * pi / map.width * (edge(row) - edge(row + 1));
}

/// The mean luminance over each texel, as the kernels interpolate it: above 0 wherever anything arrives.
class InterpolatedLuminance {
 public:
  explicit InterpolatedLuminance(EnvironmentMap const& map) : map_(map), width_(std::size_t(map.width)) {}

  void row(std::size_t number, std::span<double> out) {
    std::size_t const last = std::size_t(map_.height) - 1;
    auto const& middle = along_row(number);
    auto const& above = number > 0 ? along_row(number - 1) : pole(middle);
    auto const& below = number < last ? along_row(number + 1) : pole(middle);
    // A pole is half as far away as the next row's middle.
    double const above_share = number > 0 ? 0.125 : 0.25, below_share = number < last ? 0.125 : 0.25;
    for (std::size_t i = 0; i < width_; ++i) {
      out[i] = above_share * above[i] + (1 - above_share - below_share) * middle[i] + below_share * below[i];
    }
  }

 private:
  /// Interpolated along the row only. The last three stay.
  std::vector<double> const& along_row(std::size_t number) {
    Row& row = rows_[number % 3];
    if (row.number == number) return row.values;
    row.number = number;
    row.values.resize(width_);
    plain_.resize(width_);
    float const* const texels = &map_.radiance[3 * width_ * number];
    for (std::size_t i = 0; i < width_; ++i) plain_[i] = luminance(texels + 3 * i);
    for (std::size_t i = 0; i < width_; ++i) {
      double const left = plain_[i == 0 ? width_ - 1 : i - 1], right = plain_[i + 1 == width_ ? 0 : i + 1];
      row.values[i] = 0.75 * plain_[i] + 0.125 * (left + right);
    }
    return row.values;
  }
  std::vector<double> const& pole(std::vector<double> const& row) {
    double sum = 0;
    for (double const value : row) sum += value;
    pole_.assign(row.size(), sum / double(row.size()));
    return pole_;
  }

  struct Row {
    std::size_t number = std::numeric_limits<std::size_t>::max();
    std::vector<double> values;
  };
  EnvironmentMap const& map_;
  std::size_t width_;
  Row rows_[3];
  std::vector<double> plain_, pole_;
};

std::array<float, 3> mean_of_row(EnvironmentMap const& map, std::size_t row) {
  double sum[3] = {};
  auto const width = std::size_t(map.width);
  for (std::size_t i = 0; i < 3 * width; ++i) sum[i % 3] += double(map.radiance[3 * width * row + i]);
  return {float(sum[0] / map.width), float(sum[1] / map.width), float(sum[2] / map.width)};
}

/// See EnvironmentTable::on_level: by the kernels' interpolation between rows, which is linear along v.
Rgb irradiance_on_level(EnvironmentMap const& map) {
  std::vector<Rgb> means;
  for (int row = 0; row <= map.height / 2 + 1 && row < map.height; ++row) {
    auto const mean = mean_of_row(map, std::size_t(row));
    means.emplace_back(mean[0], mean[1], mean[2]);
  }
  constexpr int steps_a_row = 32;
  int const steps = std::max(map.height * steps_a_row / 2, 1);  // from the zenith to the horizon
  Rgb sum(0);
  for (int i = 0; i < steps; ++i) {
    double const share = (i + 0.5) / steps;
    double const row = std::max(0.5 * share * map.height - 0.5, 0.0);  // above the first one, nothing changes
    auto const upper = std::min(std::size_t(row), means.size() - 1), lower = std::min(upper + 1, means.size() - 1);
    double const above = cos_of(0.5 * pi * i / steps), below = cos_of(0.5 * pi * (i + 1) / steps);
    sum += glm::mix(means[upper], means[lower], row - double(upper)) * (above * above - below * below);
  }
  return sum;
}

/// Calls work(row) for all rows, on every core.
template <class Work>
void for_rows(EnvironmentMap const& map, Work const& make_work) {
  std::size_t const rows_a_thread = 1 + (std::size_t(1) << 14) / std::size_t(map.width);
  for_parallel_ranges(std::size_t(map.height), rows_a_thread, [&](std::size_t begin, std::size_t end) {
    auto work = make_work();
    for (std::size_t row = begin; row < end; ++row) work(row);
  });
}

float to_float(double value) { return float(std::min(value, double(std::numeric_limits<float>::max()))); }

}  // namespace

EnvironmentTable make_environment_table(std::shared_ptr<EnvironmentMap const> shared_map, bool is_compensated) {
  EnvironmentTable table;
  table.map = std::move(shared_map);
  EnvironmentMap const& map = *table.map;
  auto const width = std::size_t(map.width), height = std::size_t(map.height), last = height - 1;
  table.environment_texels.resize(3 * width * height);
  table.environment_rows.resize(height);
  table.environment_columns.resize(width * height);
  table.environment_densities.resize(width * height);
  std::ranges::copy(mean_of_row(map, 0), table.poles.begin());
  std::ranges::copy(mean_of_row(map, last), table.poles.begin() + 3);
  table.on_level = irradiance_on_level(map);

  // At first the densities are mean luminances, then what of these is above the threshold.
  auto const densities_of = [&](std::size_t row) {
    return std::span(table.environment_densities).subspan(width * row, width);
  };
  std::vector<double> row_means(height);
  for_rows(map, [&] {
    return [&, light = InterpolatedLuminance(map), means = std::vector<double>(width)](std::size_t row) mutable {
      std::copy_n(&map.radiance[3 * width * row], 3 * width, &table.environment_texels[3 * width * row]);
      light.row(row, means);
      for (double const mean : means) row_means[row] += mean / map.width;
      std::ranges::transform(means, densities_of(row).begin(), to_float);
    };
  });
  std::vector<double> row_solid_angles(height);
  for (std::size_t row = 0; row < height; ++row) {
    row_solid_angles[row] = map.width * solid_angle(map, row);
    table.mean_luminance += row_means[row] * row_solid_angles[row] / (4 * pi);
  }

  // What is above the mean by a rounding only is none.
  double const threshold = is_compensated ? table.mean_luminance * (1 + 1e-6) : 0;
  std::vector<double> row_weights(height);
  for_rows(map, [&] {
    return [&, weights = std::vector<double>(width), aliases = AliasTableMaker()](std::size_t row) mutable {
      auto const densities = densities_of(row);
      double sum = 0;
      for (std::size_t i = 0; i < width; ++i) {
        weights[i] = std::max(double(densities[i]) - threshold, 0.0);
        sum += weights[i];
      }
      row_weights[row] = sum / map.width * row_solid_angles[row];
      aliases.fill(weights, std::span(table.environment_columns).subspan(width * row, width));
      std::ranges::transform(weights, densities.begin(), to_float);
    };
  });
  double sum = 0;
  for (double const weight : row_weights) sum += weight;
  table.sampled_mean_luminance = sum / (4 * pi);
  AliasTableMaker().fill(row_weights, table.environment_rows);
  double const scale = sum > 0 ? 1 / sum : 0;
  for_parallel_ranges(width * height, 1 << 16, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      table.environment_densities[i] = float(double(table.environment_densities[i]) * scale);
    }
  });
  return table;
}

void set_environment(device::SceneConstants& constants, EnvironmentTable const& table, EnvironmentLight const& light,
                     Vec3 const& up) {
  constants.environment_width = device::uint(table.map->width);
  constants.environment_height = device::uint(table.map->height);
  Mat3 const world_from_map(orbit_rotation({light.rotation_degrees, 0}, up).matrix());
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column) {
      constants.map_from_world[row][column] = float(world_from_map[row][column]);  // the transpose: glm's are columns
    }
  }
  constants.environment_brightness = to_float(light.brightness);
  constants.environment_power = to_float(4 * pi * light.brightness * table.mean_luminance);
  constants.environment_sampled_power = to_float(4 * pi * light.brightness * table.sampled_mean_luminance);
  std::ranges::copy(table.poles, constants.environment_poles);
  for (int c = 0; c < 3; ++c) constants.environment_on_level[c] = to_float(light.brightness * table.on_level[c]);
}

}  // namespace lichtraum
