#include "scene/drawn_roots.hpp"

#include <fmt/format.h>

#include "core/suggester.hpp"

namespace lichtraum {
namespace {

/// "the scene has no shape called 'rood': did you mean 'rod'?", or which it has.
std::string lacks_shape(Scene const& scene, std::string_view name) {
  std::string const lack = fmt::format("the scene has no shape called '{}'", name);
  Suggester suggester;
  suggester.look_for(name);
  suggester.consider_all(scene.shapes);
  if (!suggester.best().empty()) return fmt::format("{}: did you mean '{}'?", lack, suggester.best());
  constexpr std::size_t most_names = 10;
  std::string names;
  std::size_t listed = 0;
  for (auto const& shape : scene.shapes) {
    if (listed++ == most_names) break;
    names += fmt::format("{}{}", names.empty() ? "" : ", ", shape->name());
  }
  std::size_t const count = scene.shapes.size();
  return fmt::format("{}; there {} {}{}", lack, count == 1 ? "is" : "are", count == 0 ? "none" : names,
                     count > most_names ? fmt::format(" and {} more", count - most_names) : "");
}

}  // namespace

std::vector<std::shared_ptr<Shape const>> drawn_roots(Scene const& scene, std::string_view root) {
  if (root.empty()) return scene.roots();
  if (auto const* shape = scene.shapes.find(root)) return {*shape};
  throw Error(ErrorKind::usage, lacks_shape(scene, root));
}

}  // namespace lichtraum
