#include "io/gltf/materials.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace lichtraum::gltf {
namespace {

double fraction(double value, double absent) { return std::isfinite(value) ? std::clamp(value, 0.0, 1.0) : absent; }

std::shared_ptr<Material> read_material(tinygltf::Material const& source, std::string name) {
  auto const& pbr = source.pbrMetallicRoughness;
  Rgb const base(fraction(pbr.baseColorFactor[0], 1), fraction(pbr.baseColorFactor[1], 1),
                 fraction(pbr.baseColorFactor[2], 1));
  double const metallic = fraction(pbr.metallicFactor, 1);
  double const roughness = fraction(pbr.roughnessFactor, 1);
  double const alpha2 = std::max(std::pow(roughness, 4), 1e-4);
  double const m = std::max(2 / alpha2 - 2, 0.0) / 4;
  Rgb const f0 = Rgb(0.04) * (1 - metallic) + base * metallic;
  return std::make_shared<Material>(std::move(name), base, base * (1 - 0.6 * metallic), f0 * std::min((m + 2) / 8, 1.0),
                                    m);
}

}  // namespace

std::vector<std::shared_ptr<Material>> read_materials(tinygltf::Model const& model, Names& names, Findings&) {
  std::vector<std::shared_ptr<Material>> materials;
  for (std::size_t i = 0; i < model.materials.size(); ++i) {
    auto const& source = model.materials[i];
    materials.push_back(
        read_material(source, names.unique(source.name.empty() ? fmt::format("material_{}", i) : source.name)));
  }
  materials.push_back(std::make_shared<Material>(names.unique("default"), Rgb(0.8), Rgb(0.8), Rgb(0), 1));
  return materials;
}

}  // namespace lichtraum::gltf
