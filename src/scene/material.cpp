#include "lichtraum/material.hpp"

#include <cmath>
#include <ostream>
#include <stdexcept>

#include "core/format_numbers.hpp"

namespace lichtraum {

void Material::set_mirror_and_glass(double reflect, double transmit, double ior) {
  // Decimals that add up to 1 on paper may be an ulp above it.
  constexpr double sum_limit = 1 + 1e-12;
  if (!(reflect >= 0 && reflect <= 1 && transmit >= 0 && transmit <= 1 && reflect + transmit <= sum_limit)) {
    throw std::invalid_argument("reflect, transmit and their sum must lie in 0..1");
  }
  if (!(ior > 0 && std::isfinite(ior))) throw std::invalid_argument("the index of refraction must be positive");
  reflect_ = reflect;
  transmit_ = transmit;
  ior_ = ior;
}

std::ostream& operator<<(std::ostream& out, Material const& material) {
  out << fmt::format("material '{}': ka {}, kd {}, ks {}, m {}", material.name(), format_numbers(material.ka()),
                     format_numbers(material.kd()), format_numbers(material.ks()), material.m());
  if (material.emission() != Rgb(0)) out << fmt::format(", emission {}", format_numbers(material.emission()));
  if (material.reflect() != 0) out << fmt::format(", reflect {}", material.reflect());
  if (material.transmit() != 0) out << fmt::format(", transmit {}, ior {}", material.transmit(), material.ior());
  return out;
}

}  // namespace lichtraum
