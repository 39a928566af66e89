#include "io/gltf/pose.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/ext/matrix_transform.hpp>
#include <glm/gtc/quaternion.hpp>
#include <glm/matrix.hpp>

#include "core/elementary.hpp"

namespace lichtraum::gltf {
namespace {

bool are_finite(std::vector<double> const& values) {
  return std::all_of(values.begin(), values.end(), [](double v) { return std::isfinite(v); });
}

/// Of unit length; a zero one means no rotation.
glm::dquat normalized(double x, double y, double z, double w) {
  double const largest = std::max({std::abs(x), std::abs(y), std::abs(z), std::abs(w)});
  if (!(largest > 0 && std::isfinite(largest))) return {1, 0, 0, 0};
  return glm::normalize(glm::dquat(w / largest, x / largest, y / largest, z / largest));
}

/// One animated property of one node: its value at a time.
class Track {
 public:
  Track(std::vector<float> times, std::vector<float> values, std::size_t components, std::string const& interpolation)
      : times_(std::move(times)),
        values_(std::move(values)),
        components_(components),
        is_step_(interpolation == "STEP"),
        is_cubic_(interpolation == "CUBICSPLINE") {}

  std::vector<double> at(double seconds, bool is_rotation) const {
    auto const next = std::upper_bound(times_.begin(), times_.end(), seconds,
                                       [](double time, float key) { return time < double(key); });
    if (next == times_.begin()) return value(0);
    auto const after = std::size_t(next - times_.begin());
    if (after == times_.size()) return value(after - 1);
    std::size_t const before = after - 1;
    if (is_step_) return value(before);
    double const duration = double(times_[after]) - double(times_[before]);
    double const t = duration > 0 ? (seconds - double(times_[before])) / duration : 0;
    if (is_cubic_) return cubic(before, t, duration);
    return is_rotation ? slerp(before, t) : linear(before, t);
  }

 private:
  /// `part` of a cubic key frame: 0 in-tangent, 1 value, 2 out-tangent.
  double component(std::size_t key, std::size_t i, std::size_t part = 1) const {
    std::size_t const row = is_cubic_ ? 3 * key + part : key;
    return double(values_[row * components_ + i]);
  }

  std::vector<double> value(std::size_t key) const {
    std::vector<double> result(components_);
    for (std::size_t i = 0; i < components_; ++i) result[i] = component(key, i);
    return result;
  }

  std::vector<double> linear(std::size_t key, double t) const {
    std::vector<double> result(components_);
    for (std::size_t i = 0; i < components_; ++i) {
      result[i] = (1 - t) * component(key, i) + t * component(key + 1, i);
    }
    return result;
  }

  std::vector<double> slerp(std::size_t key, double t) const {
    auto const rotation = [this](std::size_t k) {
      return normalized(component(k, 0), component(k, 1), component(k, 2), component(k, 3));
    };
    glm::dquat const from = rotation(key);
    glm::dquat to = rotation(key + 1);
    if (glm::dot(from, to) < 0) to = -to;  // the same rotation, the shorter way
    // Half the angle between them from the sides of an isosceles triangle: exact for small angles too.
    double const angle = 2 * atan2_of(glm::length(to - from), glm::length(to + from));
    double const sine = sin_of(angle);
    bool const is_short = sine < 1e-8;
    double const a = is_short ? 1 - t : sin_of((1 - t) * angle) / sine;
    double const b = is_short ? t : sin_of(t * angle) / sine;
    glm::dquat const q = a * from + b * to;
    return {q.x, q.y, q.z, q.w};
  }

  // glTF 2.0, appendix C.4: a Hermite spline whose tangents are per second.
  std::vector<double> cubic(std::size_t key, double t, double duration) const {
    double const t2 = t * t;
    double const t3 = t2 * t;
    std::vector<double> result(components_);
    for (std::size_t i = 0; i < components_; ++i) {
      result[i] = (2 * t3 - 3 * t2 + 1) * component(key, i) + duration * (t3 - 2 * t2 + t) * component(key, i, 2) +
                  (-2 * t3 + 3 * t2) * component(key + 1, i) + duration * (t3 - t2) * component(key + 1, i, 0);
    }
    return result;
  }

  std::vector<float> times_;
  std::vector<float> values_;
  std::size_t components_;
  bool is_step_;
  bool is_cubic_;
};

std::optional<Track> read_track(tinygltf::AnimationSampler const& sampler, std::size_t components, Accessors& accessors,
                                Findings& findings, std::string const& pointer) {
  auto const times = accessors.floats(sampler.input, 1, pointer + "/input");
  // Weights are one scalar after the other; all else are vectors.
  auto const values = accessors.floats(sampler.output, 0, pointer + "/output");
  if (!times || !values) return std::nullopt;
  std::size_t const rows = times->count() * (sampler.interpolation == "CUBICSPLINE" ? 3 : 1);
  if (components == 0 || values->values.size() != rows * components) {
    findings.warn(
        DiagnosticCode::faulty_animation, pointer,
        fmt::format("{} values for {} key frames of {} components", values->values.size(), times->count(), components));
    return std::nullopt;
  }
  if (!std::is_sorted(times->values.begin(), times->values.end())) {
    findings.warn(DiagnosticCode::faulty_animation, pointer + "/input", "the times are not increasing");
    return std::nullopt;
  }
  return Track(times->values, values->values, components, sampler.interpolation);
}

std::size_t morph_target_count(tinygltf::Model const& model, tinygltf::Node const& node) {
  if (node.mesh < 0) return 0;
  std::size_t count = 0;
  for (auto const& primitive : model.meshes[std::size_t(node.mesh)].primitives) {
    count = std::max(count, primitive.targets.size());
  }
  return count;
}

void set(NodePose& node, std::string const& path, std::vector<double> const& v) {
  if (!are_finite(v)) return;
  if (path == "translation") node.translation = {v[0], v[1], v[2]};
  if (path == "scale") node.scale = {v[0], v[1], v[2]};
  if (path == "rotation") node.rotation = normalized(v[0], v[1], v[2], v[3]);
  if (path == "weights") node.weights = v;
}

}  // namespace

Mat4 NodePose::parent_from_node() const {
  if (matrix) return *matrix;
  return glm::translate(Mat4(1), translation) * glm::mat4_cast(rotation) * glm::scale(Mat4(1), scale);
}

void NodePose::translate(Vec3 const& way) {
  if (matrix) {
    (*matrix)[3] += glm::dvec4(way, 0);
  } else {
    translation += way;
  }
}

void NodePose::take_matrix_apart() {
  if (!matrix) return;
  Mat3 axes(*matrix);
  translation = Vec3((*matrix)[3]);
  scale = {glm::length(axes[0]), glm::length(axes[1]), glm::length(axes[2])};
  if (glm::determinant(axes) < 0) scale.x = -scale.x;
  for (int i = 0; i < 3; ++i) {
    if (scale[i] != 0) axes[i] /= scale[i];
  }
  glm::dquat const turn = glm::quat_cast(axes);
  rotation = normalized(turn.x, turn.y, turn.z, turn.w);
  matrix.reset();
}

std::vector<NodePose> rest_pose(tinygltf::Model const& model, Findings& findings) {
  std::vector<NodePose> pose(model.nodes.size());
  for (std::size_t i = 0; i < pose.size(); ++i) {
    tinygltf::Node const& node = model.nodes[i];
    pose[i].weights = node.weights;
    if (node.matrix.size() == 16) {
      Mat4 matrix(1);
      for (int column = 0; column < 4; ++column) {
        for (int row = 0; row < 4; ++row) matrix[column][row] = node.matrix[std::size_t(4 * column + row)];
      }
      if (glm::dvec4(matrix[0].w, matrix[1].w, matrix[2].w, matrix[3].w) != glm::dvec4(0, 0, 0, 1)) {
        findings.warn(DiagnosticCode::faulty_node, fmt::format("/nodes/{}/matrix", i),
                      "the last row is not 0 0 0 1; treated as if it were");
        for (int column = 0; column < 4; ++column) matrix[column].w = column == 3 ? 1 : 0;
      }
      pose[i].matrix = matrix;
      continue;
    }
    if (node.translation.size() == 3) set(pose[i], "translation", node.translation);
    if (node.scale.size() == 3) set(pose[i], "scale", node.scale);
    if (node.rotation.size() == 4) set(pose[i], "rotation", node.rotation);
  }
  return pose;
}

void apply_animation(tinygltf::Model const& model, int animation, double seconds, Accessors& accessors,
                     Findings& findings, std::vector<NodePose>& pose) {
  auto const& source = model.animations[std::size_t(animation)];
  for (std::size_t i = 0; i < source.channels.size(); ++i) {
    auto const& channel = source.channels[i];
    if (channel.target_node < 0) continue;
    std::string const& path = channel.target_path;
    tinygltf::Node const& node = model.nodes[std::size_t(channel.target_node)];
    std::size_t const components = path == "translation" || path == "scale" ? 3
                                   : path == "rotation"                     ? 4
                                   : path == "weights"                      ? morph_target_count(model, node)
                                                                            : 0;
    if (components == 0) continue;
    if (channel.sampler < 0 || std::size_t(channel.sampler) >= source.samplers.size()) {
      findings.warn(DiagnosticCode::faulty_animation, fmt::format("/animations/{}/channels/{}/sampler", animation, i),
                    fmt::format("sampler {} is out of range ({})", channel.sampler, source.samplers.size()));
      continue;
    }
    auto const track = read_track(source.samplers[std::size_t(channel.sampler)], components, accessors, findings,
                                  fmt::format("/animations/{}/samplers/{}", animation, channel.sampler));
    if (!track) continue;
    NodePose& target = pose[std::size_t(channel.target_node)];
    if (path != "weights" && target.matrix) {
      findings.warn(DiagnosticCode::faulty_node, fmt::format("/nodes/{}/matrix", channel.target_node),
                    "a node that moves must have no matrix: it is taken apart into translation, rotation and scale");
      target.take_matrix_apart();
    }
    set(target, path, track->at(seconds, path == "rotation"));
    (path == "weights" ? target.is_deformed : target.is_moved) = true;
  }
}

}  // namespace lichtraum::gltf
