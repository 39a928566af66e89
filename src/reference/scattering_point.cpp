#include "reference/scattering_point.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/elementary.hpp"
#include "core/largest_channel.hpp"
#include "core/square.hpp"
#include "lichtraum/error.hpp"
#include "reference/thin_film.hpp"
#include "scene/pbr_evaluation.hpp"

namespace lichtraum {
namespace {

Rgb color_of(float const (&values)[3]) { return {values[0], values[1], values[2]}; }

/// The largest share of `color`, up to all of it, that is nowhere more than `room`.
double fitting_share(Rgb const& color, Rgb const& room) {
  double share = 1;
  for (int c = 0; c < 3; ++c) {
    if (color[c] > room[c]) share = std::min(share, std::max(room[c], 0.0) / color[c]);
  }
  return share;
}

/// Matt and glossy lobe share what mirror and glass leave: the matt one has its kd, but a twentieth where the glossy
/// one needs that; the glossy one has as much of its ks as there is room for.
void set_lobes_of_phong(PhongModel const& phong, ReferenceBsdf& bsdf) {
  double const rest = std::max(1 - phong.reflect - phong.transmit, 0.0);
  double const glossy =
      std::max(fitting_share(phong.ks, rest * (Rgb(1) - phong.kd)), fitting_share(phong.ks, Rgb(rest / 20)));
  bsdf.f0 = bsdf.f90 = glossy * phong.ks;
  bsdf.diffuse = fitting_share(rest * phong.kd, Rgb(rest) - bsdf.f0) * rest * phong.kd;
}

void set_phong(PhongModel const& phong, ReferenceScatteringPoint& point) {
  ReferenceBsdf& bsdf = point.bsdf;
  set_lobes_of_phong(phong, bsdf);
  bsdf.alpha = std::max(std::sqrt(2 / (phong.m + 2)), smooth_alpha);
  bsdf.ior = phong.transmit > 0 ? phong.ior : 1;
  bsdf.mirror = phong.reflect;
  bsdf.glass = phong.transmit;
  point.emission = phong.emission;
  if (phong.transmit > 0 && phong.ior == 1 && phong.emission == Rgb(0)) {
    point.passed = Rgb(phong.transmit);
    point.chance_to_pass = phong.transmit / std::max(phong.reflect + phong.transmit, 1.0);
    bsdf.glass = 0;
  }
}

/// Light goes straight on through a wall that is thin and smooth, if nothing else is to it: by Schlick's formula, and
/// by the surface's own normal.
void open_pane(PbrModel const& material, Hit const& hit, ReferenceScatteringPoint& point) {
  ReferenceBsdf& bsdf = point.bsdf;
  bool const is_triangle = hit.shape->kind() == ShapeKind::triangle || hit.shape->kind() == ShapeKind::mesh;
  bool const has_more = bsdf.coat > 0 || material.clearcoat > 0 || material.iridescence > 0 ||
                        material.sheen_color != Rgb(0) || material.anisotropy > 0 ||
                        material.diffuse_transmission > 0 || material.emissive != Rgb(0);
  if (!is_triangle || has_more || material.thickness > 0 || bsdf.alpha > smooth_alpha) return;
  double const cosine = std::min(glm::dot(point.geometric_normal, point.to_viewer), 1.0);
  double const grazing = square(square(1 - cosine)) * (1 - cosine);
  Rgb const reflected = glm::mix(bsdf.f0, bsdf.f90, grazing);
  point.passed = std::max(1 - largest_channel(reflected), 0.0) * bsdf.transmitted;
  point.chance_to_pass = largest_channel(point.passed);
  bsdf.transmitted = Rgb(0);
}

/// KHR_materials_iridescence: the film's colour at the viewer's angle, as the F0 by which Schlick's formula gets there.
void cover_with_film(PbrModel const& material, MeshPoint const& at, ReferenceScatteringPoint& point) {
  ReferenceBsdf& bsdf = point.bsdf;
  double const factor = material.iridescence * texel_at(material.iridescence_texture, at, TexelContent::data).r;
  double const share = std::clamp(factor, 0., 1.);
  double const part = texel_at(material.iridescence_thickness_texture, at, TexelContent::data).g;
  double const thickness_nm =
      std::lerp(material.iridescence_thickness_minimum, material.iridescence_thickness_maximum, part);
  if (!(share > 0 && thickness_nm > 0)) return;
  double const index = point.from_outside ? 1 : bsdf.ior;
  double const cosine = glm::dot(point.normal, point.to_viewer);
  double const outside = std::sqrt(std::max(1 - square(index) * (1 - square(cosine)), 1e-6));
  double const grazing = square(square(1 - outside)) * (1 - outside);
  double const film_ior = std::max(material.iridescence_ior, 1.0);
  auto const covered = [&](Rgb const& f0) {
    Rgb const reflectance = thin_film_reflectance(film_ior, thickness_nm, outside, f0);
    return glm::clamp((reflectance - grazing) / (1 - grazing), Rgb(0), Rgb(1));
  };
  Rgb const specular = glm::max(bsdf.f90, Rgb(1e-6));
  bsdf.f0 = glm::mix(bsdf.f0, specular * covered(bsdf.f0 / specular), share);
  bsdf.metal = glm::mix(bsdf.metal, covered(bsdf.metal), share);
  bsdf.has_film = true;
}

/// glTF 2.0, appendix B.
void set_pbr(PbrModel const& material, Hit const& hit, ReferenceScatteringPoint& point) {
  MeshPoint const at(hit);
  device::PbrPoint const p = evaluate(material, at);
  point.opacity = p.alpha;
  point.shows_back = material.double_sided || p.transmission > 0;
  if (material.unlit) {
    point.emission = color_of(p.color);
    return;
  }
  point.emission = color_of(p.emission);
  ReferenceBsdf& bsdf = point.bsdf;
  Rgb const color = color_of(p.color);
  double const dielectric = 1 - double(p.metallic);
  double const transmission = p.transmission;
  double const specular = p.specular;
  double const head_on = square((double(p.ior) - 1) / (double(p.ior) + 1));
  bsdf.diffuse = dielectric * (1 - transmission) * color;
  bsdf.transmitted = dielectric * transmission * color;
  bsdf.f0 = specular * glm::min(head_on * color_of(p.specular_color), Rgb(1));
  bsdf.f90 = Rgb(specular);
  bsdf.metal = color;
  bsdf.metallic = p.metallic;
  bsdf.alpha = std::max(square(p.roughness), smooth_alpha);
  bsdf.is_layered = true;
  bsdf.ior = p.refraction_ior;
  bsdf.coat = std::clamp(material.clearcoat * texel_at(material.clearcoat_texture, at, TexelContent::data).r, 0., 1.);
  double const coat_roughness =
      material.clearcoat_roughness * texel_at(material.clearcoat_roughness_texture, at, TexelContent::data).g;
  bsdf.coat_alpha = std::max(square(std::clamp(coat_roughness, 0., 1.)), smooth_alpha);
  // KHR_materials_clearcoat, "Emission".
  point.emission *= 1 - bsdf.coat * coat_fresnel(glm::dot(point.geometric_normal, point.to_viewer));
  if (transmission > 0 && material.thickness > 0) point.solid = &material;
  cover_with_film(material, at, point);
  open_pane(material, hit, point);
}

/// The definition of kernels/surface/facing_normal.clh.
Vec3 facing_normal(ReferencePoint const& point) {
  double const facing = glm::dot(point.normal, point.to_viewer);
  double const least = std::max(glm::dot(point.smooth_normal, point.to_viewer) / 2, 1e-3);
  if (facing >= least) return point.normal;
  Vec3 const aside = point.normal - facing * point.to_viewer;
  double const length = glm::length(aside);
  if (!(length > 1e-3)) return point.geometric_normal;
  return glm::normalize(least * point.to_viewer + std::sqrt(1 - least * least) / length * aside);
}

}  // namespace

Rgb ReferenceScatteringPoint::albedo() const {
  Rgb const glossy = (1 - bsdf.metallic) * bsdf.f0 + bsdf.metallic * bsdf.metal;
  return glm::min(bsdf.diffuse + glossy + bsdf.transmitted + bsdf.mirror + bsdf.glass + emission, Rgb(1));
}

bool ReferenceScatteringPoint::is_consistent(Vec3 const& direction) const {
  return (glm::dot(geometric_normal, direction) > 0) == (glm::dot(normal, direction) > 0);
}

Ray ReferenceScatteringPoint::leave(Vec3 const& direction) const {
  return {glm::dot(geometric_normal, direction) < 0 ? below() : above(), direction};
}

bool ReferenceScatteringPoint::is_consistent_with_lamp(Vec3 const& to_light) const {
  return (glm::dot(round_normal, to_light) > 0) == (glm::dot(normal, to_light) > 0);
}

Ray ReferenceScatteringPoint::leave_to_lamp(Vec3 const& to_light) const {
  return {glm::dot(round_normal, to_light) > 0 ? above() + lift : below(), to_light};
}

Rgb attenuation(PbrModel const& solid, double distance) {
  Rgb left;
  for (int c = 0; c < 3; ++c) {
    left[c] = pow_of(std::clamp(solid.attenuation_color[c], 0., 1.), distance / solid.attenuation_distance);
  }
  return left;
}

double ior_in(PbrModel const& solid) { return solid.ior > 0 ? solid.ior : 1; }

double light_share(PbrModel const* solid) { return solid ? 1 / square(ior_in(*solid)) : 1; }

ReferenceScatteringPoint find_scattering_point(Ray const& ray, Hit const& hit) {
  ReferenceScatteringPoint point{find_reference_point(ray, hit), {}};
  point.normal = facing_normal(point);
  Material const& material = material_of(*hit.shape);
  if (PbrModel const* const pbr = material.pbr()) {
    set_pbr(*pbr, hit, point);
  } else {
    set_phong(material.phong(), point);
  }
  return point;
}

void check_is_known(Material const& material) {
  PbrModel const* const pbr = material.pbr();
  if (!pbr || pbr->unlit) return;
  std::pair<bool, char const*> const unknown[] = {
      {pbr->sheen_color != Rgb(0), "sheen"},
      {pbr->anisotropy != 0, "anisotropy"},
      {pbr->dispersion != 0 && pbr->transmission > 0 && pbr->thickness > 0, "dispersion"},
      {pbr->diffuse_transmission != 0, "diffuse transmission"},
      {pbr->clearcoat != 0 && (pbr->clearcoat_normal_texture || pbr->normal_texture), "clear coats with normal maps"},
  };
  for (auto const& [is_used, name] : unknown) {
    if (!is_used) continue;
    throw Error(ErrorKind::no_device,
                fmt::format("the reference tracer's paths know no {}, which material '{}' has: try another --device, "
                            "or --integrator whitted",
                            name, material.name()));
  }
}

}  // namespace lichtraum
