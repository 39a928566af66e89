#include "support/path_scene_parts.hpp"

#include <utility>

#include "support/pbr.hpp"

namespace lichtraum::test {

void set_material(Scene& scene, char const* name, Material::Model const& model) {
  *(*scene.materials.find(name)) = Material(name, model);
}

void let_shine(Scene& scene, char const* name, Rgb const& emission) {
  PhongModel model = (*scene.materials.find(name))->phong();
  model.emission = emission;
  set_material(scene, name, model);
}

EnvironmentLight around(std::shared_ptr<EnvironmentMap const> map) { return {"made here", std::move(map), 0, 1}; }

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

std::string const things = R"(
define material floor  0 0 0  0.6 0.5 0.4  0 0 0 1
define material a 0 0 0  0.5 0.5 0.5  0 0 0 1
define material b 0 0 0  0.5 0.5 0.5  0 0 0 1
define material c 0 0 0  0.5 0.5 0.5  0 0 0 1
define material d 0 0 0  0.5 0.5 0.5  0 0 0 1
define camera eye 45
transform eye rotate -15 1 0 0
transform eye translate 0 1.4 5
)";

std::string const four_balls = things + R"(
define shape sphere a -1.1 0.8 0 0.75 a
define shape sphere b 1.1 0.8 0 0.75 b
define shape sphere c -1.1 -0.8 0.4 0.75 c
define shape sphere d 1.1 -0.8 0.4 0.75 d
)";

}  // namespace lichtraum::test
