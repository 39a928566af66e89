#include "support/path_scenes.hpp"

#include <iterator>
#include <utility>

#include "support/esdf.hpp"
#include "support/path_scene_parts.hpp"
#include "support/pbr.hpp"

namespace lichtraum::test {
namespace {

/// A room whose lamps are a panel of two triangles, a ball, a disc and a point; matt and glossy.
PathScene room() {
  Scene scene = scene_of(things + R"(
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

}  // namespace

std::vector<PathScene> path_scenes() {
  std::vector<PathScene> scenes;
  scenes.push_back(room());
  for (auto const part : {material_scenes, lamp_scenes, wall_scenes, ground_scenes}) {
    std::vector<PathScene> more = part();
    std::move(more.begin(), more.end(), std::back_inserter(scenes));
  }
  return scenes;
}

}  // namespace lichtraum::test
