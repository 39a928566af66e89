#include "reference/microfacets.hpp"

#include <cmath>
#include <numbers>

#include "core/square.hpp"

namespace lichtraum {
namespace {

/// How much is hidden, for each part that is seen.
double lambda(double alpha, double cosine) {
  double const tangent_squared = (1 - square(cosine)) / square(cosine);
  return (std::sqrt(1 + square(alpha) * std::max(tangent_squared, 0.0)) - 1) / 2;
}

}  // namespace

double microfacet_density(double alpha, Vec3 const& normal, Vec3 const& h) {
  double const cosine = glm::dot(normal, h);
  if (!(cosine > 0)) return 0;
  // 1 - cosine^2 as a product, in which nothing cancels.
  double const sine_squared = glm::dot(glm::cross(normal, h), glm::cross(normal, h));
  return square(alpha) / (std::numbers::pi * square(sine_squared + square(alpha * cosine)));
}

double unhidden_share(double alpha, Vec3 const& normal, Vec3 const& v, Vec3 const& l) {
  return 1 / (1 + lambda(alpha, glm::dot(normal, v)) + lambda(alpha, glm::dot(normal, l)));
}

double microfacet_reflection(double alpha, Vec3 const& normal, Vec3 const& v, Vec3 const& l) {
  Vec3 const h = glm::normalize(v + l);
  return microfacet_density(alpha, normal, h) * unhidden_share(alpha, normal, v, l) /
         (4 * glm::dot(normal, v) * glm::dot(normal, l));
}

Vec3 refracting_normal(Vec3 const& normal, Vec3 const& v, Vec3 const& l, double eta) {
  Vec3 const h = glm::normalize(eta * v + l);
  return glm::dot(h, normal) < 0 ? -h : h;
}

double microfacet_refraction(double alpha, Vec3 const& normal, Vec3 const& v, Vec3 const& l, Vec3 const& h,
                             double eta) {
  double const v_h = glm::dot(v, h);
  double const l_h = glm::dot(l, h);
  if (!(v_h > 0 && l_h < 0)) return 0;
  double const projections = std::abs(v_h * l_h / (glm::dot(normal, v) * glm::dot(normal, l)));
  return projections * microfacet_density(alpha, normal, h) * unhidden_share(alpha, normal, v, l) /
         square(eta * v_h + l_h);
}

}  // namespace lichtraum
