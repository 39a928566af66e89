#pragma once

#include "lichtraum/renderer.hpp"
#include "reference/scene.hpp"
#include "reference/surfaces.hpp"

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

  ReferenceScene scene_;
  ReferenceSurfaces surfaces_;
  RenderRequest const& request_;
  Background background_;
  SampleRange samples_;
  Film& film_;
};

}  // namespace lichtraum
