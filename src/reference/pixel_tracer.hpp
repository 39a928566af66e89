#pragma once

#include "lichtraum/renderer.hpp"
#include "reference/path_integrator.hpp"

namespace lichtraum {

/// What is traced of a pixel at once: samples of one block. From any number of threads.
class PixelTracer {
 public:
  /// All must outlive it.
  PixelTracer(ReferenceScene const& scene, ReferenceNumbers const& numbers, RenderRequest const& request,
              SampleRange const& samples, Film& film);

  /// Adds a pixel of the picture to the film, and its rays to `counts`.
  void trace(int x, int y, RayCounts& counts) const;

 private:
  class Pixel;
  void trace_center(int x, int y, Pixel& pixel, RayCounts& counts) const;
  void trace_samples(int x, int y, Pixel& pixel, RayCounts& counts) const;
  PathSample whitted_sample(int y, Ray const& ray, RayCounts& counts) const;
  PathSample path_sample(int x, int y, int index, Ray const& ray, RayCounts& counts) const;
  /// What the camera's rays through a row of pixels see where they hit nothing.
  Rgb background_at(int y) const;

  ReferenceScene scene_;
  ReferenceEnvironment environment_;
  ReferenceGround ground_;
  ReferenceSurfaces surfaces_;
  RenderRequest const& request_;
  Background background_;
  SampleRange samples_;
  Film& film_;
};

}  // namespace lichtraum
