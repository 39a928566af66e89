#include "io/gltf/deform.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/matrix.hpp>
#include <utility>

#include "core/float3.hpp"

namespace lichtraum::gltf {
namespace {

Float3 to_float3(Vec3 const& v) { return {float(v.x), float(v.y), float(v.z)}; }

Float3 to_unit_float3(Vec3 const& v) {
  double const length = glm::length(v);
  return length > 0 && std::isfinite(length) ? to_float3(v / length) : Float3{0, 0, 0};
}

/// Of tangents, the sign of the bitangent stays.
template <class Vector, class Delta>
void add(std::vector<Vector>& values, std::vector<Delta> const& deltas, double weight) {
  if (deltas.size() != values.size()) return;
  for (std::size_t i = 0; i < values.size(); ++i) {
    for (std::size_t axis = 0; axis < Delta().size(); ++axis)
      values[i][axis] += float(weight * double(deltas[i][axis]));
  }
}

/// As glTF 2.0 has it for morphed colours (3.7.2.2). What is not a number becomes 0.
void clamp_to_unit(std::vector<Float4>& colors) {
  for (Float4& color : colors) {
    for (float& channel : color) channel = channel > 0 ? std::min(channel, 1.0f) : 0;
  }
}

Vec3 along(Float4 const& tangent) { return Vec3(tangent[0], tangent[1], tangent[2]); }

/// Makes it a unit vector in another direction.
void turn(Float4& tangent, Vec3 const& direction) {
  Float3 const unit = to_unit_float3(direction);
  std::copy(unit.begin(), unit.end(), tangent.begin());
}

/// Which way normals go: the cofactors, which are there also where the inverse is not.
Mat3 normal_matrix(Mat3 const& m) {
  return Mat3(glm::cross(m[1], m[2]), glm::cross(m[2], m[0]), glm::cross(m[0], m[1]));
}

/// Shows the other side of its triangles. Bitangents, which are across the normal and the tangent, stay.
void turn_over(MeshGeometry& geometry) {
  for (std::size_t i = 0; i + 2 < geometry.indices.size(); i += 3)
    std::swap(geometry.indices[i + 1], geometry.indices[i + 2]);
  for (Float3& normal : geometry.normals) normal = {-normal[0], -normal[1], -normal[2]};
  for (Float4& tangent : geometry.tangents) tangent[3] = -tangent[3];
}

}  // namespace

bool is_morphed(Primitive const& primitive, std::vector<double> const& weights) {
  std::size_t const count = std::min(weights.size(), primitive.targets.size());
  return std::any_of(weights.begin(), weights.begin() + std::ptrdiff_t(count),
                     [](double w) { return w != 0 && std::isfinite(w); });
}

std::shared_ptr<MeshGeometry const> morph(Primitive const& primitive, std::vector<double> const& weights) {
  if (!is_morphed(primitive, weights)) return primitive.geometry;
  std::size_t const count = std::min(weights.size(), primitive.targets.size());
  auto morphed = std::make_shared<MeshGeometry>(*primitive.geometry);
  bool recolors = false;
  for (std::size_t i = 0; i < count; ++i) {
    if (weights[i] == 0 || !std::isfinite(weights[i])) continue;
    MorphTarget const& target = primitive.targets[i];
    add(morphed->positions, target.positions, weights[i]);
    add(morphed->normals, target.normals, weights[i]);
    add(morphed->tangents, target.tangents, weights[i]);
    for (std::size_t set = 0; set < target.texcoords.size(); ++set) {
      add(morphed->texcoords[set], target.texcoords[set], weights[i]);
    }
    add(morphed->colors, target.colors, weights[i]);
    recolors = recolors || !target.colors.empty();
  }
  for (Float3& normal : morphed->normals) normal = to_unit_float3(to_vec3(normal));
  for (Float4& tangent : morphed->tangents) turn(tangent, along(tangent));
  if (recolors) clamp_to_unit(morphed->colors);
  return morphed;
}

SkinPose pose_skin(tinygltf::Model const& model, int skin, NodeTree const& tree, Accessors& accessors,
                   Findings& findings) {
  auto const& source = model.skins[std::size_t(skin)];
  SkinPose pose;
  std::optional<FloatElements> inverse_bind;
  if (source.inverseBindMatrices >= 0) {
    std::string const pointer = fmt::format("/skins/{}/inverseBindMatrices", skin);
    inverse_bind = accessors.floats(source.inverseBindMatrices, 16, pointer);
    if (inverse_bind && inverse_bind->count() < source.joints.size()) {
      findings.warn(DiagnosticCode::faulty_skin, pointer,
                    fmt::format("{} matrices for {} joints", inverse_bind->count(), source.joints.size()));
      inverse_bind.reset();
    }
  }
  for (std::size_t i = 0; i < source.joints.size(); ++i) {
    Mat4 bind_from_mesh(1);
    if (inverse_bind) {
      float const* values = inverse_bind->values.data() + 16 * i;
      for (int column = 0; column < 4; ++column) {
        for (int row = 0; row < 4; ++row) bind_from_mesh[column][row] = double(values[4 * column + row]);
      }
    }
    pose.world_from_bind.push_back(tree.world_from_node[std::size_t(source.joints[i])] * bind_from_mesh);
    pose.normals.push_back(normal_matrix(Mat3(pose.world_from_bind.back())));
  }
  return pose;
}

std::shared_ptr<MeshGeometry const> apply_skin(MeshGeometry const& geometry, std::vector<JointSet> const& joint_sets,
                                               SkinPose const& skin, bool is_mirrored) {
  auto skinned = std::make_shared<MeshGeometry>(geometry);
  std::size_t const joints = skin.world_from_bind.size();
  for (std::size_t i = 0; i < geometry.positions.size(); ++i) {
    Vec3 const position = to_vec3(geometry.positions[i]);
    Vec3 const normal = geometry.normals.empty() ? Vec3(0) : to_vec3(geometry.normals[i]);
    Vec3 const tangent = geometry.tangents.empty() ? Vec3(0) : along(geometry.tangents[i]);
    Vec3 moved(0), turned(0), turned_tangent(0);
    double sum = 0;
    for (JointSet const& set : joint_sets) {
      for (std::size_t k = 0; k < 4; ++k) {
        auto const weight = double(set.weights[i][k]);
        if (weight == 0) continue;
        std::size_t const joint = set.joints[i][k] < joints ? set.joints[i][k] : 0;
        moved += weight * Vec3(skin.world_from_bind[joint] * glm::dvec4(position, 1));
        turned += weight * (skin.normals[joint] * normal);
        turned_tangent += weight * (Mat3(skin.world_from_bind[joint]) * tangent);
        sum += weight;
      }
    }
    if (sum == 0) continue;
    skinned->positions[i] = to_float3(moved / sum);
    if (!geometry.normals.empty()) skinned->normals[i] = to_unit_float3(turned);
    // With normals by cofactors, which a mirror turns over, the bitangent's sign stays.
    if (!geometry.tangents.empty()) turn(skinned->tangents[i], turned_tangent);
  }
  if (is_mirrored) turn_over(*skinned);
  return skinned;
}

}  // namespace lichtraum::gltf
