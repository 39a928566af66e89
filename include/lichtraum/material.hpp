#pragma once

#include <iosfwd>
#include <string>
#include <variant>

#include "lichtraum/api.hpp"
#include "lichtraum/pbr_model.hpp"
#include "lichtraum/phong_model.hpp"

namespace LICHTRAUM_API lichtraum {

/// What a surface is made of: a name, and one of two models.
class Material {
 public:
  using Model = std::variant<PhongModel, PbrModel>;

  /// A light grey, matt material without a name.
  Material() = default;
  Material(std::string name, Rgb const& ka, Rgb const& kd, Rgb const& ks, double m);
  /// Throws std::invalid_argument unless all numbers are finite (PbrModel::attenuation_distance may be infinite), and
  /// of Phong's model reflect, transmit and their sum lie in 0..1 and ior is positive.
  Material(std::string name, Model model);

  std::string const& name() const { return name_; }
  Model const& model() const { return model_; }

  /// glTF's model; null for a material that has Phong's.
  PbrModel const* pbr() const { return std::get_if<PbrModel>(&model_); }
  /// Phong's model, or coefficients that look like glTF's under Whitted's integrator, by the mapping in docs/GLTF.md:
  /// without its textures, whose changes are derived again at each point of a mesh.
  PhongModel phong() const;

  /// Its coefficients one by one: ka(), kd(), ks(), m(), reflect(), transmit(), ior(), emission().
#define LICHTRAUM_COLOR(name, initial) \
  Rgb name() const { return phong().name; }
#define LICHTRAUM_SHARE(name, initial) \
  double name() const { return phong().name; }
#define LICHTRAUM_NUMBER(name, initial, least, most) LICHTRAUM_SHARE(name, initial)
  PHONG_FIELDS(LICHTRAUM_COLOR, LICHTRAUM_SHARE, LICHTRAUM_NUMBER)
#undef LICHTRAUM_COLOR
#undef LICHTRAUM_SHARE
#undef LICHTRAUM_NUMBER
  bool is_opaque() const { return transmit() == 0; }

 private:
  std::string name_;
  Model model_;
};

/// What differs from the initial values; of Phong's model also ka, kd, ks and m.
std::ostream& operator<<(std::ostream& out, Material const& material);

}  // namespace lichtraum
