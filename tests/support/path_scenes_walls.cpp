/// Thin walls: what blends, panes, and rough windows.

#include "support/path_scene_parts.hpp"

#include <utility>

#include "support/esdf.hpp"
#include "support/pbr.hpp"

namespace lichtraum::test {
namespace {

/// Triangles that shine, are half there, or have no back.
PathScene sheets() {
  Scene scene = scene_of(things + R"(
define shape plane floor 0 -1 0  0 1 0 floor
define shape triangle veil1 -2 -1 0.5  0 -1 0.5  -1 1.5 0.5 a
define shape triangle veil2 -1.5 -1 0.9  0.5 -1 0.9  -0.5 1 0.9 a
define shape triangle back 0.2 -0.8 0  1.2 1.4 0  2.2 -0.8 0 b
define shape triangle lamp -1 1.8 -1  1.5 1.8 -2  0 2.4 1 c
define shape triangle glowing_veil 0.4 0.2 1  1.8 0.2 1  1 1.3 1.4 d
define shape sphere bead 0.2 0.4 1.6 0.3 a
define light diffuse key 2 4 4  0.4 0.4 0.4
)");
  PbrModel veil = pbr({0.8, 0.4, 0.3}, 0, 0.9);
  veil.alpha = 0.6;
  veil.alpha_mode = AlphaMode::blend;
  veil.double_sided = true;
  set_material(scene, "a", veil);
  set_material(scene, "b", pbr({0.2, 0.6, 0.3}, 0, 0.9));
  PbrModel lamp = pbr({0.5, 0.5, 0.5}, 0, 1);
  lamp.emissive = {6, 5, 4};
  lamp.double_sided = true;
  set_material(scene, "c", lamp);
  veil.alpha = 0.5;
  veil.emissive = {0.4, 1.2, 2};
  set_material(scene, "d", veil);
  scene.environment = around(uniform_environment(0.2f, 0.25f, 0.3f));
  return {"sheets that shine and blend", std::move(scene), 4, true};
}

/// Panes before lamps, lights and sky, and one behind the other: tinted, half transparent, metal in part, in an
/// instance that is stretched, and of eSDF's glass that does not refract, as a sheet and as bodies.
Scene things_behind_panes() {
  Scene scene = scene_of(things + R"(
define material eye_glass 0 0 0  0.4 0.2 0.1  0.1 0.1 0.1  20 reflect=0.1 transmit=0.6
define material bubble 0 0 0  0 0 0  0 0 0  1 transmit=0.7
define material lamp 0 0 0  0 0 0  0 0 0  1
define shape box floor -4 -1.2 -4  4 -1 3 floor
define shape sphere ball -0.6 -0.5 -0.4 0.5 floor
define shape triangle tinted1 -2.6 -1 0.9  0.4 -1 0.9  0.4 2 0.9 a
define shape triangle tinted2 -2.6 -1 0.9  0.4 2 0.9  -2.6 2 0.9 a
define shape triangle veil -0.5 -0.8 0.2  1.6 -1 0.5  0.6 1.6 0.3 b
define shape triangle partly -1 -1 0  1 -1 0  0 1 0 c
define shape composite group partly
transform group rotate 70 1 0 0
transform group scale 1.6 0.7 1.3
transform group translate 0.3 1.2 -0.5
define shape sphere bubble 1.5 -0.4 0.2 0.5 bubble
define shape box case 1 -1 -1.4  1.8 -0.2 -0.7 eye_glass
define shape triangle sheet -2 0.9 -2  2 0.9 -2  0 0.9 1 eye_glass
define shape triangle lamp -0.5 2.2 -1  0.7 2.2 -1  0 2.2 0.4 lamp
define shape composite root floor ball tinted1 tinted2 veil group bubble case sheet lamp
define light diffuse key -2 3 4  0.4 0.4 0.4
define light diffuse back 2 3 -3  0.3 0.2 0.3
define light ambient sky 0.2 0.3 0.4
define background 0.5 0.3 0.2
)");
  PbrModel pane = pbr({0.9, 0.5, 0.3}, 0, 0);
  pane.transmission = 1;
  set_material(scene, "a", pane);
  pane.base_color = {0.6, 0.8, 0.9};
  pane.transmission = 0.8;
  pane.alpha = 0.7;
  pane.alpha_mode = AlphaMode::blend;
  set_material(scene, "b", pane);
  pane = pbr({0.4, 0.9, 0.5}, 0.2, 0.02);
  pane.transmission = 0.7;
  pane.ior = 1.8;
  pane.specular_color = {1, 0.4, 0.2};
  set_material(scene, "c", pane);
  let_shine(scene, "lamp", {5, 4, 3});
  return scene;
}

PathScene panes() { return {"panes", things_behind_panes(), 3, true}; }

PathScene panes_in_the_open() {
  Scene scene = things_behind_panes();
  scene.environment = window_environment();
  return {"panes, in the open", std::move(scene), 3, false, true};
}

PathScene panes_on_ground() {
  Scene scene = things_behind_panes();
  scene.environment = window_environment();
  return {"panes on glossy ground", std::move(scene), 3, false, false, 1, Ground::glossy};
}

/// Rough thin walls, one behind the other, before things that are lit and shine, and the background.
Scene frosted_windows() {
  Scene scene = scene_of(things + R"(
define shape sphere ball 0.7 -0.2 -0.5 0.6 floor
define shape triangle rough -1.8 -1 1  1.8 -1 1  -1.8 1.8 1 a
define shape triangle tinted -1.8 -0.8 0  0.6 -0.8 0  -0.6 1.8 0.3 b
define shape triangle coated 0.2 0.4 0.6  1.8 0.4 0.6  1 1.8 0.4 c
define shape triangle lamp -1 0 -1  -0.2 0 -1  -0.6 0.7 -1 d
define light diffuse key -2 3 4  0.4 0.4 0.4
define background 0.5 0.3 0.2
)");
  PbrModel window = pbr({0.9, 0.9, 0.9}, 0, 0.8);
  window.transmission = 0.9;
  window.double_sided = true;
  set_material(scene, "a", window);
  window.base_color = {0.6, 0.8, 0.9};
  window.roughness = 0.9;
  set_material(scene, "b", window);
  window.roughness = 0;
  window.clearcoat = 0.5;
  window.clearcoat_roughness = 0.9;
  set_material(scene, "c", window);
  let_shine(scene, "d", {3, 4, 5});
  scene.environment = window_environment();
  return scene;
}

PathScene windows() { return {"frosted windows", frosted_windows(), 4}; }

PathScene windows_seen_through() { return {"frosted windows, seen through", frosted_windows(), 4, true}; }

}  // namespace

std::vector<PathScene> wall_scenes() {
  std::vector<PathScene> scenes;
  scenes.push_back(sheets());
  scenes.push_back(panes());
  scenes.push_back(panes_in_the_open());
  scenes.push_back(panes_on_ground());
  scenes.push_back(windows());
  scenes.push_back(windows_seen_through());
  return scenes;
}

}  // namespace lichtraum::test
