#pragma once

#include "reference/environment.hpp"
#include "reference/ground.hpp"
#include "reference/random.hpp"
#include "reference/scene.hpp"
#include "reference/surfaces.hpp"

namespace lichtraum {

struct PathSample {
  Rgb radiance{0};
  FirstSurface surface;
};

/// One path from a camera ray of unit direction: an estimate of the same integral as kernels/integrators/path.clh, by
/// another estimator (docs/RAYTRACING.md, section 19). A path is scattered at most request.max_depth times; light of
/// what no ray meets may scatter once more. The rays traced are added to `counts`. `background`: what the camera's ray
/// sees where it hits nothing.
PathSample trace_path(ReferenceScene const& scene, ReferenceEnvironment const& environment,
                      ReferenceGround const& ground, Ray const& ray, Rgb const& background,
                      RenderRequest const& request, ReferenceRandom& random, RayCounts& counts);

}  // namespace lichtraum
