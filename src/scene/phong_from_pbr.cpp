#include "lichtraum/material.hpp"
#include "scene/pbr_evaluation.hpp"

namespace lichtraum {

Material phong_from_pbr(std::string name, std::shared_ptr<PbrMaterial const> pbr) {
  device::PbrPoint const point = evaluate(*pbr, MeshPoint());
  device::PhongMaterial const phong = device::phong_from_pbr(&point);
  auto const rgb = [](float const(&v)[3]) { return Rgb(v[0], v[1], v[2]); };
  Material material(std::move(name), rgb(phong.ka), rgb(phong.kd), rgb(phong.ks), phong.m);
  material.set_emission(rgb(phong.emission));
  material.set_mirror_and_glass(phong.reflect, phong.transmit, phong.ior);
  material.set_pbr(std::move(pbr));
  return material;
}

}  // namespace lichtraum
