#pragma once

#include <iosfwd>
#include <memory>
#include <string>

#include "lichtraum/math.hpp"
#include "lichtraum/pbr_material.hpp"

namespace lichtraum {

/// Phong's coefficients (Phong 1975) with Whitted's mirror and glass terms (Whitted 1980). A surface shows
///   emission + (1 - reflect - transmit) * (ambient + diffuse) + specular highlight
///   + reflect * (what its mirror ray sees) + transmit * (what its refracted ray sees).
class Material {
 public:
  /// A light grey, matt material without a name.
  Material() = default;
  Material(std::string name, Rgb const& ka, Rgb const& kd, Rgb const& ks, double m)
      : name_(std::move(name)), ka_(ka), kd_(kd), ks_(ks), m_(m) {}

  std::string const& name() const { return name_; }
  Rgb const& ka() const { return ka_; }  ///< ambient reflectance
  Rgb const& kd() const { return kd_; }  ///< diffuse reflectance
  Rgb const& ks() const { return ks_; }  ///< specular reflectance
  double m() const { return m_; }        ///< specular exponent

  double reflect() const { return reflect_; }    ///< share of the mirror ray, 0..1
  double transmit() const { return transmit_; }  ///< share of the refracted ray, 0..1
  double ior() const { return ior_; }            ///< index of refraction, > 0

  Rgb const& emission() const { return emission_; }  ///< what it shows without any light; none lights other surfaces
  void set_emission(Rgb const& emission) { emission_ = emission; }

  /// Throws std::invalid_argument unless reflect, transmit and their sum lie in 0..1 and ior is positive.
  void set_mirror_and_glass(double reflect, double transmit, double ior);
  bool is_opaque() const { return transmit_ == 0; }

  /// The physically based material that the coefficients were derived from; null for one that never had any.
  std::shared_ptr<PbrMaterial const> const& pbr() const { return pbr_; }
  void set_pbr(std::shared_ptr<PbrMaterial const> pbr) { pbr_ = std::move(pbr); }

 private:
  std::string name_;
  std::shared_ptr<PbrMaterial const> pbr_;
  Rgb ka_{0.8};
  Rgb kd_{0.8};
  Rgb ks_{0};
  double m_ = 1;
  double reflect_ = 0;
  double transmit_ = 0;
  double ior_ = 1;
  Rgb emission_{0};
};

/// Phong coefficients that look like `pbr` under Whitted's integrator, by the mapping in docs/GLTF.md. The material
/// keeps `pbr`. Textures count as all ones: what they change is derived again at each point of a mesh.
Material phong_from_pbr(std::string name, std::shared_ptr<PbrMaterial const> pbr);

std::ostream& operator<<(std::ostream& out, Material const& material);

}  // namespace lichtraum
