#include "reference/integrator.hpp"

#include <cmath>

#include "support/catch.hpp"

using namespace lichtraum;

namespace {

std::shared_ptr<Material> matt(Rgb const& kd) { return std::make_shared<Material>("matt", Rgb(0), kd, Rgb(0), 1); }

std::shared_ptr<Material> glossy(Rgb const& ks, double m) {
  return std::make_shared<Material>("glossy", Rgb(0), Rgb(0), ks, m);
}

std::shared_ptr<Material> optical(double reflect, double transmit, double ior) {
  return std::make_shared<Material>(
      "optical", PhongModel{.ka = Rgb(0), .kd = Rgb(0), .reflect = reflect, .transmit = transmit, .ior = ior});
}

/// A square of side 20 in the plane z = `z` whose winding points to +z.
void add_square(ReferenceScene& scene, double z, std::shared_ptr<Material> const& material) {
  Vec3 const a(-10, -10, z), b(10, -10, z), c(10, 10, z), d(-10, 10, z);
  scene.roots.push_back(std::make_shared<Triangle>("lower", a, b, c, material));
  scene.roots.push_back(std::make_shared<Triangle>("upper", a, c, d, material));
}

void add_light(ReferenceScene& scene, Vec3 const& position, Rgb const& ld) {
  scene.lights.push_back(Light::point("light", position, ld));
}

struct Traced {
  Rgb radiance;
  RayCounts counts;
};

Traced trace(ReferenceScene const& scene, Vec3 const& origin, Vec3 const& direction, int max_depth = 5) {
  Traced result;
  result.radiance =
      trace_radiance(scene, {origin, glm::normalize(direction)}, scene.background, max_depth, result.counts);
  return result;
}

void check_rgb(Rgb const& actual, Rgb const& expected) {
  INFO("radiance " << actual.r << ' ' << actual.g << ' ' << actual.b << ", expected " << expected.r << ' ' << expected.g
                   << ' ' << expected.b);
  CHECK(glm::length(actual - expected) < 1e-12);
}

}  // namespace

TEST_CASE("a ray that misses everything sees the background", "[unit][integrator]") {
  ReferenceScene scene;
  scene.background = {0.1, 0.2, 0.3};
  auto const [radiance, counts] = trace(scene, {0, 0, 5}, {0, 0, -1});
  check_rgb(radiance, {0.1, 0.2, 0.3});
  CHECK(counts.camera == 1);
  CHECK(counts.camera_hits == 0);
  CHECK(counts.total() == 1);
}

TEST_CASE("Phong's terms at normal incidence add up", "[unit][integrator]") {
  ReferenceScene scene;
  scene.ambient = {0.5, 0.5, 1};
  add_square(scene, 0, std::make_shared<Material>("m", Rgb(0.2, 0.4, 0.6), Rgb(0.3, 0.2, 0.1), Rgb(0.5), 20));
  add_light(scene, {0, 0, 7}, {1, 2, 3});
  // n = l = r = v: every cosine is 1, whatever the distance.
  auto const [radiance, counts] = trace(scene, {0, 0, 5}, {0, 0, -1});
  check_rgb(radiance, Rgb(0.1, 0.2, 0.6) + Rgb(0.3, 0.4, 0.3) + 0.5 * Rgb(1, 2, 3));
  CHECK(counts.camera_hits == 1);
  CHECK(counts.shadow == 1);
  CHECK(counts.secondary == 0);
}

TEST_CASE("diffuse and specular terms follow their angles", "[unit][integrator]") {
  // Light at 60 degrees from the normal, viewer straight above: n.l = 1/2, r.v = 1/2.
  Vec3 const light(std::sqrt(3.0), 0, 1);
  ReferenceScene diffuse;
  add_square(diffuse, 0, matt(Rgb(1, 0.5, 0)));
  add_light(diffuse, light, Rgb(1));
  check_rgb(trace(diffuse, {0, 0, 5}, {0, 0, -1}).radiance, {0.5, 0.25, 0});

  ReferenceScene specular;
  add_square(specular, 0, glossy(Rgb(1), 3));
  add_light(specular, light, Rgb(2));
  check_rgb(trace(specular, {0, 0, 5}, {0, 0, -1}).radiance, Rgb(2 * 0.125));
}

TEST_CASE("m = 0 makes the specular term constant, also where r.v is negative", "[unit][integrator]") {
  ReferenceScene scene;
  add_square(scene, 0, glossy(Rgb(0.25), 0));
  add_light(scene, {5, 0, 1}, Rgb(1));
  // Viewed from the light's own side at a flat angle, r points away from the viewer.
  check_rgb(trace(scene, {5, 0, 1}, {-5, 0, -1}).radiance, Rgb(0.25));
}

TEST_CASE("no light reaches the side turned away from it", "[unit][integrator]") {
  ReferenceScene scene;
  add_square(scene, 0, std::make_shared<Material>("m", Rgb(0), Rgb(1), Rgb(1), 0));
  add_light(scene, {0, 0, -3}, Rgb(1));
  auto const [radiance, counts] = trace(scene, {0, 0, 5}, {0, 0, -1});
  check_rgb(radiance, Rgb(0));
  CHECK(counts.shadow == 0);
}

TEST_CASE("a triangle is lit on both sides", "[unit][integrator]") {
  ReferenceScene scene;
  add_square(scene, 0, matt(Rgb(1)));
  add_light(scene, {0, 0, 3}, {1, 0, 0});
  add_light(scene, {0, 0, -3}, {0, 1, 0});
  check_rgb(trace(scene, {1, 0, 4}, {-1, 0, -4}).radiance, {1, 0, 0});
  check_rgb(trace(scene, {1, 0, -4}, {-1, 0, 4}).radiance, {0, 1, 0});
}

TEST_CASE("what stands strictly between a point and a light casts a shadow", "[unit][integrator]") {
  auto const seen_with_screen_at = [](double z) {
    ReferenceScene scene;
    add_square(scene, 0, matt(Rgb(1)));
    scene.roots.push_back(std::make_shared<Sphere>("screen", Vec3(2, 0, z), 0.5, matt(Rgb(1))));
    add_light(scene, {4, 0, 4}, Rgb(1));
    return trace(scene, {0, 0, 5}, {0, 0, -1}).radiance.r;
  };
  double const lit = std::sqrt(0.5);
  CHECK(seen_with_screen_at(2) == 0);                   // on the way
  CHECK(seen_with_screen_at(2 + 0.71) == Approx(lit));  // just beside it: 0.502 off
  CHECK(seen_with_screen_at(2 - 0.70) == 0);            // just on it: 0.495 off
  ReferenceScene behind;
  add_square(behind, 0, matt(Rgb(1)));
  add_square(behind, 5, matt(Rgb(1)));  // beyond the light
  add_light(behind, {0, 0, 4}, Rgb(1));
  check_rgb(trace(behind, {0.5, 0, 3}, {-0.5, 0, -3}).radiance, Rgb(1));
  ReferenceScene touching;
  add_square(touching, 0, matt(Rgb(1)));
  add_square(touching, 4, matt(Rgb(1)));  // the light lies on it: not strictly before it
  add_light(touching, {0, 0, 4}, Rgb(1));
  check_rgb(trace(touching, {0.5, 0, 3}, {-0.5, 0, -3}).radiance, Rgb(1));
}

TEST_CASE("glass lets the product of its surfaces' transmit through to a shadowed point", "[unit][integrator]") {
  ReferenceScene scene;
  add_square(scene, 0, matt(Rgb(1)));
  scene.roots.push_back(std::make_shared<Box>("pane", Vec3(-1, -1, 2), Vec3(1, 1, 3), optical(0, 0.5, 1.5)));
  scene.roots.push_back(std::make_shared<Sphere>("ball", Vec3(0, 0, 5), 1, optical(0, 0.8, 1.5)));
  add_light(scene, {0, 0, 10}, Rgb(1));
  check_rgb(trace(scene, {3, 0, 1}, {-3, 0, -1}).radiance, Rgb(0.5 * 0.5 * 0.8 * 0.8));
}

TEST_CASE("a mirror shows the background, dimmed, and keeps its own highlight", "[unit][integrator]") {
  ReferenceScene scene;
  scene.background = {0.2, 0.4, 0.8};
  scene.ambient = Rgb(1);
  auto const material = std::make_shared<Material>(
      "mirror", PhongModel{.ka = Rgb(0.5), .kd = Rgb(0), .ks = Rgb(0.25), .m = 10, .reflect = 0.75});
  add_square(scene, 0, material);
  add_light(scene, {0, 0, 9}, Rgb(1));
  auto const [radiance, counts] = trace(scene, {0, 0, 5}, {0, 0, -1});
  check_rgb(radiance, 0.25 * Rgb(0.5) + Rgb(0.25) + 0.75 * scene.background);
  CHECK(counts.secondary == 1);
}

TEST_CASE("a slab of glass is crossed straight, and shifts what is behind it by Snell's law", "[unit][integrator]") {
  // Behind the slab only a thin strip shines, where the shifted ray must arrive.
  double const ior = 1.5, thickness = 2;
  double const sine = std::sin(0.7), inner_sine = sine / ior;
  double const inside = thickness * inner_sine / std::sqrt(1 - inner_sine * inner_sine);
  double const outside = 1 * std::tan(0.7);  // from z = 2 to 3 above, and from 0 to -1 below: the slab is 0 <= z <= 2
  ReferenceScene scene;
  scene.ambient = Rgb(1);
  scene.roots.push_back(
      std::make_shared<Box>("slab", Vec3(-10, -10, 0), Vec3(10, 10, thickness), optical(0.1, 0.9, ior)));
  double const arrival = outside + inside + outside;
  auto const strip = std::make_shared<Material>("strip", Rgb(1), Rgb(0), Rgb(0), 1);
  scene.roots.push_back(
      std::make_shared<Box>("strip", Vec3(arrival - 1e-6, -1, -1), Vec3(arrival + 1e-6, 1, -1), strip));
  Vec3 const direction(std::sin(0.7), 0, -std::cos(0.7));
  // Straight through: 0.9 at either face. The mirrored shares leave upwards, or come down again beside the strip.
  check_rgb(trace(scene, {0, 0, 3}, direction, 2).radiance, Rgb(0.81));
  check_rgb(trace(scene, {1e-3, 0, 3}, direction, 2).radiance, Rgb(0));
}

TEST_CASE("an index of refraction of 1 bends nothing", "[unit][integrator]") {
  ReferenceScene scene;
  scene.background = Rgb(1);
  scene.roots.push_back(std::make_shared<Sphere>("ball", Vec3(0), 1, optical(0, 1, 1)));
  auto const [radiance, counts] = trace(scene, {0.3, 0.2, 5}, {0, 0, -1});
  check_rgb(radiance, Rgb(1));
  CHECK(counts.secondary == 2);
}

TEST_CASE("beyond the critical angle the transmitted share is mirrored", "[unit][integrator]") {
  // Inside glass of 1.5 under its flat face z = 0; the critical angle is 41.8 degrees.
  ReferenceScene scene;
  scene.ambient = Rgb(1);
  add_square(scene, 0, optical(0, 1, 1.5));  // the outside is above
  auto const floor = std::make_shared<Material>("floor", Rgb(1, 0, 0), Rgb(0), Rgb(0), 1);
  auto const ceiling = std::make_shared<Material>("ceiling", Rgb(0, 0, 1), Rgb(0), Rgb(0), 1);
  scene.roots.push_back(std::make_shared<Box>("floor", Vec3(-50, -50, -2), Vec3(50, 50, -2), floor));
  scene.roots.push_back(std::make_shared<Box>("ceiling", Vec3(-50, -50, 2), Vec3(50, 50, 2), ceiling));
  auto const below_at = [&](double degrees) {
    double const angle = degrees * M_PI / 180;
    return trace(scene, {0, 0, -1}, {std::sin(angle), 0, std::cos(angle)}).radiance;
  };
  check_rgb(below_at(41), {0, 0, 1});
  check_rgb(below_at(42.5), {1, 0, 0});
}

TEST_CASE("the depth limits how many mirrors follow one another", "[unit][integrator]") {
  // Two mirrors face each other; each shows an ambient of 0.5 * 0.5 and half of what it sees.
  ReferenceScene scene;
  scene.ambient = Rgb(0.5);
  auto const material = std::make_shared<Material>("mirror", PhongModel{.ka = Rgb(1), .kd = Rgb(0), .reflect = 0.5});
  add_square(scene, 0, material);
  add_square(scene, 10, material);
  for (int depth = 0; depth <= 12; ++depth) {
    auto const [radiance, counts] = trace(scene, {0, 0, 5}, {0, 0, -1}, depth);
    // Rays of weight below 1/1024 are dropped: the eleventh.
    int const mirrors = std::min(depth, 10);
    check_rgb(radiance, Rgb(0.25 * (2 - std::pow(0.5, mirrors))));
    CHECK(counts.secondary == std::uint64_t(mirrors));
  }
}

TEST_CASE("no surface shadows itself or lets light through, at any scale and place", "[unit][integrator]") {
  double const scale = GENERATE(1e-3, 1.0, 1e6);
  double const distance = GENERATE(0.0, 1e3);  // of the scene from the origin, in its own sizes
  auto const place = Transform::translation(Vec3(distance * scale)) * Transform::scaling(Vec3(scale));
  auto const ball = std::make_shared<Sphere>("ball", Vec3(0, 1, 0), 1, matt(Rgb(1)));
  auto const ground = std::make_shared<Sphere>("ground", Vec3(0, -1000, 0), 1000, matt(Rgb(1)));
  auto const box = std::make_shared<Box>("box", Vec3(1.5, 0, -1), Vec3(3, 1, 1), matt(Rgb(1)));
  auto const group = std::make_shared<Composite>("group", Composite::Children{ball, ground, box});
  group->set_world_from_object(place);
  ReferenceScene scene;
  scene.roots.push_back(group);
  add_light(scene, place.point({2, 10, 5}), Rgb(1));
  Vec3 const light(2, 10, 5), eye(0.5, 3, 8);
  int lit = 0;
  for (int i = 0; i < 60; ++i) {
    for (int j = 0; j < 60; ++j) {
      Vec3 const direction((i - 30) / 60.0, (j - 30) / 60.0 - 0.3, -1);
      Traced const traced = trace(scene, place.point(eye), place.vector(direction));
      // The same in the scene's own frame, from which side the light comes decides, unless another shape is in between.
      Hit hit;
      for (Shape const* shape : {static_cast<Shape const*>(ball.get()), static_cast<Shape const*>(ground.get()),
                                 static_cast<Shape const*>(box.get())}) {
        shape->closest_hit({eye, direction}, 0, hit);
      }
      if (!hit.shape) continue;
      Vec3 const p = eye + hit.t * direction;
      bool shadowed = false;
      for (Shape const* shape : {static_cast<Shape const*>(ball.get()), static_cast<Shape const*>(ground.get()),
                                 static_cast<Shape const*>(box.get())}) {
        Hit other;
        other.t = 1;
        shadowed |= shape != hit.shape && shape->closest_hit({p, light - p}, 0, other);
      }
      double const cosine = std::max(0.0, glm::dot(hit.normal, glm::normalize(light - p)));
      double const expected = shadowed ? 0 : cosine;
      INFO("scale " << scale << ", distance " << distance << ", ray " << i << ' ' << j);
      REQUIRE(std::abs(traced.radiance.r - expected) < 1e-6);
      lit += expected > 0;
    }
  }
  CHECK(lit > 500);
}
