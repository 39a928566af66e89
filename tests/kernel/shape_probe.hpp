#pragma once

#include <string>
#include <vector>

#include "reference.hpp"
#include "support/opencl_probe.hpp"

namespace lichtraum::test {

/// Primitives with a ray each, run through one of the probes of shapes.cl: t per pair, infinity for none.
template <class Primitive>
struct ShapeCases {
  std::vector<Primitive> primitives;
  std::vector<ProbeRay> rays;
  std::vector<float> t_max;

  void add(Primitive const& primitive, Vec3 const& origin, Vec3 const& direction, float limit = float_infinity) {
    primitives.push_back(primitive);
    rays.push_back({to_float4(origin), to_float4(direction)});
    t_max.push_back(limit);
  }
  std::vector<float> run(std::string const& kernel) const {
    ProbeProgram const program("shapes.cl");
    std::vector<float> t(rays.size());
    program.run(kernel, rays.size(), {in(primitives), in(rays), in(t_max), out(t)});
    return t;
  }
};

/// A ray from around a thing to about it: two thirds hit, some start inside, some run away from it; the direction has
/// any length.
inline std::pair<Vec3, Vec3> random_ray(Random& random, Vec3 const& center, double size) {
  double const distance = random.uniform() < 0.2 ? 0.5 : std::pow(10., random.uniform(0, 3));
  Vec3 const origin = center + random.direction() * (distance * size);
  Vec3 const target = center + random.in_cube(1.2 * size);
  double const sign = random.uniform() < 0.1 ? -1 : 1;
  return {origin, (target - origin) * sign * std::pow(10., random.uniform(-4, 4)) / (distance * size)};
}

}  // namespace lichtraum::test
