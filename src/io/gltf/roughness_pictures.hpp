#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <utility>

#include "io/gltf/budget.hpp"
#include "lichtraum/pbr_model.hpp"

namespace lichtraum::gltf {

/// How rough the surfaces of KHR_materials_pbrSpecularGlossiness are: 1 - glossiness, for which our materials have no
/// word. Each picture is made once for all materials that use it.
class RoughnessPictures {
 public:
  using Picture = std::shared_ptr<TextureImage const>;

  struct Roughness {
    double factor = 1;
    Picture picture;          ///< of metallic-roughness, for a dielectric; null: everywhere alike
    bool is_average = false;  ///< for want of memory for a picture
  };

  explicit RoughnessPictures(Budget& budget) : budget_(budget) {}

  /// Where glossiness is a factor times the alpha of `source`.
  Roughness roughness_from(Picture const& source, double glossiness);

 private:
  /// What a picture has of it, from 0 to 255.
  struct Alpha {
    std::uint8_t least = 255, most = 0;
    double mean = 0;
  };

  Alpha const& alpha_of(Picture const& source);
  Roughness make(Picture const& source, double glossiness);

  Budget& budget_;
  std::map<Picture, Alpha> alphas_;  // as many materials may differ in nothing but the factor
  std::map<std::pair<Picture, double>, Roughness> known_;
};

}  // namespace lichtraum::gltf
