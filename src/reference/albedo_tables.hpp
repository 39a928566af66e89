#pragma once

namespace lichtraum {

/// What a rough surface reflects or refracts in all of the light from everywhere, after one bounce between its
/// microfacets. The tables are part of the definition of materials (docs/RAYTRACING.md, section 17), and this is how
/// they are read: linearly between entries. `cosine` is between viewer and normal.

struct ReflectionAlbedo {
  double a, b;  ///< f0 * a + f90 * b
};
ReflectionAlbedo reflection_albedo(double alpha, double cosine);

struct SolidAlbedo {
  double total;      ///< reflected and refracted
  double reflected;  ///< of it, towards a viewer within only
};
/// `eta` is the index of refraction on the viewer's side over the one beyond, `specular` the factor of what microfacets
/// reflect of it before the critical angle.
SolidAlbedo solid_albedo(double eta, double specular, double alpha, double cosine);

}  // namespace lichtraum
