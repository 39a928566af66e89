// draw_ray_paths SCENE COLUMN...  > figure.svg
//
// Follows the camera rays through the given columns of the picture's middle row (0..1 from left to right) and draws
// them from above, with their shadow, mirror and glass rays. Made for scenes that lie in the plane y = 0; shapes are
// drawn as that plane cuts them.

#include <fmt/format.h>

#include <cmath>
#include <cstdlib>
#include <iostream>
#include <optional>
#include <string>

#include "lichtraum/esdf.hpp"

namespace {

using namespace lichtraum;

constexpr double pixels_per_unit = 72;
constexpr double left = -5.6, right = 5.6, back = -4.9, front = 7.6;  // the part of the world that is drawn, x and z
constexpr double far_away = 20;
constexpr int max_depth = 4;
constexpr double epsilon = 1e-6;

double svg_x(Vec3 const& p) { return (p.x - left) * pixels_per_unit; }
double svg_y(Vec3 const& p) { return (p.z - back) * pixels_per_unit; }

std::string css_color(Rgb const& color) {
  auto const percent = [](double c) { return int(std::lround(100 * std::min(1.0, c))); };
  return fmt::format("rgb({}%,{}%,{}%)", percent(color.x), percent(color.y), percent(color.z));
}

void draw_line(Vec3 const& from, Vec3 const& to, char const* kind) {
  std::cout << fmt::format("<line class='{}' x1='{:.1f}' y1='{:.1f}' x2='{:.1f}' y2='{:.1f}'/>\n", kind, svg_x(from),
                           svg_y(from), svg_x(to), svg_y(to));
}

void draw_text(Vec3 const& at, std::string const& text) {
  std::cout << fmt::format("<text x='{:.1f}' y='{:.1f}'>{}</text>\n", svg_x(at), svg_y(at), text);
}

std::string fill_of(Shape const& shape) {
  Rgb const color = shape.material()->is_opaque() ? shape.material()->kd() : Rgb(0.6, 0.85, 0.9);
  return fmt::format("class='shape' fill='{}' fill-opacity='0.75'", css_color(color));
}

void draw_circle(Sphere const& sphere) {
  Vec3 const center = sphere.world_from_object().point(sphere.center());
  std::cout << fmt::format("<circle {} cx='{:.1f}' cy='{:.1f}' r='{:.1f}'/>\n", fill_of(sphere), svg_x(center),
                           svg_y(center), sphere.radius() * pixels_per_unit);
  draw_text(center, sphere.name());
}

void draw_rectangle(Box const& box) {
  if (box.max().y < 0) return;  // below the plane: the floor
  Vec3 const low = box.min(), high = box.max();
  std::string points;
  for (Vec3 const& corner : {low, Vec3(high.x, 0, low.z), high, Vec3(low.x, 0, high.z)}) {
    Vec3 const p = box.world_from_object().point(corner);
    points += fmt::format("{:.1f},{:.1f} ", svg_x(p), svg_y(p));
  }
  std::cout << fmt::format("<polygon {} points='{}'/>\n", fill_of(box), points);
  bool const is_upright = high.z - low.z > high.x - low.x;  // on paper: its name goes beside it
  draw_text(box.world_from_object().point((low + high) / 2.0) + (is_upright ? Vec3(-0.7, 0, 0) : Vec3(0, 0, 0.12)),
            box.name());
}

/// Spheres and boxes: the scene has nothing else.
void draw_outline(Shape const& shape) {
  if (auto const* const sphere = dynamic_cast<Sphere const*>(&shape)) draw_circle(*sphere);
  if (auto const* const box = dynamic_cast<Box const*>(&shape)) draw_rectangle(*box);
  if (auto const* const composite = dynamic_cast<Composite const*>(&shape)) {
    for (auto const& child : composite->children()) draw_outline(*child);
  }
}

std::optional<Hit> find_closest(Scene const& scene, Ray const& ray, double t_max = INFINITY) {
  Hit hit;
  hit.t = t_max;
  bool found = false;
  for (auto const& root : scene.roots()) found |= root->closest_hit(ray, 0, hit);
  return found ? std::optional(hit) : std::nullopt;
}

void draw_shadow_rays(Scene const& scene, Vec3 const& point, Vec3 const& normal) {
  for (Light const& light : scene.lights) {
    if (!light.position() || glm::dot(normal, light.way_from(point)) <= 0) continue;
    Ray const ray{point + epsilon * normal, light.way_from(point)};
    auto const blocker = find_closest(scene, ray, 1);
    if (!blocker || !blocker->shape->material()->is_opaque()) {
      draw_line(point, *light.position(), "shadow");
    } else {
      draw_line(point, ray.at(blocker->t), "blocked");
      draw_line(ray.at(blocker->t), *light.position(), "unseen");
    }
  }
}

void draw_path(Scene const& scene, Ray const& ray, char const* kind, int depth) {
  auto const hit = find_closest(scene, ray);
  draw_line(ray.origin, ray.at(hit ? hit->t : far_away), kind);
  if (!hit) return;
  Material const& material = *hit->shape->material();
  bool const outside = glm::dot(hit->normal, ray.direction) < 0;
  Vec3 const point = ray.at(hit->t);
  Vec3 const normal = outside ? hit->normal : -hit->normal;
  double const cosine = -glm::dot(normal, ray.direction);
  if (material.reflect() + material.transmit() < 1) draw_shadow_rays(scene, point, normal);
  if (depth == max_depth) return;
  if (material.reflect() > 0.5) {
    draw_path(scene, {point + epsilon * normal, ray.direction + 2 * cosine * normal}, "mirrored", depth + 1);
  }
  double const eta = outside ? 1 / material.ior() : material.ior();
  double const square = 1 - eta * eta * (1 - cosine * cosine);
  if (material.transmit() > 0 && square >= 0) {
    Vec3 const refracted = eta * ray.direction + (eta * cosine - std::sqrt(square)) * normal;
    draw_path(scene, {point - epsilon * normal, refracted}, "refracted", depth + 1);
  }
}

void draw(Scene const& scene, int column_count, char** columns) {
  double const width = (right - left) * pixels_per_unit, height = (front - back) * pixels_per_unit;
  std::cout << fmt::format(
      "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 {:.0f} {:.0f}' font-family='sans-serif'>\n<style>"
      "line{{stroke-width:2.2}} .camera{{stroke:#222}} .shadow{{stroke:#e0a000}} .blocked{{stroke:#d02020}} "
      ".unseen{{stroke:#d02020;stroke-dasharray:3 7;stroke-width:1.4}} .mirrored{{stroke:#2060d0}} "
      ".refracted{{stroke:#109050}} .image{{stroke:#888;stroke-width:5}} .shape{{stroke:#444;stroke-width:1.2}} "
      "text{{font-size:19px;text-anchor:middle;fill:#111;paint-order:stroke;stroke:#fff;stroke-width:4px}} "
      ".key{{text-anchor:start}}</style>\n<rect width='100%' height='100%' fill='#fff'/>\n",
      width, height);
  for (auto const& root : scene.roots()) draw_outline(*root);

  Camera const& camera = scene.cameras.front();
  Resolution const size = camera.resolution().value_or(Resolution{960, 480});
  auto const image_point = [&](double column) {
    Ray const ray = camera.generate_ray(column * size.width, size.height / 2.0, size);
    return ray.at(1.2 / -ray.direction.z);
  };
  draw_line(image_point(0), image_point(1), "image");
  draw_text(image_point(1) + Vec3(0.75, 0, 0.1), "image");
  for (int i = 0; i < column_count; ++i) {
    Ray const ray = camera.generate_ray(std::atof(columns[i]) * size.width, size.height / 2.0, size);
    draw_path(scene, ray, "camera", 0);
  }
  Vec3 const eye = camera.world_from_camera().point(Vec3(0));
  std::cout << fmt::format("<circle cx='{:.1f}' cy='{:.1f}' r='7' fill='#222'/>\n", svg_x(eye), svg_y(eye));
  draw_text(eye + Vec3(0, 0, 0.4), "camera");
  for (Light const& light : scene.lights) {
    if (!light.position()) continue;
    std::cout << fmt::format("<circle cx='{:.1f}' cy='{:.1f}' r='11' fill='#ffc820' stroke='#a07000'/>\n",
                             svg_x(*light.position()), svg_y(*light.position()));
    draw_text(*light.position() + Vec3(0, 0, 0.45), light.name());
  }
  double y = height - 128;
  for (auto const& [kind, text] : {std::pair{"camera", "camera ray"},
                                   {"shadow", "shadow ray that arrives"},
                                   {"blocked", "shadow ray that is stopped"},
                                   {"mirrored", "mirror ray"},
                                   {"refracted", "refracted ray"}}) {
    std::cout << fmt::format(
        "<line class='{}' x1='24' y1='{}' x2='64' y2='{}'/><text class='key' x='76' y='{}'>{}</text>\n", kind, y, y,
        y + 6, text);
    y += 25;
  }
  std::cout << "</svg>\n";
}

}  // namespace

int main(int argc, char** argv) try {
  if (argc < 3) {
    std::cerr << "usage: draw_ray_paths SCENE COLUMN...\n";
    return 64;
  }
  draw(lichtraum::load_esdf(argv[1]), argc - 2, argv + 2);
} catch (std::exception const& error) {
  std::cerr << "draw_ray_paths: " << error.what() << '\n';
  return 70;
}
