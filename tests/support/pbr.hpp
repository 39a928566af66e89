#pragma once

#include "lichtraum/pbr_model.hpp"

namespace lichtraum::test {

/// Without textures.
inline PbrModel pbr(Rgb const& color, double metallic, double roughness) {
  PbrModel model;
  model.base_color = color;
  model.metallic = metallic;
  model.roughness = roughness;
  return model;
}

}  // namespace lichtraum::test
