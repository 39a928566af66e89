#include "view/overlays.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <optional>

#include "lichtraum/orbit.hpp"

namespace lichtraum::view {
namespace {

/// What lies on a surface is seen, too.
constexpr double slack = 2e-3;

double size_of(Bounds const& bounds) {
  double const size = bounds.is_empty() ? 1 : glm::distance(bounds.min, bounds.max);
  return std::isfinite(size) && size > 0 ? size : 1;
}

struct PixelRay {
  Ray ray;
  double depth;  // of what is there, along the ray
};

PixelRay ray_of(Film const& film, Camera const& camera, int x, int y) {
  return {camera.generate_ray(x + 0.5, y + 0.5, film.size()), double(film.value(FilmPlane::depth, x, y))};
}

bool is_seen(double t, double depth) { return t > 0 && t <= depth * (1 + slack); }

/// How much of a pixel a line of its width covers, whose middle is so many pixels away.
float coverage(double pixels) { return float(std::clamp(1 - pixels, 0.0, 1.0)); }

/// Whether it is rather light around a pixel: of one pixel alone a line would be now dark and now light.
bool is_light_around(std::vector<unsigned char> const& pixels, Resolution const& size, int x, int y) {
  constexpr int reach = 4;
  int sum = 0, count = 0;
  for (int row = std::max(0, y - reach); row <= std::min(size.height - 1, y + reach); ++row) {
    for (int column = std::max(0, x - reach); column <= std::min(size.width - 1, x + reach); ++column) {
      unsigned char const* const rgb = &pixels[4 * (std::size_t(row) * std::size_t(size.width) + std::size_t(column))];
      sum += rgb[0] + 2 * rgb[1] + rgb[2];
      ++count;
    }
  }
  return sum > 4 * 100 * count;
}

}  // namespace

PlaneSet Overlays::planes() const {
  PlaneSet planes;
  if (grid || axes || edges) planes.add(FilmPlane::depth);
  if (edges) {
    planes.add(FilmPlane::object);
    planes.add(FilmPlane::normal);
  }
  return planes;
}

OverlayLayer::OverlayLayer(Overlays const& overlays, Film const& film, Camera const& camera, Bounds const& bounds) {
  if (overlays.planes().is_empty()) return;
  size_ = film.size();
  pixels_.resize(std::size_t(size_.width) * std::size_t(size_.height));
  Camera pinhole = camera;
  pinhole.set_lens({});
  if (overlays.grid) add_grid(film, pinhole, bounds, overlays.up);
  if (overlays.axes) add_axes(film, pinhole, bounds);
  if (overlays.edges) add_edges(film);
}

void OverlayLayer::add_grid(Film const& film, Camera const& camera, Bounds const& bounds, Vec3 const& up) {
  auto const [width, height] = film.size();
  Transform const grid_from_world = orbit_rotation({}, up).inverse();  // where y is up
  double const size = size_of(bounds);
  double const distance = std::pow(10, std::floor(std::log10(size / 2)));
  Bounds const box = bounds.is_empty() ? Bounds{Vec3(0), Vec3(0)} : mapped(grid_from_world, bounds);
  double const level = box.min.y;
  Vec3 const middle = box.center();
  // Where on the grid, in cells, and whether the grid is seen there.
  struct Place {
    double u, v;
    bool is_there, is_seen;
  };
  auto const place = [&](int x, int y) -> Place {
    Ray const ray = camera.generate_ray(x + 0.5, y + 0.5, film.size());
    Vec3 const origin = grid_from_world.point(ray.origin), direction = grid_from_world.vector(ray.direction);
    double const t = (level - origin.y) / direction.y;
    if (!(t > 0) || !std::isfinite(t)) return {};
    Vec3 const point = origin + t * direction;
    bool const is_in_picture = x < film.size().width && y < film.size().height;
    return {point.x / distance, point.z / distance, true,
            is_in_picture && is_seen(t, double(film.value(FilmPlane::depth, x, y)))};
  };
  std::vector<Place> row(std::size_t(width) + 1), below(std::size_t(width) + 1);
  auto const fill = [&](std::vector<Place>& places, int y) {
    for (int x = 0; x <= film.size().width; ++x) places[std::size_t(x)] = place(x, y);
  };
  fill(below, 0);
  for (int y = 0; y < height; ++y) {
    row.swap(below);
    fill(below, y + 1);
    for (int x = 0; x < width; ++x) {
      Place const &here = row[std::size_t(x)], &right = row[std::size_t(x) + 1], &under = below[std::size_t(x)];
      if (!here.is_seen || !right.is_there || !under.is_there) continue;
      double const away = distance * std::hypot(here.u - middle.x / distance, here.v - middle.z / distance) / size;
      float const nearness = float(std::clamp(2.5 - away, 0.0, 1.0));  // it ends softly
      auto const line = [&](double at, double at_right, double at_under) {
        double const cells_a_pixel = std::abs(at_right - at) + std::abs(at_under - at);
        float const clearness = float(std::clamp(2 - 8 * cells_a_pixel, 0.0, 1.0));  // far lines would run together
        return clearness * coverage(std::abs(at - std::round(at)) / std::max(cells_a_pixel, 1e-12));
      };
      Pixel& pixel = pixels_[std::size_t(y) * std::size_t(width) + std::size_t(x)];
      pixel.lines = 0.6f * nearness * std::max(line(here.u, right.u, under.u), line(here.v, right.v, under.v));
    }
  }
}

void OverlayLayer::add_axes(Film const& film, Camera const& camera, Bounds const& bounds) {
  auto const [width, height] = film.size();
  double const length = 0.75 * size_of(bounds);
  Vec3 const first = camera.generate_ray(0.5 * width, 0.5 * height, film.size()).direction;
  Vec3 const next = camera.generate_ray(0.5 * width + 1, 0.5 * height, film.size()).direction;
  double const pixel_angle = glm::distance(first, next);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      auto const [ray, depth] = ray_of(film, camera, x, y);
      Pixel& pixel = pixels_[std::size_t(y) * std::size_t(width) + std::size_t(x)];
      for (int axis = 0; axis < 3; ++axis) {
        // The point of the axis that is nearest to the ray, and that of the ray nearest to it.
        double const along = ray.direction[axis], off = 1 - along * along;
        if (off < 1e-12) continue;
        double const s =
            std::clamp((ray.origin[axis] - along * glm::dot(ray.direction, ray.origin)) / off, 0.0, length);
        Vec3 on_axis(0);
        on_axis[axis] = s;
        double const t = glm::dot(on_axis - ray.origin, ray.direction);
        if (!is_seen(t, depth)) continue;
        double const pixels = glm::distance(ray.origin + t * ray.direction, on_axis) / (t * pixel_angle);
        float const covered = coverage(pixels - 0.5);
        if (covered <= pixel.axis) continue;
        pixel.axis = covered;
        pixel.axis_number = axis;
      }
    }
  }
}

void OverlayLayer::add_edges(Film const& film) {
  auto const [width, height] = film.size();
  constexpr double step = 0.02, turn = 0.8;  // of the depth; the cosine of 37 degrees
  auto const depth = [&](int x, int y) { return double(film.value(FilmPlane::depth, x, y)); };
  auto const normal = [&](int x, int y) {
    Vec3 value;
    for (int c = 0; c < 3; ++c) value[c] = double(film.value(FilmPlane::normal, x, y, c));
    return value;
  };
  auto const differ = [&](int x, int y, int dx, int dy) {
    if (film.number(FilmPlane::object, x, y) != film.number(FilmPlane::object, x + dx, y + dy)) return true;
    if (film.number(FilmPlane::object, x, y) == 0) return false;
    Vec3 const a = normal(x, y), b = normal(x + dx, y + dy);
    if (glm::dot(a, b) < turn * glm::length(a) * glm::length(b)) return true;
    // A plane's depth grows evenly, so that what grows more than before is a step.
    if (x - dx < 0 || y - dy < 0) return false;
    double const here = depth(x, y);
    return std::abs(depth(x + dx, y + dy) - 2 * here + depth(x - dx, y - dy)) > step * here &&
           film.number(FilmPlane::object, x - dx, y - dy) == film.number(FilmPlane::object, x, y);
  };
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      bool const is_edge = (x + 1 < width && differ(x, y, 1, 0)) || (y + 1 < height && differ(x, y, 0, 1));
      if (is_edge) pixels_[std::size_t(y) * std::size_t(width) + std::size_t(x)].lines = 1;
    }
  }
}

void OverlayLayer::draw_on(std::vector<unsigned char>& pixels) const {
  constexpr std::array<std::array<float, 3>, 3> axis_colors{{{230, 60, 60}, {80, 180, 60}, {70, 120, 240}}};
  auto const before = pixels;
  for (std::size_t i = 0; i < pixels_.size(); ++i) {
    Pixel const& overlay = pixels_[i];
    if (overlay.lines == 0 && overlay.axis == 0) continue;
    unsigned char* const rgb = &pixels[4 * i];
    auto const width = std::size_t(size_.width);
    bool const is_light = overlay.lines > 0 && is_light_around(before, size_, int(i % width), int(i / width));
    for (std::size_t c = 0; c < 3; ++c) {
      float value = float(rgb[c]);
      value += overlay.lines * ((is_light ? 20.0f : 210.0f) - value);
      value += overlay.axis * (axis_colors[std::size_t(overlay.axis_number)][c] - value);
      rgb[c] = static_cast<unsigned char>(value + 0.5f);
    }
  }
}

}  // namespace lichtraum::view
