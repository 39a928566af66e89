#include "compile/light_choice.hpp"

#include <glm/geometric.hpp>

#include "compile/alias_table.hpp"

namespace lichtraum {
namespace {

constexpr double pi = 3.14159265358979323846;

double luminance(float const (&rgb)[3]) { return 0.2126 * rgb[0] + 0.7152 * rgb[1] + 0.0722 * rgb[2]; }

/// Of what the material sends out; a texture makes less of it, which does not count here.
double emitted_luminance(device::ShadingArrays const& tables, std::size_t material) {
  if (material < tables.pbr_materials.size()) {
    device::PbrMaterial const& pbr = tables.pbr_materials[material];
    // What is unlit shows its colour and is no lamp.
    if ((pbr.flags & PBR_IS_PRESENT) != 0) return pbr.unlit != 0 ? 0 : luminance(pbr.emissive);
  }
  return luminance(tables.materials[material].emission);
}

double area(device::EmissiveTriangle const& triangle) {
  auto const edge = [&](int i) { return Vec3(triangle.edges[i][0], triangle.edges[i][1], triangle.edges[i][2]); };
  return 0.5 * glm::length(glm::cross(edge(0), edge(1)));
}

/// Squared: half the scene's diagonal, at which a light that has a place is thought to be.
double usual_distance_squared(DeviceBounds const& bounds) {
  if (bounds.is_empty()) return 1;
  Vec3 const diagonal = Vec3(bounds.max) - Vec3(bounds.min);
  double const squared = 0.25 * glm::dot(diagonal, diagonal);
  return squared > 0 ? squared : 1;
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
    weights.push_back(emitted[triangle.material] * area(triangle) / distance_squared);
  }
  double sum = 0;
  for (double const weight : weights) sum += weight;
  tables.light_choices.clear();
  tables.light_probabilities.clear();
  tables.emission_densities.assign(emitted.size(), 0.0f);
  if (!(sum > 0)) return;
  tables.light_choices.resize(weights.size());
  AliasTableMaker().fill(weights, tables.light_choices);
  for (double const weight : weights) tables.light_probabilities.push_back(float(weight / sum));
  for (device::EmissiveTriangle const& triangle : scene.emissive_triangles) {
    tables.emission_densities[triangle.material] = float(emitted[triangle.material] / distance_squared / sum);
  }
}

}  // namespace lichtraum
