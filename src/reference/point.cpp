#include "reference/point.hpp"

#include <algorithm>
#include <cmath>
#include <glm/matrix.hpp>
#include <limits>

#include "scene/pbr_evaluation.hpp"
#include "scene/texture_lookup.hpp"
#include "scene/unit_vector.hpp"

namespace lichtraum {

Material const& material_of(Shape const& shape) {
  static Material const matt_grey;
  return shape.material() ? *shape.material() : matt_grey;
}

namespace {

double largest_coordinate(Vec3 const& p) { return std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)}); }

PhongModel coefficients(Material const& material, MeshPoint const& point) {
  PbrModel const* const pbr = material.pbr();
  return pbr ? phong_at(*pbr, point) : material.phong();
}

/// Tangent and bitangent of a surface with the unit normal `n`: along the texture's u, and against its v.
struct TangentFrame {
  Vec3 tangent;
  Vec3 bitangent;
};

std::optional<TangentFrame> tangent_frame(Vec3 const& n, Vec3 const& tangent, double sign) {
  Vec3 const in_plane = tangent - glm::dot(n, tangent) * n;
  double const length = glm::length(in_plane);
  if (!(length > 0 && std::isfinite(length))) return std::nullopt;
  Vec3 const unit = in_plane / length;
  return TangentFrame{unit, (sign < 0 ? -1.0 : 1.0) * glm::cross(n, unit)};
}

std::optional<TangentFrame> tangent_frame_at(PbrModel const& material, MeshPoint const& point, Mat3 const& linear,
                                             Vec3 const& n) {
  if (auto const tangent = point.tangent()) {
    double const mirrored = glm::determinant(linear) < 0 ? -1 : 1;
    return tangent_frame(n, linear * Vec3(*tangent), mirrored * tangent->w);
  }
  auto const axes = point.texture_axes(material.normal_texture);
  if (!axes) return std::nullopt;
  auto frame = tangent_frame(n, linear * axes->along_u, 1);
  if (frame && glm::dot(frame->bitangent, linear * axes->along_v) > 0) frame->bitangent = -frame->bitangent;
  return frame;
}

/// The normal on the side of `geometric_normal` that is interpolated between vertices (Phong 1975).
Vec3 smooth_normal(MeshPoint const& point, Mat3 const& linear, Vec3 const& geometric_normal) {
  auto const interpolated = point.normal();
  if (!interpolated) return geometric_normal;
  Vec3 const world = unit_vector(glm::transpose(glm::inverse(linear)) * *interpolated);
  double const side = glm::dot(world, geometric_normal);
  return side > 0 ? world : side < 0 ? -world : geometric_normal;
}

/// The normal that light is computed with: the smooth one, turned by a normal map (glTF 2.0, 3.9.3).
Vec3 bump_normal(PbrModel const* material, MeshPoint const& point, Mat3 const& linear, Vec3 const& n) {
  if (!material || !material->normal_texture) return n;
  auto const uv = point.texcoord(material->normal_texture.texcoord);
  auto const frame = tangent_frame_at(*material, point, linear, n);
  if (!uv || !frame) return n;
  Vec3 const texel = 2.0 * Vec3(look_up(material->normal_texture, *uv, TexelContent::data)) - 1.0;
  Vec3 const bumped = material->normal_scale * (texel.x * frame->tangent + texel.y * frame->bitangent) + texel.z * n;
  return glm::length(bumped) > 0 ? glm::normalize(bumped) : n;
}

/// From the triangle to the round body that it stands for: onto the planes that its corners' normals stand on (Hanika
/// 2021), where these are within 60 degrees of `facing`, the triangle's normal on the viewer's side; else 0.
Vec3 lift_from_facet(MeshPoint const& point, Mat3 const& linear, Vec3 const& facing) {
  auto const corners = point.smooth_corners();
  if (!corners) return Vec3(0);
  Vec3 lift(0);
  for (auto const& [to_point, normal, weight] : *corners) {
    Vec3 n = unit_vector(glm::transpose(glm::inverse(linear)) * normal);
    if (glm::dot(n, facing) < 0) n = -n;
    if (!(glm::dot(n, facing) >= 0.5)) return Vec3(0);
    lift -= weight * std::min(glm::dot(linear * to_point, n), 0.0) * n;
  }
  return lift;
}

}  // namespace

ReferencePoint find_reference_point(Ray const& ray, Hit const& hit) {
  ReferencePoint result;
  Material const& material = material_of(*hit.shape);
  PbrModel const* const pbr = material.pbr();
  MeshPoint const point(hit);
  result.from_outside = glm::dot(hit.normal, ray.direction) < 0;
  result.position = ray.at(hit.t);
  result.set_normals(result.from_outside ? hit.normal : -hit.normal);
  result.to_viewer = -ray.direction;
  result.offset = reference_ray_epsilon * std::max(largest_coordinate(result.position), largest_coordinate(ray.origin));
  result.phong = coefficients(material, point);
  if (point.is_on_mesh() && !(pbr && pbr->unlit)) {
    Vec3 const smooth = smooth_normal(point, hit.linear_from_shape, hit.normal);
    Vec3 const outward = bump_normal(pbr, point, hit.linear_from_shape, smooth);
    result.normal = result.from_outside ? outward : -outward;
    result.smooth_normal = result.from_outside ? smooth : -smooth;
    result.lift = lift_from_facet(point, hit.linear_from_shape, result.geometric_normal);
    if (result.lift != Vec3(0)) result.round_normal = result.smooth_normal;
  }
  return result;
}

double bump_shadow(Vec3 const& smooth_normal, Vec3 const& normal, Vec3 const& to_light) {
  double const cosine = glm::dot(smooth_normal, to_light);
  double const unshadowed = glm::dot(normal, to_light) * glm::dot(smooth_normal, normal);
  if (cosine <= 0) return 0;
  if (cosine >= unshadowed) return 1;
  double const share = cosine / unshadowed;
  return share + share * share - share * share * share;
}

bool is_absent(Hit const& hit) {
  PbrModel const* const pbr = material_of(*hit.shape).pbr();
  if (!pbr || !has_cutouts(*pbr)) return false;
  MeshPoint const point(hit);
  return point.is_on_mesh() && is_cut_out(*pbr, base_alpha(*pbr, point));
}

double transmittance(Hit const& hit) { return coefficients(material_of(*hit.shape), MeshPoint(hit)).transmit; }

}  // namespace lichtraum
