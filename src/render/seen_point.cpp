#include "lichtraum/seen_point.hpp"

namespace lichtraum {

std::optional<SeenPoint> look_at_pixel(Renderer& renderer, RenderRequest view, int x, int y) {
  view.region = {x, y, 1, 1};
  view.sampling = {};  // the middle of what is looked at
  view.samples.reset();
  view.planes = {Plane::object, Plane::depth, Plane::position, Plane::normal};
  Film film;
  renderer.render(view, film);
  SeenPoint seen;
  seen.object = film.number(Plane::object, 0, 0);
  if (seen.object == 0) return std::nullopt;
  auto const vector = [&](Plane plane) {
    auto const value = [&](int channel) { return double(film.value(plane, 0, 0, channel)); };
    return Vec3(value(0), value(1), value(2));
  };
  seen.distance = double(film.value(Plane::depth, 0, 0));
  seen.position = vector(Plane::position);
  seen.normal = vector(Plane::normal);
  return seen;
}

}  // namespace lichtraum
