#include "scene/drawn_roots.hpp"

#include <fmt/format.h>

#include "core/edit_distance.hpp"

namespace lichtraum {
namespace {

/// What was probably meant; empty where nothing is near.
std::string_view nearest_shape(Scene const& scene, std::string_view name) {
  std::size_t limit = likely_slips(name);
  std::string_view nearest;
  for (auto const& shape : scene.shapes) {
    std::size_t const distance = edit_distance(name, shape->name(), limit);
    if (distance > limit) continue;
    nearest = shape->name();
    if (distance == 0) break;
    limit = distance - 1;
  }
  return nearest;
}

/// "the scene has no shape called 'rood': did you mean 'rod'?", or which it has.
std::string lacks_shape(Scene const& scene, std::string_view name) {
  std::string const lack = fmt::format("the scene has no shape called '{}'", name);
  if (auto const nearest = nearest_shape(scene, name); !nearest.empty()) {
    return fmt::format("{}: did you mean '{}'?", lack, nearest);
  }
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
