#include "lichtraum/scene.hpp"

#include <unordered_set>

#include "scene/graph_order.hpp"

namespace lichtraum {

std::vector<std::shared_ptr<Shape const>> Scene::roots() const {
  std::unordered_set<Shape const*> named;  // by a composite
  std::vector<Composite const*> pending;
  for (auto const& shape : shapes) {
    if (Composite const* const composite = as_composite(*shape)) pending.push_back(composite);
  }
  std::unordered_set<Composite const*> seen(pending.begin(), pending.end());
  while (!pending.empty()) {
    Composite const* const parent = pending.back();
    pending.pop_back();
    for (auto const& child : parent->children()) {
      if (!named.insert(child.get()).second) continue;
      Composite const* const composite = as_composite(*child);
      if (composite && seen.insert(composite).second) pending.push_back(composite);
    }
  }

  std::vector<std::shared_ptr<Shape const>> result;
  for (auto const& shape : shapes) {
    if (!named.contains(shape.get())) result.push_back(shape);
  }
  return result;
}

Rgb Scene::ambient() const {
  Rgb sum(0);
  for (Light const& light : lights) sum += light.la();
  return sum;
}

}  // namespace lichtraum
