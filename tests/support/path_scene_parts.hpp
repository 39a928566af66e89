#pragma once

#include <memory>
#include <string>
#include <vector>

#include "lichtraum/environment.hpp"
#include "support/path_scenes.hpp"

namespace lichtraum::test {

/// What path_scenes() is made of, by what it shows.
std::vector<PathScene> material_scenes();
std::vector<PathScene> lamp_scenes();
std::vector<PathScene> wall_scenes();
std::vector<PathScene> ground_scenes();

/// Matt materials for a floor, `a` to `d` for others, and a camera.
extern std::string const things;
/// `things`, with four balls of the materials `a` to `d`.
extern std::string const four_balls;

void set_material(Scene& scene, char const* name, Material::Model const& model);
void let_shine(Scene& scene, char const* name, Rgb const& emission);

EnvironmentLight around(std::shared_ptr<EnvironmentMap const> map);
/// A blue sky over brown ground, and a window of four texels that is some ten times as bright.
EnvironmentLight window_environment();

}  // namespace lichtraum::test
