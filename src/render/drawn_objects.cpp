#include "lichtraum/drawn_objects.hpp"

#include "scene/drawn_roots.hpp"
#include "scene/graph_fold.hpp"

namespace lichtraum {

DrawnObjects::DrawnObjects(Scene const& scene, std::string_view root) : roots_(drawn_roots(scene, root)) {
  auto const counts = fold_graph<std::uint64_t>(
      roots_, [](Shape const&) { return std::uint64_t(1); },
      [](std::uint64_t& sum, Shape const&, std::uint64_t count) { sum = saturating_add(sum, count); });
  counts_ = counts.composites();
  count_ = counts.total();
}

std::uint64_t DrawnObjects::count_below(Shape const& shape) const {
  return as_composite(shape) ? counts_.at(&shape) : 1;
}

std::vector<std::uint32_t> DrawnObjects::path_of(std::uint64_t number) const {
  std::vector<std::uint32_t> path;
  if (number == 0 || number > count_) return path;
  std::uint64_t before = number - 1;  // objects of the current level that come first
  auto const descend = [&](auto const& shapes) -> Shape const* {
    for (std::size_t i = 0; i < shapes.size(); ++i) {
      std::uint64_t const count = count_below(*shapes[i]);
      if (before < count) {
        path.push_back(std::uint32_t(i));
        return shapes[i].get();
      }
      before -= count;
    }
    return nullptr;
  };
  Shape const* shape = descend(roots_);
  while (Composite const* const composite = shape ? as_composite(*shape) : nullptr)
    shape = descend(composite->children());
  return path;
}

std::vector<std::shared_ptr<Shape const>> DrawnObjects::shapes_on(std::vector<std::uint32_t> const& path) const {
  std::vector<std::shared_ptr<Shape const>> shapes;
  for (std::uint32_t const number : path) {
    if (shapes.empty()) {
      shapes.push_back(roots_.at(number));
      continue;
    }
    Composite const* const composite = as_composite(*shapes.back());
    if (!composite) throw std::out_of_range("a shape that is not a composite has no children");
    shapes.push_back(composite->children().at(number));
  }
  return shapes;
}

}  // namespace lichtraum
