#pragma once

#include "lichtraum/math.hpp"

namespace lichtraum {

/// What a base reflects under a thin film in air, 0..1, in linear sRGB: Belcour and Barla, "A Practical Extension to
/// Microfacet Theory for the Modeling of Varying Iridescence", 2017, as KHR_materials_iridescence simplifies it.
/// `ior` >= 1; `cosine`: of the angle in air, > 0; `f0`: what the base reflects head-on without the film, 0..1.
Rgb thin_film_reflectance(double ior, double thickness_nm, double cosine, Rgb const& f0);

}  // namespace lichtraum
