#pragma once

#include <vector>

#include "lichtraum/math.hpp"

namespace lichtraum {

/// What a point of a surface does with light, whatever its material's model.
struct ReferenceBsdf {
  Rgb diffuse{0};           ///< reflectance of the matt lobe
  Rgb f0{0}, f90{0};        ///< Fresnel's factor of the gloss: head-on, and at grazing angles
  Rgb metal{0};             ///< the same of the metal's share of the surface, head-on
  double metallic = 0;      ///< that share
  double alpha = 1;         ///< GGX's roughness of both; at most `smooth_alpha`: a mirror
  bool is_layered = false;  ///< as glTF has it: what is reflected is missing below, and no light is lost
  Rgb transmitted{0};       ///< of the light that gets below the gloss
  double ior = 1;           ///< that bends it; 1: a thin wall
  double mirror = 0;        ///< eSDF's reflect
  double glass = 0;         ///< eSDF's transmit
  double coat = 0;          ///< share of a clear coat
  double coat_alpha = 1;
  bool has_film = false;  ///< f0 and metal are those of a thin film, for the viewer
};

/// GGX is no sharper than this, in the kernels as well; as far as directions are chosen here, this is no spread at all.
inline constexpr double smooth_alpha = 0.001;

/// What a clear coat of index 1.5 reflects. `cosine`: of the direction and the normal, not negative.
double coat_fresnel(double cosine);

/// A BSDF at a point, as seen from one direction: docs/RAYTRACING.md, section 17. Vectors are unit, in the world.
class ReferenceScattering {
 public:
  /// Both normals are on the viewer's side; `normal` is `smooth_normal` where no normal map has turned it.
  /// `from_outside`: the viewer is not in the body that the surface encloses.
  ReferenceScattering(ReferenceBsdf const& bsdf, Vec3 const& smooth_normal, Vec3 const& normal, Vec3 const& to_viewer,
                      bool from_outside);

  enum class Lobes {
    all,     ///< but mirror and glass: what a light without extent shows
    spread,  ///< those that are not smooth
  };
  /// f times the cosine between `to_light` and the normal.
  Rgb evaluate(Vec3 const& to_light, Lobes lobes) const;

  /// The same surface with lobes that are no sharper than `alpha`.
  ReferenceScattering blurred(double alpha) const;

  /// Whether there are lobes that are not smooth, and whether any of them goes to the other side.
  bool has_spread() const;
  bool transmits() const;

  /// A direction in which light goes on without being spread, and its share.
  struct Ray {
    Vec3 direction;
    Rgb weight;
    bool is_mirror_or_glass;  ///< eSDF's
  };
  std::vector<Ray> smooth_rays() const;

 private:
  bool is_solid() const;
  Rgb fresnel(double cosine) const;
  Rgb refracted_share(double cosine) const;
  Rgb transmitted(Vec3 const& to_light) const;
  Vec3 mirrored() const;
  /// The viewer's ray beyond the surface; where there is total reflection, the mirrored one.
  Vec3 refracted() const;

  ReferenceBsdf bsdf_;
  Vec3 smooth_normal_;
  Vec3 normal_;
  Vec3 to_viewer_;
  double eta_;               // the index of refraction on the viewer's side over the one beyond
  double below_coat_ = 1;    // the share that the coat leaves
  Rgb base_{1};              // what coat and gloss leave for the lobes below them
  double gloss_albedo_ = 1;  // what microfacets reflect at once, of all that they reflect
  Rgb dielectric_gain_{1};   // by what they reflect or refract again
  Rgb metal_gain_{1};
  double refraction_gain_ = 1;
};

}  // namespace lichtraum
