#include "lichtraum/seen_point.hpp"

namespace lichtraum {

std::optional<SeenPoint> look_at_pixel(Renderer& renderer, RenderRequest view, int x, int y) {
  view.region = {x, y, 1, 1};
  view.sampling = {};  // the middle of what is looked at
  view.samples.reset();
  view.planes = {FilmPlane::object, FilmPlane::depth, FilmPlane::position, FilmPlane::normal};
  Film film;
  renderer.render(view, film);
  SeenPoint seen;
  seen.object = film.number(FilmPlane::object, 0, 0);
  if (seen.object == 0) return std::nullopt;
  auto const vector = [&](FilmPlane plane) {
    auto const value = [&](int channel) { return double(film.value(plane, 0, 0, channel)); };
    return Vec3(value(0), value(1), value(2));
  };
  seen.distance = double(film.value(FilmPlane::depth, 0, 0));
  seen.position = vector(FilmPlane::position);
  seen.normal = vector(FilmPlane::normal);
  return seen;
}

}  // namespace lichtraum
