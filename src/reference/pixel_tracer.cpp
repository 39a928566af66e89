#include "reference/pixel_tracer.hpp"

#include <cmath>
#include <numbers>

#include "core/elementary.hpp"
#include "core/float3.hpp"
#include "reference/integrator.hpp"
#include "reference/path_integrator.hpp"
#include "reference/scattering_point.hpp"
#include "shared/sampling.h"
#include "shared/sobol.h"

namespace lichtraum {
namespace {

/// Where sample `index` of a pixel lies, from the pixel's top left corner.
glm::dvec2 sample_offset(RenderRequest const& request, int x, int y, int index) {
  if (request.sampling.pattern == Sampling::Pattern::grid) {
    auto const side = static_cast<int>(std::lround(std::sqrt(double(request.sampling.count))));
    return glm::dvec2(index % side + 0.5, index / side + 0.5) / double(side);
  }
  if (request.sampling.count == 1) return glm::dvec2(0.5);
  auto const offset = device::seeded_pixel_offset(
      static_cast<device::uint>(x), static_cast<device::uint>(y), static_cast<device::uint>(index),
      static_cast<device::uint>(request.seed), static_cast<device::uint>(request.seed >> 32));
  return {offset.x, offset.y};
}

/// Where the ray of a sample goes through the lens, in its unit disc.
glm::dvec2 lens_point(RenderRequest const& request, int x, int y, int index) {
  if (request.camera.lens().aperture == 0) return glm::dvec2(0);
  auto const random = device::sobol_point(device::uint(x), device::uint(y), LENS_DIMENSION, device::uint(index),
                                          device::uint(request.seed), device::uint(request.seed >> 32));
  double const angle = 2 * std::numbers::pi * random.y;
  return std::sqrt(double(random.x)) * glm::dvec2(cos_of(angle), sin_of(angle));
}

}  // namespace

/// A pixel of a plane of the film: where its values are.
class PixelTracer::Pixel {
 public:
  Pixel(Film& film, std::size_t pixel) : film_(film), pixel_(pixel) {}
  void add(FilmPlane plane, Vec3 const& value) {
    std::size_t const channels = info_of(plane).channels.size();
    for (std::size_t c = 0; c < channels && film_.planes().has(plane); ++c) {
      film_.floats(plane)[channels * pixel_ + c] += float(value[int(c)]);
    }
  }
  void set(FilmPlane plane, std::uint32_t number) {
    if (film_.planes().has(plane)) film_.numbers(plane)[pixel_] = number;
  }

 private:
  Film& film_;
  std::size_t pixel_;
};

PixelTracer::PixelTracer(ReferenceScene const& scene, ReferenceNumbers const& numbers, RenderRequest const& request,
                         SampleRange const& samples, Film& film)
    : scene_(scene),
      surfaces_(scene, numbers, request.planes),
      request_(request),
      background_(request.background.value_or(scene.background)),
      samples_(samples),
      film_(film) {
  if (scene.environment) environment_ = ReferenceEnvironment(*scene.environment, scene.up);
  if (request.integrator == Integrator::path) {
    for (auto const& [material, number] : numbers.materials) {
      if (material) check_is_known(*material);
    }
    ground_ = ReferenceGround(scene_, environment_, request.ground);
  }
  scene_.background = background_.mean();
}

void PixelTracer::trace(int x, int y, RayCounts& counts) const {
  Region const& region = film_.region();
  Pixel pixel(film_, std::size_t(y - region.y) * std::size_t(region.width) + std::size_t(x - region.x));
  if (samples_.first == 0 && film_.planes().has(PlaneRule::center)) trace_center(x, y, pixel, counts);
  if (film_.planes().has(PlaneRule::mean)) trace_samples(x, y, pixel, counts);
}

void PixelTracer::trace_center(int x, int y, Pixel& pixel, RayCounts& counts) const {
  auto const center =
      surfaces_.center(request_.camera.generate_ray(x + 0.5, y + 0.5, request_.resolution), request_.integrator);
  ++counts.camera;
  counts.camera_hits += std::isfinite(center.depth);
  pixel.add(FilmPlane::depth, Vec3(center.depth));
  pixel.add(FilmPlane::position, center.position);
  pixel.set(FilmPlane::object, center.object);
  pixel.set(FilmPlane::instance, center.instance);
  pixel.set(FilmPlane::material, center.material);
}

PathSample PixelTracer::whitted_sample(int y, Ray const& ray, RayCounts& counts) const {
  PlaneSet const& planes = film_.planes();
  PathSample sample;
  if (planes.has(FilmPlane::alpha) || planes.has(FilmPlane::albedo) || planes.has(FilmPlane::normal)) {
    sample.surface = surfaces_.sample(ray);
  }
  if (planes.has(FilmPlane::radiance)) {
    sample.radiance = trace_radiance(scene_, ray, background_at(y), request_.max_depth, counts);
  } else {
    ++counts.camera;
    counts.camera_hits += sample.surface.alpha > 0;
  }
  return sample;
}

PathSample PixelTracer::path_sample(int x, int y, int index, Ray const& ray, RayCounts& counts) const {
  bool const sees_environment = environment_ && background_.kind == Background::Kind::environment;
  Rgb const background = sees_environment ? environment_.radiance(ray.direction) : background_at(y);
  ReferenceRandom random(x, y, index, request_.seed);
  return trace_path(scene_, environment_, ground_, ray, background, request_, random, counts);
}

Rgb PixelTracer::background_at(int y) const {
  double const share_of_height = (y + 0.5) / request_.resolution.height;
  return background_.top + share_of_height * (background_.bottom - background_.top);
}

void PixelTracer::trace_samples(int x, int y, Pixel& pixel, RayCounts& counts) const {
  PlaneSet const& planes = film_.planes();
  for (int i = samples_.first; i < samples_.end; ++i) {
    auto const offset = sample_offset(request_, x, y, i);
    auto const lens = lens_point(request_, x, y, i);
    Ray const ray = request_.camera.generate_ray(x + offset.x, y + offset.y, request_.resolution, lens.x, lens.y);
    auto const [radiance, surface] =
        request_.integrator == Integrator::path ? path_sample(x, y, i, ray, counts) : whitted_sample(y, ray, counts);
    pixel.add(FilmPlane::alpha, Vec3(surface.alpha));
    pixel.add(FilmPlane::albedo, surface.albedo);
    pixel.add(FilmPlane::normal, surface.normal);
    // With alpha, what is seen through the picture is somebody else's.
    if (planes.has(FilmPlane::alpha) && surface.alpha == 0) continue;
    if (is_finite(to_float3(radiance))) {  // as the film keeps it
      pixel.add(FilmPlane::radiance, radiance);
    } else {
      ++counts.not_finite;
    }
  }
}

}  // namespace lichtraum
