#pragma once

#include "reference/point.hpp"
#include "reference/scattering.hpp"

namespace lichtraum {

/// A point of a surface for paths, as seen by the ray that found it: the definition of find_bsdf in
/// kernels/bsdf/bsdf_at.clh.
struct ReferenceScatteringPoint : ReferencePoint {
  ReferenceBsdf bsdf;
  Rgb emission{0};
  double opacity = 1;               ///< the share of rays that meet the surface; the others go straight on
  Rgb passed{0};                    ///< of the light that meets it, what goes straight on through a pane ...
  double chance_to_pass = 0;        ///< ... and with what probability a path does
  bool shows_back = true;           ///< false: seen from behind, it is not there for the camera
  PbrModel const* solid = nullptr;  ///< the body that the surface encloses, if light gets into it

  /// By the normal of shading, which find_scattering_point has turned to the viewer where it did not face him.
  ReferenceScattering scattering() const { return {bsdf, smooth_normal, normal, to_viewer, from_outside}; }
  /// What goes straight on of all the light that gets there: where nothing is, and through panes.
  Rgb straight() const { return 1.0 - opacity + opacity * passed; }
  /// The probability with which a path is scattered.
  double chance_to_scatter() const { return opacity * (1 - chance_to_pass); }
  /// What the film's plane holds.
  Rgb albedo() const;
  /// Whether a direction is on the same side by both normals; through others, light would leak.
  bool is_consistent(Vec3 const& direction) const;
  Ray leave(Vec3 const& direction) const;
  /// The same of rays to lamps, which begin at the round body that smooth triangles stand for.
  bool is_consistent_with_lamp(Vec3 const& to_light) const;
  Ray leave_to_lamp(Vec3 const& to_light) const;
};

/// What is left of light after a way in a solid (KHR_materials_volume).
Rgb attenuation(PbrModel const& solid, double distance);

/// The index of refraction that light has in a solid.
double ior_in(PbrModel const& solid);

/// The share that counts of what shines in a solid; nullptr: in none. The definition of light_share_in in
/// kernels/integrators/solid.clh.
double light_share(PbrModel const* solid);

/// As find_reference_point.
ReferenceScatteringPoint find_scattering_point(Ray const& ray, Hit const& hit);

/// Throws Error{no_device} for a material of which paths of the reference tracer would show something wrong.
void check_is_known(Material const& material);

}  // namespace lichtraum
