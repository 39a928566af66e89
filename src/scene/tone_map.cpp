#include "lichtraum/tone_map.hpp"

#include <cmath>
#include <stdexcept>

#include "core/srgb.hpp"

namespace lichtraum {
namespace {

double reinhard(double c) { return std::isinf(c) ? 1 : c / (c + 1); }

template <class Function>
Rgb per_channel(Rgb const& c, Function const& f) {
  return {f(c.r), f(c.g), f(c.b)};
}

}  // namespace

Rgb develop(Rgb const& radiance, ToneMap tone_map, Transfer transfer) {
  if (tone_map == ToneMap::automatic) throw std::invalid_argument("develop needs a definite tone map");
  Rgb const mapped = tone_map == ToneMap::reinhard ? per_channel(radiance, reinhard) : radiance;
  return transfer == Transfer::srgb ? per_channel(mapped, srgb_from_linear) : mapped;
}

}  // namespace lichtraum
