#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "lichtraum/denoise.hpp"
#include "lichtraum/noise_limit.hpp"
#include "lichtraum/renderer.hpp"

namespace lichtraum::app {

// The steps from a request to a picture, for whoever draws: the program's sequences and the Python package.

/// With a limit of noise (see Job::noise) until that is reached, else all samples. Throws as Renderer::render.
NoiseLimitedResult trace_picture(Renderer& renderer, RenderRequest const& request, std::optional<double> noise_limit,
                                 Film& film, ProgressFunction const& progress);

/// The film of `request` after `denoiser`, which must not be told `automatic` or `off`.
Film without_noise(Denoiser& denoiser, Film const& film, Denoising denoising, RenderRequest const& request);

/// What people see of a film: radiance, developed, else its first plane.
Image shown_picture(Renderer& renderer, Film film, Development const& development);

/// "after 64 samples the noise is 0.2, not 0.1", where a picture has more than its limit; else empty.
std::string noise_left(Film const& film, std::optional<double> limit, std::optional<double> noise);

/// "3 samples are left out: ..."; empty for none.
std::string samples_left_out(RenderStatistics const& statistics);

}  // namespace lichtraum::app
