/// Grounds.

#include "support/path_scene_parts.hpp"

#include <utility>

#include "support/esdf.hpp"
#include "support/pbr.hpp"

namespace lichtraum::test {
namespace {

/// What stands, lies and hangs over a ground, with lamps and lights of its own; one of these is under a veil.
Scene still_life() {
  Scene scene = scene_of(things + R"(
define shape box crate -1.4 -1 -0.6  -0.4 0.3 0.4 a
define shape sphere ball 0.9 -0.3 0 0.7 b
define shape triangle lamp 0 0.2 1  0.6 0.2 1  0.3 0.7 1.2 c
define shape triangle veil -0.6 -0.9 1.2  0.4 -0.9 1.4  0 0.4 1.2 d
define light diffuse key -3 4 3  0.5 0.4 0.4
define light diffuse below 0 -5 0  0.5 0.5 0.5
define light ambient sky 0.3 0.4 0.5
define background 0.5 0.4 0.3
)");
  set_material(scene, "a", PhongModel{.kd = {0.8, 0.3, 0.1}});
  set_material(scene, "b", PhongModel{.kd = {0.2, 0.3, 0.4}, .ks = Rgb(0.4), .m = 20});
  PbrModel lamp = pbr({0.5, 0.5, 0.5}, 0, 1);
  lamp.emissive = {3, 4, 5};
  lamp.double_sided = true;
  set_material(scene, "c", lamp);
  PbrModel veil = pbr({0.8, 0.4, 0.3}, 0, 0.9);
  veil.alpha = 0.6;
  veil.alpha_mode = AlphaMode::blend;
  veil.double_sided = true;
  set_material(scene, "d", veil);
  return scene;
}

PathScene on_ground_in_the_open() {
  Scene scene = still_life();
  scene.environment = window_environment();
  return {"on the ground, in the open", std::move(scene), 3, false, false, 1, Ground::matt};
}

/// Where neither the ground nor the environment lies along an axis.
PathScene on_sloping_ground() {
  Scene scene = still_life();
  scene.environment = window_environment();
  scene.up = {-0.4, 0.8, 0.45};
  return {"on the ground, up being elsewhere", std::move(scene), 3, false, false, 1, Ground::matt};
}

PathScene on_ground_seen_through() {
  return {"on the ground, seen through", still_life(), 3, true, false, 1, Ground::matt};
}

}  // namespace

std::vector<PathScene> ground_scenes() {
  std::vector<PathScene> scenes;
  scenes.push_back(on_ground_in_the_open());
  scenes.push_back(on_sloping_ground());
  scenes.push_back(on_ground_seen_through());
  return scenes;
}

}  // namespace lichtraum::test
