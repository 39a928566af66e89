#pragma once

#include <optional>

#include "lichtraum/api.hpp"
#include "lichtraum/renderer.hpp"

namespace LICHTRAUM_API lichtraum {

/// How much noise is left in the means of `samples` samples, by what changed since they were those of the first
/// `earlier_samples`: the square root of the relative mean square error, which
/// divides the square of each value's error by the square of the value, plus 0.01 (Rousselle, Knaus and Zwicker,
/// "Adaptive Sampling and Reconstruction using Greedy Error Minimization", SIGGRAPH Asia 2011). 0.05 looks quiet at a
/// first glance. Exact on average for independent samples; the even ones of paths on a device leave rather less noise
/// than is told. Throws std::invalid_argument unless 0 < earlier_samples < samples, and for other numbers of values.
double noise_since(std::vector<float> const& earlier, int earlier_samples, std::vector<float> const& values,
                   int samples);

struct NoiseLimitedResult {
  RenderResult render;
  std::optional<double> noise;  ///< as estimated last, see noise_since; nothing where there was nothing to compare
};

/// Renderer::render, but once the noise of radiance, and of a ground's shadows in alpha, is estimated to be at most
/// `limit`, no more of the request's samples are taken. Looks at two blocks of samples at least; how many are taken is
/// the same on every machine. What the progress tells counts the samples that will probably be taken; it is 0 until
/// that is known. Throws std::invalid_argument for a limit that is not positive, and for a request with a range of
/// samples, with a grid of them, or without radiance; else as Renderer::render.
NoiseLimitedResult render_to_noise(Renderer& renderer, RenderRequest request, double limit, Film& film,
                                   ProgressFunction const& progress = {});

}  // namespace lichtraum
