#include "lichtraum/noise_limit.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "core/square.hpp"

namespace lichtraum {
namespace {

void check(RenderRequest const& request, double limit) {
  bool const is_random = request.sampling.pattern == Sampling::Pattern::seeded;
  if (limit > 0 && !request.samples && is_random && request.planes.has(FilmPlane::radiance)) return;
  throw std::invalid_argument("a limit of noise is positive, and for radiance by all of a picture's random samples");
}

/// What has noise: radiance, and where shadows are in it, alpha.
std::vector<float> noisy_values(Film const& film, bool has_shadows_in_alpha) {
  std::vector<float> values = film.values(FilmPlane::radiance);
  if (!has_shadows_in_alpha) return values;
  std::vector<float> const alpha = film.values(FilmPlane::alpha);
  values.insert(values.end(), alpha.begin(), alpha.end());
  return values;
}

/// How many samples to have next: as many as will probably do, in whole blocks, but at most twice as many.
int next_count(int count, std::optional<double> noise, double limit) {
  double const factor = noise ? std::clamp(square(*noise / limit), 1.0, 2.0) : 2;
  int const blocks = int(std::ceil(factor * count / Film::block_size));
  return std::max(blocks * Film::block_size, count + Film::block_size);
}

/// How many samples it will probably take.
double expected_count(int count, std::optional<double> noise, double limit, int most) {
  if (!noise) return most;
  return std::clamp(count * square(*noise / limit), double(count), double(most));
}

}  // namespace

double noise_since(std::vector<float> const& earlier, int earlier_samples, std::vector<float> const& values,
                   int count) {
  if (earlier.size() != values.size() || earlier_samples <= 0 || earlier_samples >= count) {
    throw std::invalid_argument("noise is estimated from what more samples change");
  }
  double sum = 0;
  for (std::size_t i = 0; i < values.size(); ++i) {
    double const value = values[i], change = value - earlier[i];
    sum += change * change / (value * value + 0.01);
  }
  // Of M independent samples and N - M more, the mean of all differs from that of the first by (N - M) / M times as
  // much, in squares, as it is wrong itself.
  double const error = double(earlier_samples) / (count - earlier_samples);
  return std::sqrt(sum / double(values.size()) * error);
}

NoiseLimitedResult render_to_noise(Renderer& renderer, RenderRequest request, double limit, Film& film,
                                   ProgressFunction const& progress) {
  check(request, limit);
  NoiseLimitedResult result;
  int const most = request.sampling.count;
  std::vector<float> earlier;
  int earlier_samples = 0;
  double seconds_before = 0;
  for (int end = std::min(Film::block_size, most);;) {
    request.samples = SampleRange{0, end};
    double const expected = std::max(double(end), expected_count(earlier_samples, result.noise, limit, most));
    RenderStatistics& total = result.render.statistics;
    double seconds = 0;
    RenderResult const part = renderer.render(request, film, [&](RenderProgress const& now) {
      seconds = now.elapsed_seconds;
      double const samples = earlier_samples + now.fraction * (end - earlier_samples);
      double const fraction = result.noise ? samples / expected : 0;
      return !progress || progress({fraction, total.rays.total() + now.rays, seconds_before + now.elapsed_seconds,
                                    now.is_compiling});
    });
    seconds_before += seconds;
    total.rays += part.statistics.rays;
    total.program_ms += part.statistics.program_ms;
    total.trace_ms += part.statistics.trace_ms;
    result.render.complete = part.complete;
    if (!part.complete) return result;
    std::vector<float> values = noisy_values(film, has_shadows_in_alpha(request));
    if (earlier_samples > 0) result.noise = noise_since(earlier, earlier_samples, values, end);
    if (end == most || (result.noise && *result.noise <= limit)) return result;
    earlier = std::move(values);
    earlier_samples = end;
    end = std::min(most, next_count(end, result.noise, limit));
  }
}

}  // namespace lichtraum
