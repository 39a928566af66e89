/// What shines: surfaces, and lights without a size.

#include "support/path_scene_parts.hpp"

#include <cmath>
#include <utility>

#include "support/esdf.hpp"
#include "support/pbr.hpp"

namespace lichtraum::test {
namespace {

/// The light of a lamp without a size that a small smooth plate throws on a wall: a blurred caustic.
PathScene caustic_of_plate() {
  Scene scene = scene_of(things + R"(
define shape box floor -3 -1.2 -4  3 -1 3 floor
define shape box wall -3 -1 -4  3 3 -3.8 a
define shape box plate -0.7 -1 -2.4  0.7 -0.9 -0.8 b
define light diffuse key 0 1 1  1 1 1
)");
  set_material(scene, "b", pbr({0.9, 0.8, 0.6}, 1, 0));
  return {"caustic of a plate", std::move(scene), 3};
}

/// Lamps within bodies that absorb: of one that bends no light, and of a rough one.
PathScene lamps_in_solids() {
  Scene scene = scene_of(things + R"(
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

/// Lamps of each kind that are looked for, below clear coats, some of which they are seen through at grazing angles.
PathScene coated_lamps() {
  Scene scene = scene_of(things + R"(
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

/// So many lamps that a tree chooses among them: two panels of tiles, of which one is stretched, and lights that fall
/// off; over what is matt, glossy (more than its kd leaves) or lets light through.
PathScene many_lamps() {
  std::string text = things + R"(
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
  Scene scene = scene_of(things + R"(
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
  Scene scene = scene_of(things + R"(
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

}  // namespace

std::vector<PathScene> lamp_scenes() {
  std::vector<PathScene> scenes;
  scenes.push_back(caustic_of_plate());
  scenes.push_back(lamps_in_solids());
  scenes.push_back(coated_lamps());
  scenes.push_back(many_lamps());
  scenes.push_back(lamp_under_unlit_sky());
  scenes.push_back(round_and_square_lamps());
  return scenes;
}

}  // namespace lichtraum::test
