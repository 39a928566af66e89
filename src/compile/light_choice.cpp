#include "compile/light_choice.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <numeric>

#include "compile/alias_table.hpp"
#include "compile/light_tree.hpp"
#include "core/luminance.hpp"

namespace lichtraum {
namespace {

using std::numbers::pi;

/// Of what the material sends out; a texture makes less of it, which does not count here.
double emitted_luminance(device::ShadingArrays const& tables, std::size_t material) {
  if (material < tables.pbr_materials.size()) {
    device::PbrMaterial const& pbr = tables.pbr_materials[material];
    // What is unlit shows its colour and is no lamp.
    if ((pbr.flags & PBR_IS_PRESENT) != 0) return pbr.unlit != 0 ? 0 : luminance(pbr.emissive);
  }
  return luminance(tables.materials[material].emission);
}

Vec3 edge(device::EmissiveTriangle const& triangle, int i) {
  return {triangle.edges[i][0], triangle.edges[i][1], triangle.edges[i][2]};
}
/// As long as the triangle's area is large.
Vec3 area_vector(device::EmissiveTriangle const& triangle) {
  return 0.5 * glm::cross(edge(triangle, 0), edge(triangle, 1));
}

Vec3 axis(device::EmissiveSolid const& solid, int i) { return {solid.axes[i][0], solid.axes[i][1], solid.axes[i][2]}; }
/// Half of its surface, which is a flat box's one side. Of an ellipsoid that is no sphere roughly.
double half_surface(device::EmissiveSolid const& solid) {
  double sum = 0;
  for (int i = 0; i < 3; ++i) sum += glm::length(glm::cross(axis(solid, (i + 1) % 3), axis(solid, (i + 2) % 3)));
  return (solid.kind == PRIMITIVE_BOX ? 4 : 2 * pi / 3) * sum;
}

/// Squared: half the scene's diagonal, at which a light that has a place is thought to be.
double usual_distance_squared(DeviceBounds const& bounds) {
  if (bounds.is_empty()) return 1;
  Vec3 const diagonal = Vec3(bounds.max) - Vec3(bounds.min);
  double const squared = 0.25 * glm::dot(diagonal, diagonal);
  return squared > 0 ? squared : 1;
}

/// More lights that have a place are chosen by a tree: that takes time, and less noise for it. So are fewer, where
/// others have none: how much these matter beside a lamp depends on how far it is away, and the size of a scene says
/// nothing about that.
constexpr std::size_t most_without_tree = 64;

LightLeaf leaf_of(device::EmissiveTriangle const& triangle) {
  Vec3 const corner(triangle.corner[0], triangle.corner[1], triangle.corner[2]);
  LightLeaf leaf;
  for (Vec3 const& point : {corner, corner + edge(triangle, 0), corner + edge(triangle, 1)}) leaf.bounds.add(point);
  leaf.normal = glm::normalize(area_vector(triangle));
  return leaf;
}
LightLeaf leaf_of(device::EmissiveSolid const& solid) {
  Vec3 const center(solid.center[0], solid.center[1], solid.center[2]);
  Vec3 extent(0);
  for (int i = 0; i < 3; ++i) extent += glm::abs(axis(solid, i));
  LightLeaf leaf;
  leaf.bounds.add(center - extent);
  leaf.bounds.add(center + extent);
  return leaf;
}
LightLeaf leaf_of(device::PunctualLight const& light) {
  Vec3 const position(light.position[0], light.position[1], light.position[2]);
  LightLeaf leaf;
  leaf.bounds.add(position - Vec3(light.radius));
  leaf.bounds.add(position + Vec3(light.radius));
  return leaf;
}

/// Of lights that have a place and fall off. `weights` are of lights, environment, triangles and solids, the irradiance
/// that each may bring; those in the tree become 0. Returns the irradiance that all in it bring to a distance of 1, or
/// 0 where there is none.
double plant_light_tree(ShadingTables& tables, SceneBuffers const& scene, std::vector<double>& weights,
                        double distance_squared) {
  std::vector<LightLeaf> leaves;
  auto const add = [&](auto const& light, std::size_t number) {
    if (!(weights[number] > 0)) return;
    LightLeaf leaf = leaf_of(light);
    leaf.intensity = weights[number];
    leaf.number = device::uint(number);
    leaves.push_back(leaf);
  };
  for (std::size_t i = 0; i < tables.lights.size(); ++i) {
    if (tables.lights[i].kind == LIGHT_FALLS_OFF) add(tables.lights[i], i);
  }
  std::size_t const first_triangle = tables.lights.size() + 1;
  std::size_t number = first_triangle;
  for (auto const& triangle : scene.emissive_triangles) add(triangle, number++);
  for (auto const& solid : scene.emissive_solids) add(solid, number++);
  double in_tree = 0;
  for (LightLeaf const& leaf : leaves) in_tree += leaf.intensity;
  bool const has_others = leaves.size() < std::size_t(std::ranges::count_if(
                                              weights, [](double w) { return w > 0; }));
  if (leaves.empty() || (leaves.size() <= most_without_tree && !has_others)) return 0;
  for (LightLeaf const& leaf : leaves) weights[leaf.number] = 0;
  weights.resize(first_triangle);
  tables.light_tree = make_light_tree(std::move(leaves), 2 * std::sqrt(distance_squared));
  return in_tree * distance_squared;
}

}  // namespace

std::vector<bool> emissive_materials(device::ShadingArrays const& tables) {
  std::vector<bool> shine(tables.materials.size());
  for (std::size_t i = 0; i < shine.size(); ++i) shine[i] = emitted_luminance(tables, i) > 0;
  return shine;
}

void set_light_choices(ShadingTables& tables, SceneBuffers const& scene) {
  double const distance_squared = usual_distance_squared(scene.world_bounds);
  std::vector<double> weights;  // the irradiance that each may bring
  for (device::PunctualLight const& light : tables.lights) {
    weights.push_back(pi * luminance(light.ld) / (light.kind == LIGHT_FALLS_OFF ? distance_squared : 1));
  }
  EnvironmentTable const& environment = *tables.environment_table;
  double const brightness = tables.environment ? tables.environment->brightness : 0;
  weights.push_back(pi * brightness * environment.sampled_mean_luminance);
  std::vector<double> emitted(tables.materials.size());
  for (std::size_t i = 0; i < emitted.size(); ++i) emitted[i] = emitted_luminance(tables, i);
  for (device::EmissiveTriangle const& triangle : scene.emissive_triangles) {
    weights.push_back(emitted[triangle.material] * glm::length(area_vector(triangle)) / distance_squared);
  }
  for (device::EmissiveSolid const& solid : scene.emissive_solids) {
    double const weight = emitted[solid.material] * half_surface(solid) / distance_squared;
    weights.push_back(std::isfinite(weight) ? weight : 0);
  }
  tables.light_choices.clear();
  tables.light_probabilities.clear();
  tables.light_tree.clear();
  tables.emission_densities.assign(emitted.size(), 0.0f);
  double const in_tree = plant_light_tree(tables, scene, weights, distance_squared);
  double const sum = std::accumulate(weights.begin(), weights.end(), 0.0);
  // Neither infinite nor, where there are others, 0.
  double const of_others = sum > 0 ? std::clamp(sum / in_tree, 1e-30, 1e30) : 0;
  tables.distant_importance = in_tree > 0 ? float(of_others) : -1;
  double const of_all = in_tree > 0 ? in_tree : sum * distance_squared;
  if (!(of_all > 0)) return;
  auto const set_density = [&](device::uint material) {
    tables.emission_densities[material] = float(emitted[material] / of_all);
  };
  for (auto const& triangle : scene.emissive_triangles) set_density(triangle.material);
  for (auto const& solid : scene.emissive_solids) set_density(solid.material);
  tables.light_choices.resize(weights.size());
  AliasTableMaker().fill(weights, tables.light_choices);
  for (double const weight : weights) tables.light_probabilities.push_back(float(sum > 0 ? weight / sum : 0));
}

}  // namespace lichtraum
