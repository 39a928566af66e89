#pragma once

#include <optional>

#include "reference/environment.hpp"
#include "reference/scattering_point.hpp"
#include "reference/scene.hpp"

namespace lichtraum {

/// The definition of kernels/integrators/ground.clh: a surface that would look like the background if nothing stood on
/// it.
class ReferenceGround {
 public:
  ReferenceGround() = default;  ///< none
  ReferenceGround(ReferenceScene const& scene, ReferenceEnvironment const& environment, Ground kind);

  explicit operator bool() const { return kind_ != Ground::none; }

  /// How far a unit ray gets before it meets the ground; infinity: it does not.
  double distance(Ray const& ray) const;

  bool is_glossy() const { return kind_ == Ground::glossy; }

  /// A point of it, of its matt lobe or of its gloss. `shown`: what it looks like in the open.
  ReferenceScatteringPoint matt_point(Ray const& ray, double t, Rgb const& shown) const;
  ReferenceScatteringPoint glossy_point(Ray const& ray, double t) const;

 private:
  ReferenceScatteringPoint black_point(Ray const& ray, double t) const;
  /// What a white matt ground would show if nothing stood on it.
  Rgb open_radiance(Vec3 const& position) const;

  Ground kind_ = Ground::none;
  Vec3 up_{0, 1, 0};   // unit
  double height_ = 0;  // along that
  Rgb from_afar_{0};
  std::vector<Light> lights_;
};

}  // namespace lichtraum
