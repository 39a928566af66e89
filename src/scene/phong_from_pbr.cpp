#include "lichtraum/material.hpp"
#include "scene/pbr_evaluation.hpp"

namespace lichtraum {

Material phong_from_pbr(std::string name, std::shared_ptr<PbrMaterial const> pbr) {
  device::PbrPoint const point = evaluate(*pbr, MeshPoint());
  device::PhongMaterial const phong = device::phong_from_pbr(&point);
  auto const rgb = [](device::float4 const& v) { return Rgb(v.x, v.y, v.z); };
  Material material(std::move(name), rgb(phong.ka), rgb(phong.kd), rgb(phong.ks), phong.ka.w);
  material.set_emission({phong.emission[0], phong.emission[1], phong.emission[2]});
  material.set_mirror_and_glass(phong.kd.w, phong.ks.w, phong.ior);
  material.set_pbr(std::move(pbr));
  return material;
}

}  // namespace lichtraum
