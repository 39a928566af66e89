/// Materials.

#include "support/path_scene_parts.hpp"

#include <utility>

#include "support/esdf.hpp"
#include "support/pbr.hpp"
#include "support/textured_meshes.hpp"

namespace lichtraum::test {
namespace {

PathScene mirrors_and_glass() {
  Scene scene = scene_of(things + R"(
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

std::vector<PathScene> material_scenes() {
  std::vector<PathScene> scenes;
  scenes.push_back(mirrors_and_glass());
  scenes.push_back(metal_and_rough("metal and rough, uniform environment", around(uniform_environment(0.8f, 0.9f, 1))));
  scenes.push_back(metal_and_rough("metal and rough, window", window_environment()));
  scenes.push_back(rough_glass());
  scenes.push_back(coats());
  scenes.push_back(smooth());
  scenes.push_back(textures());
  return scenes;
}

}  // namespace lichtraum::test
