#include "reference/scene.hpp"

#include "scene/drawn_roots.hpp"

namespace lichtraum {

std::vector<Light> casting_shadows(std::vector<Light> const& lights) {
  std::vector<Light> result;
  for (Light const& light : lights) {
    if (light.casts_shadows()) result.push_back(light);
  }
  return result;
}

ReferenceScene make_reference_scene(Scene const& scene, std::string_view root) {
  ReferenceScene result{shading_of(scene), {}, {}, scene.environment, 0};
  result.roots = drawn_roots(scene, root);
  result.lights = casting_shadows({scene.lights.begin(), scene.lights.end()});
  return result;
}

}  // namespace lichtraum
