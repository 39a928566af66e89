#include "support/path_scenes.hpp"

#include <cmath>
#include <memory>

#include "support/esdf.hpp"
#include "support/pbr.hpp"
#include "support/textured_meshes.hpp"

namespace lichtraum::test {
namespace {

void set_material(Scene& scene, char const* name, Material::Model const& model) {
  *(*scene.materials.find(name)) = Material(name, model);
}

void let_shine(Scene& scene, char const* name, Rgb const& emission) {
  PhongModel model = (*scene.materials.find(name))->phong();
  model.emission = emission;
  set_material(scene, name, model);
}

EnvironmentLight around(std::shared_ptr<EnvironmentMap const> map) { return {"made here", std::move(map), 0, 1}; }

/// A blue sky over brown ground, and a window of four texels that is some ten times as bright.
EnvironmentLight window_environment() {
  EnvironmentMap map{16, 8, {}};
  for (int row = 0; row < map.height; ++row) {
    for (int column = 0; column < map.width; ++column) {
      bool const is_window = row >= 2 && row < 4 && column >= 10 && column < 12;
      Rgb const color = is_window ? Rgb(9, 8, 6) : row < 4 ? Rgb(0.5, 0.7, 1.0) : Rgb(0.4, 0.3, 0.2);
      for (int c = 0; c < 3; ++c) map.radiance.push_back(float(color[c]));
    }
  }
  EnvironmentLight light = around(std::make_shared<EnvironmentMap const>(std::move(map)));
  light.rotation_degrees = 40;
  light.brightness = 0.8;
  return light;
}

constexpr char const* things = R"(
define material floor  0 0 0  0.6 0.5 0.4  0 0 0 1
define material a 0 0 0  0.5 0.5 0.5  0 0 0 1
define material b 0 0 0  0.5 0.5 0.5  0 0 0 1
define material c 0 0 0  0.5 0.5 0.5  0 0 0 1
define material d 0 0 0  0.5 0.5 0.5  0 0 0 1
define camera eye 45
transform eye rotate -15 1 0 0
transform eye translate 0 1.4 5
)";

std::string const four_balls = std::string(things) + R"(
define shape sphere a -1.1 0.8 0 0.75 a
define shape sphere b 1.1 0.8 0 0.75 b
define shape sphere c -1.1 -0.8 0.4 0.75 c
define shape sphere d 1.1 -0.8 0.4 0.75 d
)";

/// A room whose lamps are a panel of two triangles, a ball, a disc and a point; matt and glossy.
PathScene room() {
  Scene scene = scene_of(std::string(things) + R"(
define material panel 0 0 0  0.2 0.2 0.2  0 0 0 1
define shape box floor -3 -1.2 -4  3 -1 3 floor
define shape box left  -3 -1 -4  -2.8 3 3 a
define shape box back  -3 -1 -4.2  3 3 -4 floor
define shape sphere glossy 0.9 -0.2 0 0.8 b
define shape sphere matt -1 -0.3 -0.5 0.7 c
define shape sphere bulb 2 1.2 -1 0.5 d
define shape triangle panel1 -2 2.8 -2  2 2.8 -2  2 2.8 2 panel
define shape triangle panel2 -2 2.8 -2  2 2.8 2  -2 2.8 2 panel
define light diffuse key 1 2 3  0.3 0.3 0.25 radius=0.8
define light diffuse fill -2 1 3  0.1 0.1 0.2
define light ambient sky 0.1 0.15 0.2
define background 0.1 0.2 0.3
)");
  set_material(scene, "a", PhongModel{.kd = {0.7, 0.2, 0.1}});
  set_material(scene, "b", PhongModel{.kd = {0.2, 0.3, 0.4}, .ks = Rgb(0.5), .m = 20});
  let_shine(scene, "d", {1.5, 1.2, 0.9});
  let_shine(scene, "panel", {3, 3, 2.5});
  return {"room with lamps", std::move(scene), 4};
}

PathScene mirrors_and_glass() {
  Scene scene = scene_of(std::string(things) + R"(
define shape box floor -3 -1.2 -4  3 -1 3 floor
define shape sphere mirror -1 0 0 0.9 a
define shape sphere glass 1 0 0.3 0.9 b
define shape sphere lamp 0 1.5 -2 0.8 c
define shape box slab -0.4 -1 0.8  0.4 -0.4 1.2 d
define light ambient sky 0.3 0.4 0.5
define light diffuse key -4 5 5  0.4 0.4 0.4
define background 0.6 0.5 0.7
)");
  set_material(scene, "a", PhongModel{.kd = {0.5, 0.3, 0.2}, .reflect = 0.7});
  set_material(scene, "b", PhongModel{.kd = Rgb(0), .reflect = 0.1, .transmit = 0.85, .ior = 1.5});
  set_material(scene, "d", PhongModel{.kd = Rgb(0.2), .ks = Rgb(0.2), .m = 10, .transmit = 0.6, .ior = 1.3});
  let_shine(scene, "c", {2, 2, 1.6});
  return {"mirrors and glass", std::move(scene), 5};
}

/// The light of a lamp without a size that a small smooth plate throws on a wall: a blurred caustic.
PathScene caustic_of_plate() {
  Scene scene = scene_of(std::string(things) + R"(
define shape box floor -3 -1.2 -4  3 -1 3 floor
define shape box wall -3 -1 -4  3 3 -3.8 a
define shape box plate -0.7 -1 -2.4  0.7 -0.9 -0.8 b
define light diffuse key 0 1 1  1 1 1
)");
  set_material(scene, "b", pbr({0.9, 0.8, 0.6}, 1, 0));
  return {"caustic of a plate", std::move(scene), 3};
}

PathScene metal_and_rough(char const* name, EnvironmentLight const& environment) {
  Scene scene = scene_of(four_balls);
  set_material(scene, "a", pbr({0.9, 0.6, 0.3}, 1, 0.8));
  set_material(scene, "b", pbr({0.2, 0.5, 0.8}, 0, 0.6));
  PbrModel iridescent = pbr({0.8, 0.8, 0.8}, 0.5, 0.9);
  iridescent.iridescence = 0.9;
  iridescent.iridescence_ior = 1.6;
  iridescent.specular = 0.9;
  set_material(scene, "c", iridescent);
  PbrModel special = pbr({0.9, 0.9, 0.9}, 0, 0.7);
  special.ior = 1.8;
  special.specular = 0.8;
  special.specular_color = {1, 0.5, 0.2};
  set_material(scene, "d", special);
  scene.environment = environment;
  return {name, std::move(scene), 3, false, true};
}

PathScene rough_glass() {
  Scene scene = scene_of(four_balls + "define shape box back -3 -2 -2  3 3 -1.6 floor\n");
  // The less the index, or the roughness, the fewer are the directions that refraction prefers.
  PbrModel solid = pbr({1, 0.9, 0.8}, 0, 0.9);
  solid.transmission = 1;
  solid.thickness = 1;
  solid.ior = 2;
  solid.attenuation_color = {0.3, 0.7, 0.9};
  solid.attenuation_distance = 1.2;
  set_material(scene, "a", solid);
  solid.roughness = 1;
  solid.ior = 1.5;
  solid.transmission = 0.6;
  set_material(scene, "b", solid);
  solid.iridescence = 1;
  solid.iridescence_ior = 1.9;
  solid.ior = 1.8;
  solid.specular = 0.7;
  solid.transmission = 0.9;
  solid.attenuation_distance = 0.8;
  set_material(scene, "c", solid);
  PbrModel thin = pbr({0.5, 0.9, 0.6}, 0.2, 0.7);
  thin.transmission = 0.8;
  set_material(scene, "d", thin);
  scene.environment = around(uniform_environment(0.5f, 0.7f, 1));
  return {"rough glass", std::move(scene), 3};
}

/// Lamps within bodies that absorb: of one that bends no light, and of a rough one.
PathScene lamps_in_solids() {
  Scene scene = scene_of(std::string(things) + R"(
define shape box body  -2 -1.1 -1.5  0.8 1.6 1.5 a
define shape box table -1.8 -1 -1.3  0.6 -0.8 1.3 floor
define shape sphere matt -1.1 -0.3 0 0.45 b
define shape sphere bulb -0.2 0.7 0 0.35 d
define shape sphere rough 1.8 0.2 0 0.8 c
define shape sphere within 1.8 0.2 0 0.3 d
define light diffuse key -0.9 1.2 0.6  0.3 0.3 0.25 radius=0.2
define light ambient sky 0.1 0.15 0.2
)");
  PbrModel solid = pbr(Rgb(1), 0, 0);
  solid.transmission = 1;
  solid.thickness = 1;
  solid.ior = 1;
  solid.attenuation_color = {0.3, 0.5, 0.8};
  solid.attenuation_distance = 1;
  set_material(scene, "a", solid);
  solid.roughness = 0.9;
  solid.ior = 1.4;
  solid.attenuation_distance = 0.4;
  set_material(scene, "c", solid);
  let_shine(scene, "d", {3, 2.5, 2});
  return {"lamps in solids", std::move(scene), 4};
}

PathScene coats() {
  Scene scene = scene_of(four_balls + R"(
define light diffuse key -4 5 5  0.5 0.5 0.5
)");
  PbrModel coated = pbr({0.7, 0.2, 0.2}, 0, 0.8);
  coated.clearcoat = 1;
  coated.clearcoat_roughness = 0.5;
  set_material(scene, "a", coated);
  coated.metallic = 0.7;
  coated.clearcoat_roughness = 0.8;
  set_material(scene, "b", coated);
  coated.clearcoat = 0.4;
  coated.roughness = 0.5;
  set_material(scene, "c", coated);
  coated.metallic = 0;
  coated.transmission = 0.7;
  coated.roughness = 0.9;
  set_material(scene, "d", coated);
  scene.environment = window_environment();
  return {"coats", std::move(scene), 3, false, true};
}

/// Lamps of each kind that are looked for, below clear coats, some of which they are seen through at grazing angles.
PathScene coated_lamps() {
  Scene scene = scene_of(std::string(things) + R"(
define shape box floor -4 -1.2 -4  4 -1 3 floor
define shape triangle panel -2 -1 -0.5  -1.2 -1 1  -1.6 1.4 0.4 a
define shape sphere ball 0 0.1 0  1.1 b
define shape box tube 1.6 -1.2 -0.2  1.9 2 0 c
)");
  PbrModel lamp = pbr({0.5, 0.5, 0.5}, 0, 1);
  lamp.emissive = {6, 5, 4};
  lamp.double_sided = true;
  lamp.clearcoat = 0.9;
  lamp.clearcoat_roughness = 1;
  set_material(scene, "a", lamp);
  lamp.clearcoat = 1;
  set_material(scene, "b", lamp);
  set_material(scene, "c", lamp);
  scene.environment = around(uniform_environment(0.1f, 0.1f, 0.1f));
  return {"lamps below clear coats", std::move(scene), 3, true};
}

/// Without lights of no size: their images in it would be seen once in a million samples.
PathScene smooth() {
  Scene scene = scene_of(four_balls +
                         "define shape box back -3 -2 -2  3 3 -1.6 floor\n"
                         "define shape sphere enclosed -1.1 0.8 0 0.25 floor\n");
  PbrModel glass = pbr({0.9, 1, 1}, 0, 0);
  glass.transmission = 1;
  glass.thickness = 1;
  glass.ior = 1.33;
  glass.attenuation_color = {0.4, 0.5, 0.6};
  glass.attenuation_distance = 0.6;
  set_material(scene, "a", glass);
  glass.thickness = 0;
  set_material(scene, "b", glass);
  PbrModel coated = pbr({0.7, 0.2, 0.2}, 0.3, 0.9);
  coated.clearcoat = 0.8;
  set_material(scene, "c", coated);
  set_material(scene, "d", pbr({0.9, 0.8, 0.6}, 1, 0));
  scene.environment = window_environment();
  return {"smooth", std::move(scene), 4, false, true};
}

/// Triangles that shine, are half there, or have no back.
PathScene sheets() {
  Scene scene = scene_of(std::string(things) + R"(
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
  Scene scene = scene_of(std::string(things) + R"(
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

/// Rough thin walls, one behind the other, before things that are lit and shine, and the background.
Scene frosted_windows() {
  Scene scene = scene_of(std::string(things) + R"(
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

PathScene panes_on_ground() {
  Scene scene = things_behind_panes();
  scene.environment = window_environment();
  return {"panes on glossy ground", std::move(scene), 3, false, false, 1, Ground::glossy};
}

/// So many lamps that a tree chooses among them: two panels of tiles, of which one is stretched, and lights that fall
/// off; over what is matt, glossy (more than its kd leaves) or lets light through.
PathScene many_lamps() {
  std::string text = std::string(things) + R"(
define material tile 0 0 0  0.2 0.2 0.2  0 0 0 1
define shape plane floor 0 -1 0  0 1 0 floor
define shape sphere ball 1.2 -0.3 0 0.7 b
define shape box crate -1.8 -1 -1  -1 0.2 0 a
define shape triangle sheet -1 -1 0.6  0.6 -1 0.9  -0.2 0.6 0.7 c
)";
  std::string tiles;
  for (int i = 0; i < 25; ++i) {
    double const x = -1 + 0.4 * (i % 5), z = -1 + 0.4 * (i / 5);
    char const* const material = i % 3 == 0 ? "d" : "tile";
    for (char const half : {'a', 'b'}) {
      std::string const name = "tile" + std::to_string(i) + half;
      double const corner_x = half == 'a' ? x + 0.4 : x, corner_z = half == 'a' ? z : z + 0.4;
      text += "define shape triangle " + name + ' ' + std::to_string(x) + " 0 " + std::to_string(z) + "  " +
              std::to_string(corner_x) + " 0 " + std::to_string(corner_z) + "  " + std::to_string(x + 0.4) + " 0 " +
              std::to_string(z + 0.4) + ' ' + material + '\n';
      tiles += ' ' + name;
    }
  }
  text += "define shape composite panel" + tiles + R"(
define shape composite above panel
define shape composite beside panel
transform above scale 1.5 1 0.8
transform above translate -0.3 1.9 0
transform beside rotate 90 0 0 1
transform beside translate 2.4 0.2 -0.6
define shape composite root floor ball crate sheet above beside
define light ambient sky 0.02 0.03 0.04
define background 0.1 0.2 0.3
)";
  Scene scene = scene_of(text);
  for (int i = 0; i < 4; ++i) {
    scene.lights.insert(
        Light::falling_off("spark" + std::to_string(i), Vec3(-1.5 + i, 0.6, 0.8 - 0.4 * i), Rgb(0.08, 0.05, 0.02 * i)));
  }
  set_material(scene, "a", PhongModel{.kd = {0.8, 0.3, 0.1}});
  set_material(scene, "b", PhongModel{.kd = {0.2, 0.3, 0.4}, .ks = Rgb(0.9), .m = 20});
  PbrModel sheet = pbr({0.8, 0.7, 0.4}, 0, 0.9);
  sheet.transmission = 0.6;
  sheet.double_sided = true;
  set_material(scene, "c", sheet);
  let_shine(scene, "d", {4, 3.5, 3});
  let_shine(scene, "tile", {0.5, 0.7, 1});
  return {"many lamps", std::move(scene), 4};
}

/// A lamp that hardly matters beside a sky that is unlit, so that nobody looks for it, and a light that is as bright
/// anywhere; on the ball's far side the lamp does not matter at all.
PathScene lamp_under_unlit_sky() {
  Scene scene = scene_of(std::string(things) + R"(
define shape sphere sky 0 0 0 12 a
define shape plane floor 0 -1 0  0 1 0 floor
define shape sphere ball 0.4 0 0 1 b
define shape triangle lamp -2 -0.6 0.5  -2 0.6 0.5  -2 0 -0.7 d
define light diffuse key 3 5 4  0.2 0.2 0.15
)");
  PbrModel sky = pbr({0.4, 0.6, 0.9}, 0, 1);
  sky.unlit = true;
  sky.double_sided = true;
  set_material(scene, "a", sky);
  let_shine(scene, "d", {6, 3, 2});
  return {"lamp under an unlit sky", std::move(scene), 3};
}

/// Lamps that are found by their directions: a stretched ball and a block, twice each and turned, a ball that touches
/// what it lights and a flat panel; all within a ball that shines as well.
PathScene round_and_square_lamps() {
  Scene scene = scene_of(std::string(things) + R"(
define material dim 0 0 0  0.3 0.3 0.3  0 0 0 1
define shape box floor -3 -1.2 -4  3 -1 3 floor
define shape sphere glossy 0 -0.4 0.6 0.6 b
define shape sphere touching -1.9 -0.5 0.6 0.5 d
define shape box panel -0.6 2.4 -1  1.2 2.4 1 d
define shape sphere egg 0 0 0 0.5 c
transform egg scale 0.6 1.6 1
transform egg rotate 30 0 0 1
transform egg translate -1.4 0.9 -0.6
define shape box block -0.3 -0.5 -0.2  0.3 0.5 0.6 c
transform block rotate 35 1 0 1
define shape composite pair egg block
define shape composite here pair
define shape composite there pair
transform there scale 0.9 1.1 -0.8
transform there rotate 100 0 1 0
transform there translate 1.9 0.3 -0.8
define shape sphere around 0 0 0 12 dim
define shape composite root floor glossy touching panel here there around
)");
  set_material(scene, "b", PhongModel{.kd = {0.2, 0.3, 0.4}, .ks = Rgb(0.5), .m = 20});
  let_shine(scene, "c", {1.5, 2, 2.5});
  let_shine(scene, "d", {3, 2.4, 1.8});
  let_shine(scene, "dim", {0.2, 0.25, 0.3});
  return {"round and square lamps", std::move(scene), 4};
}

/// What stands, lies and hangs over a ground, with lamps and lights of its own; one of these is under a veil.
Scene still_life() {
  Scene scene = scene_of(std::string(things) + R"(
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

/// What textures and vertices do to materials, under the lights of glTF.
PathScene textures() {
  Scene scene = make_textured_scene();
  PbrModel clear = *(*scene.materials.find("clear"))->pbr();
  clear.roughness = 0.8;  // sharper refraction is too improbable
  set_material(scene, "clear", clear);
  PbrModel full = *(*scene.materials.find("full"))->pbr();
  full.iridescence = 0.9;
  full.iridescence_ior = 1.7;
  full.iridescence_thickness_minimum = 600;  // more than the maximum is allowed
  full.iridescence_texture = full.iridescence_thickness_texture = full.specular_texture;
  set_material(scene, "full", full);
  scene.environment = window_environment();
  return {"textured meshes", std::move(scene), 3, false, false, 8};
}

}  // namespace

std::vector<PathScene> path_scenes() {
  std::vector<PathScene> scenes;
  scenes.push_back(room());
  scenes.push_back(mirrors_and_glass());
  scenes.push_back(caustic_of_plate());
  scenes.push_back(metal_and_rough("metal and rough, uniform environment", around(uniform_environment(0.8f, 0.9f, 1))));
  scenes.push_back(metal_and_rough("metal and rough, window", window_environment()));
  scenes.push_back(rough_glass());
  scenes.push_back(lamps_in_solids());
  scenes.push_back(coats());
  scenes.push_back(coated_lamps());
  scenes.push_back(smooth());
  scenes.push_back(sheets());
  scenes.push_back(panes());
  scenes.push_back(panes_in_the_open());
  scenes.push_back(panes_on_ground());
  scenes.push_back(windows());
  scenes.push_back(windows_seen_through());
  scenes.push_back(many_lamps());
  scenes.push_back(lamp_under_unlit_sky());
  scenes.push_back(round_and_square_lamps());
  scenes.push_back(textures());
  scenes.push_back(on_ground_in_the_open());
  scenes.push_back(on_sloping_ground());
  scenes.push_back(on_ground_seen_through());
  return scenes;
}

}  // namespace lichtraum::test
