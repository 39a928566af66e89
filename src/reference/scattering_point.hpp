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
  bool shows_back = true;           ///< false: seen from behind, it is not there for the camera
  PbrModel const* solid = nullptr;  ///< the body that the surface encloses, if light gets into it

  /// By the normal of shading, unless that faces away from the viewer.
  ReferenceScattering scattering() const { return {bsdf, normal, to_viewer, from_outside}; }
  /// What the film's plane holds.
  Rgb albedo() const;
  /// Whether a direction is on the same side by both normals; through others, light would leak.
  bool is_consistent(Vec3 const& direction) const;
  Ray leave(Vec3 const& direction) const;
};

/// What is left of light after a way in a solid (KHR_materials_volume).
Rgb attenuation(PbrModel const& solid, double distance);

/// As find_reference_point.
ReferenceScatteringPoint find_scattering_point(Ray const& ray, Hit const& hit);

/// How much light gets straight through where a hit is, on its way from a light: past what blends, but through no
/// glass.
double uncovered_share(Hit const& hit);

/// Throws Error{no_device} for a material of which paths of the reference tracer would show something wrong.
void check_is_known(Material const& material);

}  // namespace lichtraum
