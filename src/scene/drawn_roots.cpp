#include "scene/drawn_roots.hpp"

#include <fmt/format.h>

namespace lichtraum {

std::vector<std::shared_ptr<Shape const>> drawn_roots(Scene const& scene, std::string_view root) {
  if (root.empty()) return scene.roots();
  if (auto const* shape = scene.shapes.find(root)) return {*shape};
  throw Error(ErrorKind::usage, fmt::format("the scene has no shape called '{}'", root));
}

}  // namespace lichtraum
