#include "reference/scattering.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/largest_channel.hpp"
#include "core/square.hpp"
#include "reference/albedo_tables.hpp"
#include "reference/microfacets.hpp"
#include "reference/point.hpp"

namespace lichtraum {
namespace {

constexpr double coat_f0 = 0.04;  // of index 1.5

/// Schlick, "An Inexpensive BRDF Model for Physically-based Rendering", 1994.
Rgb schlick(Rgb const& f0, Rgb const& f90, double cosine) {
  double const c = 1 - cosine;
  return f0 + (f90 - f0) * (c * c * c * c * c);
}

/// What microfacets reflect in all over what they do once: the sum over bounces of which each reflects Fresnel's mean,
/// after Schlick, and loses `kept` to the outside (Kulla and Conty, "Revisiting Physically Based Shading at
/// Imageworks", SIGGRAPH 2017 courses).
Rgb bounce_gain(Rgb const& f0, Rgb const& f90, double kept) {
  Rgb const mean = glm::min(f0 * (20 / 21.) + f90 / 21., Rgb(1));
  return Rgb(1) / (1.0 - mean * (1 - kept));
}

/// Up to this roughness a table of 16 angles is too coarse at the critical one.
constexpr double sharp_alpha = 0.2;

/// The square of the cosine beyond the surface, by Snell's law; negative where all is reflected.
double cosine_beyond_squared(double eta, double cosine) { return 1 - eta * eta * (1 - cosine * cosine); }

/// What a solid reflects of light from within, all microfacets together: the mean over how they lean in the plane of
/// incidence, whose density is GGX's along one axis, weighted by how large they look.
Rgb reflected_by_facets(ReferenceBsdf const& bsdf, double eta, double cosine) {
  constexpr int count = 256;
  double const sine = std::sqrt(std::max(1 - square(cosine), 0.0));
  Rgb sum(0);
  double all = 0;
  for (int i = 0; i < count; ++i) {
    double const q = 2 * (i + 0.5) / count - 1;
    double const slope = bsdf.alpha * q / std::sqrt(1 - q * q);
    double const leaning = std::max(cosine + slope * sine, 0.0) / std::sqrt(1 + slope * slope);
    double const beyond = cosine_beyond_squared(eta, leaning);
    sum += leaning * (beyond > 0 ? schlick(bsdf.f0, bsdf.f90, std::sqrt(beyond)) : Rgb(1));
    all += leaning;
  }
  return all > 0 ? sum / all : Rgb(1);
}

}  // namespace

double coat_fresnel(double cosine) { return schlick(Rgb(coat_f0), Rgb(1), cosine).r; }

ReferenceScattering::ReferenceScattering(ReferenceBsdf const& bsdf, Vec3 const& smooth_normal, Vec3 const& normal,
                                         Vec3 const& to_viewer, bool from_outside)
    : bsdf_(bsdf),
      smooth_normal_(smooth_normal),
      normal_(normal),
      to_viewer_(to_viewer),
      eta_(from_outside ? 1 / bsdf.ior : bsdf.ior) {
  double const cosine = glm::dot(normal, to_viewer);
  if (bsdf.coat > 0) {
    auto const coat = reflection_albedo(bsdf.coat_alpha, cosine);
    below_coat_ = 1 - bsdf.coat * (coat_f0 * coat.a + coat.b);
  }
  base_ = Rgb(below_coat_);
  auto const gloss = reflection_albedo(bsdf.alpha, cosine);
  gloss_albedo_ = gloss.a + gloss.b;
  if (!bsdf.is_layered) return;
  metal_gain_ = bounce_gain(bsdf.metal, Rgb(1), gloss_albedo_);
  dielectric_gain_ = bounce_gain(bsdf.f0, bsdf.f90, gloss_albedo_);
  Rgb reflected = dielectric_gain_ * (gloss.a * bsdf.f0 + gloss.b * bsdf.f90);
  if (is_solid()) {
    double const specular = largest_channel(bsdf.f90);
    auto const solid = solid_albedo(eta_, specular, bsdf.alpha, cosine);
    double total = solid.total;
    if (bsdf.has_film) {  // it reflects more of what reflection keeps than the table knows of
      double const ratio = (eta_ - 1) / (eta_ + 1);
      double const more = largest_channel(bsdf.f0) - specular * ratio * ratio;
      total += std::max(more, 0.0) * std::max(gloss_albedo_ - total, 0.0);
    }
    refraction_gain_ = 1 / total;
    dielectric_gain_ = Rgb(refraction_gain_);
    reflected = refraction_gain_ * (eta_ > 1 ? Rgb(solid.reflected) : gloss.a * bsdf.f0 + gloss.b * bsdf.f90);
    if (eta_ > 1 && bsdf.alpha < sharp_alpha) {
      double const part = std::max(2 * bsdf.alpha / sharp_alpha - 1, 0.0);  // the table's, from half of it on
      reflected = glm::mix(reflected_by_facets(bsdf, eta_, cosine), reflected, part);
    }
  }
  base_ *= std::max(1 - largest_channel(reflected), 0.0);  // alike in all channels (KHR_materials_specular)
}

bool ReferenceScattering::is_solid() const { return bsdf_.is_layered && std::abs(eta_ - 1) > 1e-3; }

/// What a microfacet reflects. Within a denser body a dielectric's angle is the one outside.
Rgb ReferenceScattering::fresnel(double cosine) const {
  double const beyond = cosine_beyond_squared(eta_, cosine);
  Rgb dielectric = schlick(bsdf_.f0, bsdf_.f90, eta_ > 1 ? std::sqrt(std::max(beyond, 0.0)) : cosine);
  if (is_solid() && beyond <= 0) dielectric = Rgb(1);
  return (1 - bsdf_.metallic) * dielectric_gain_ * dielectric +
         bsdf_.metallic * metal_gain_ * schlick(bsdf_.metal, Rgb(1), cosine);
}

/// What a microfacet of a solid refracts.
Rgb ReferenceScattering::refracted_share(double cosine) const {
  double const beyond = cosine_beyond_squared(eta_, cosine);
  if (beyond <= 0) return Rgb(0);
  Rgb const reflected = schlick(bsdf_.f0, bsdf_.f90, eta_ > 1 ? std::sqrt(beyond) : cosine);
  return below_coat_ * refraction_gain_ * bsdf_.transmitted * std::max(1 - largest_channel(reflected), 0.0);
}

Rgb ReferenceScattering::transmitted(Vec3 const& to_light) const {
  if (is_solid()) {
    Vec3 const h = refracting_normal(normal_, to_viewer_, to_light, eta_);
    return refracted_share(glm::dot(to_viewer_, h)) *
           microfacet_refraction(bsdf_.alpha, normal_, to_viewer_, to_light, h, eta_);
  }
  Vec3 const mirrored = to_light - 2 * glm::dot(to_light, normal_) * normal_;
  return base_ * bsdf_.transmitted * microfacet_reflection(bsdf_.alpha, normal_, to_viewer_, mirrored) / gloss_albedo_;
}

Rgb ReferenceScattering::evaluate(Vec3 const& to_light, Lobes lobes) const {
  double const cosine = glm::dot(normal_, to_light);
  bool const counts_gloss = lobes == Lobes::all || bsdf_.alpha > smooth_alpha;
  bool const counts_coat = lobes == Lobes::all || bsdf_.coat_alpha > smooth_alpha;
  if (cosine == 0) return Rgb(0);
  if (cosine < 0) {
    bool const is_black = bsdf_.transmitted == Rgb(0) || !counts_gloss;
    return is_black ? Rgb(0) : -cosine * transmitted(to_light);
  }
  Rgb f = bump_shadow(smooth_normal_, normal_, to_light) * base_ * bsdf_.diffuse / std::numbers::pi;
  double const facet_cosine = glm::dot(to_viewer_, glm::normalize(to_viewer_ + to_light));
  if (counts_gloss) {
    f += below_coat_ * fresnel(facet_cosine) * microfacet_reflection(bsdf_.alpha, normal_, to_viewer_, to_light);
  }
  if (counts_coat && bsdf_.coat > 0) {
    f += bsdf_.coat * coat_fresnel(facet_cosine) *
         microfacet_reflection(bsdf_.coat_alpha, normal_, to_viewer_, to_light);
  }
  return cosine * f;
}

ReferenceScattering ReferenceScattering::blurred(double alpha) const {
  ReferenceScattering blurred = *this;
  blurred.bsdf_.alpha = std::max(bsdf_.alpha, alpha);
  blurred.bsdf_.coat_alpha = std::max(bsdf_.coat_alpha, alpha);
  return blurred;
}

bool ReferenceScattering::has_spread() const {
  bool const is_glossy = bsdf_.f90 != Rgb(0) || bsdf_.f0 != Rgb(0) || bsdf_.metallic > 0;
  return bsdf_.diffuse != Rgb(0) || (is_glossy && bsdf_.alpha > smooth_alpha) || transmits() ||
         (bsdf_.coat > 0 && bsdf_.coat_alpha > smooth_alpha);
}

bool ReferenceScattering::transmits() const { return bsdf_.transmitted != Rgb(0) && bsdf_.alpha > smooth_alpha; }

Vec3 ReferenceScattering::mirrored() const { return 2 * glm::dot(normal_, to_viewer_) * normal_ - to_viewer_; }

Vec3 ReferenceScattering::refracted() const {
  double const cosine = glm::dot(normal_, to_viewer_);
  double const beyond = cosine_beyond_squared(eta_, cosine);
  return beyond > 0 ? -eta_ * to_viewer_ + (eta_ * cosine - std::sqrt(beyond)) * normal_ : mirrored();
}

std::vector<ReferenceScattering::Ray> ReferenceScattering::smooth_rays() const {
  std::vector<Ray> rays;
  double const cosine = glm::dot(normal_, to_viewer_);
  auto const add = [&](Vec3 const& direction, Rgb const& weight, bool is_mirror_or_glass) {
    if (weight != Rgb(0)) rays.push_back({glm::normalize(direction), weight, is_mirror_or_glass});
  };
  add(mirrored(), Rgb(bsdf_.mirror), true);
  add(refracted(), Rgb(bsdf_.glass), true);
  if (bsdf_.alpha <= smooth_alpha) {
    add(mirrored(), below_coat_ * fresnel(cosine), false);
    if (is_solid()) {
      add(refracted(), refracted_share(cosine), false);
    } else {
      add(-to_viewer_, base_ * bsdf_.transmitted, false);
    }
  }
  if (bsdf_.coat_alpha <= smooth_alpha) {
    add(mirrored(), Rgb(bsdf_.coat * coat_fresnel(cosine)), false);
  }
  return rays;
}

}  // namespace lichtraum
