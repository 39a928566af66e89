#pragma once

#include "lichtraum/renderer.hpp"
#include "reference/scene.hpp"

namespace lichtraum {

/// The nearest surface with t_min < t < hit.t; `hit` is only changed when the result is true.
bool find_closest(ReferenceScene const& scene, Ray const& ray, double t_min, Hit& hit);

/// The radiance that arrives along a camera ray of unit direction: Whitted's algorithm (Whitted 1980) with Phong's
/// reflection, as material.hpp says it. At most `max_depth` mirrored or refracted rays follow one another. The rays
/// traced are added to `counts`.
/// `background`: what the camera ray sees where it hits nothing.
Rgb trace_radiance(ReferenceScene const& scene, Ray const& camera_ray, Rgb const& background, int max_depth,
                   RayCounts& counts);

}  // namespace lichtraum
