#pragma once

#include "lichtraum/math.hpp"

namespace lichtraum {

/// Trowbridge and Reitz's microfacets, as glTF 2.0's appendix B.2.3 and docs/RAYTRACING.md have them. Vectors are unit,
/// in the world; `normal` is the surface's, `h` that of a microfacet; 0 < alpha <= 1.

/// How much of the surface's area has microfacets with that normal, per solid angle.
double microfacet_density(double alpha, Vec3 const& normal, Vec3 const& h);

/// The share of them that nothing hides from either direction: Smith's, height-correlated (Heitz, "Understanding the
/// Masking-Shadowing Function in Microfacet-Based BRDFs", 2014, equation 99).
double unhidden_share(double alpha, Vec3 const& normal, Vec3 const& v, Vec3 const& l);

/// f of microfacets that mirror all light, for two directions on the normal's side.
double microfacet_reflection(double alpha, Vec3 const& normal, Vec3 const& v, Vec3 const& l);

/// f of microfacets that refract all light (Walter et al. 2007, equation 21, without the factor by which radiance is
/// denser in a denser body), for `l` on the other side. `eta` is the index of refraction on v's side over the one on
/// l's. `h`: see refracting_normal.
double microfacet_refraction(double alpha, Vec3 const& normal, Vec3 const& v, Vec3 const& l, Vec3 const& h, double eta);

/// The normal, on the surface's side, of the microfacets that refract light from `l` to `v` or the other way round.
Vec3 refracting_normal(Vec3 const& normal, Vec3 const& v, Vec3 const& l, double eta);

}  // namespace lichtraum
