#pragma once

#include "lichtraum/shape.hpp"

namespace lichtraum {

/// A point of a surface, as seen by the ray that found it: the definition of kernels/surface/shading_point.clh.
struct ReferencePoint {
  Vec3 position{0};
  Vec3 geometric_normal{0};  // unit length, on the viewer's side
  Vec3 normal{0};            // the same, for shading: smooth, and bumpy by a normal map
  Vec3 smooth_normal{0};     // the same without a normal map
  Vec3 round_normal{0};      // the same, of the body that smooth triangles stand for
  Vec3 lift{0};              // from the point to that body, roughly
  Vec3 to_viewer{0};         // unit length
  PhongModel phong;
  bool from_outside = true;  // the viewer is on the side that the surface's own normal points to
  double offset = 0;         // rays start this far off the surface, so as not to hit it again

  void set_normals(Vec3 const& n) { geometric_normal = normal = smooth_normal = round_normal = n; }
  Vec3 above() const { return position + offset * geometric_normal; }
  Vec3 below() const { return position - offset * geometric_normal; }
};

/// How much a matt surface shows of light from there, which a normal map has turned it to: the definition of
/// kernels/surface/bump_shadow.clh. All vectors are unit, and the light faces `normal`.
double bump_shadow(Vec3 const& smooth_normal, Vec3 const& normal, Vec3 const& to_light);

/// How far, relative to the coordinates that went into it, a computed hit point may lie off its surface. A double has
/// 16 digits; the others are for cancellation, as where a small scene stands on a sphere of a million units.
inline constexpr double reference_ray_epsilon = 1e-9;

/// `hit` is what was found for `ray`, whose direction has unit length.
ReferencePoint find_reference_point(Ray const& ray, Hit const& hit);

/// Light grey where the shape has none.
Material const& material_of(Shape const& shape);

/// Whether nothing is there where a hit is: an alpha mask cuts it out, or it is wholly transparent.
bool is_absent(Hit const& hit);
/// How much light gets straight through there.
double transmittance(Hit const& hit);

}  // namespace lichtraum
