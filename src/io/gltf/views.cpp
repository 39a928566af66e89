#include "io/gltf/views.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/trigonometric.hpp>
#include <limits>

#include "core/elementary.hpp"
#include "core/float3.hpp"
#include "core/largest_channel.hpp"
#include "io/gltf/values.hpp"

namespace lichtraum::gltf {
namespace {

constexpr char const* lights_extension = "KHR_lights_punctual";
constexpr double pi = 3.14159265358979323846;

/// Where a node of the world stands and where its -z and y axes point; scales do not count.
std::optional<Transform> frame_of(Mat4 const& world_from_node) {
  try {
    return Transform::look_along(Vec3(world_from_node[3]), -Vec3(world_from_node[2]), Vec3(world_from_node[1]));
  } catch (std::invalid_argument const&) {
    return std::nullopt;
  }
}

constexpr int picture_height = 720;
constexpr double usual_aspect_ratio = 16.0 / 9;

Resolution resolution_for(double aspect_ratio) {
  constexpr double largest = 16;  // beyond that the file is damaged rather than wide
  return {std::max(1, int(std::lround(picture_height * std::clamp(aspect_ratio, 1 / largest, largest)))),
          picture_height};
}

std::optional<Camera> make_camera(tinygltf::Camera const& source, std::string name,
                                  Transform const& world_from_camera) {
  if (source.type == "orthographic") {
    auto const& lens = source.orthographic;
    double const half_width = std::abs(lens.xmag);
    double const half_height = std::abs(lens.ymag);
    if (!(half_width > 0 && half_height > 0 && std::isfinite(2 * half_width) && std::isfinite(2 * half_height)))
      return {};
    Camera camera = Camera::orthographic(std::move(name), 2 * half_width, world_from_camera,
                                         resolution_for(half_width / half_height));
    camera.set_fit({CameraFit::Side::height, 0, {}, 2 * half_height});
    return camera;
  }
  auto const& lens = source.perspective;
  if (!(lens.yfov > 0 && lens.yfov < pi)) return {};
  bool const has_aspect = lens.aspectRatio > 0 && std::isfinite(lens.aspectRatio);
  Resolution const resolution = resolution_for(has_aspect ? lens.aspectRatio : usual_aspect_ratio);
  double const fov = 2 * atan2_of(tan_of(lens.yfov / 2) * resolution.width, resolution.height);
  Camera camera(std::move(name), glm::degrees(fov), world_from_camera, resolution);
  camera.set_fit({CameraFit::Side::height, glm::degrees(lens.yfov), {}});
  return camera;
}

double const infinity = std::numeric_limits<double>::infinity();

/// The nearest cone to the file's that there can be. Programs write the inner angle as large as the outer one
/// (three.js, unless told otherwise), and a right angle in single precision, which is more than one. Nothing for what
/// no clamp would bring near to what is meant.
std::optional<SpotCone> read_cone(tinygltf::SpotLight const& spot) {
  constexpr double right_angle = 90, excess = 1;  // by a degree at most: that may be rounding
  // Of the outer angle. The edge is as sharp as glTF's formula makes it anyway.
  constexpr double largest_inner = 1 - 1e-6;
  double const outer = glm::degrees(spot.outerConeAngle), inner = glm::degrees(spot.innerConeAngle);
  if (!(std::isfinite(inner) && outer > 0 && outer <= right_angle + excess)) return std::nullopt;
  SpotCone cone;
  cone.outer_degrees = std::min(outer, right_angle);
  cone.inner_degrees = std::clamp(inner, 0.0, largest_inner * cone.outer_degrees);
  bool const is_cone = cone.inner_degrees < cone.outer_degrees;  // not of the least of numbers
  return is_cone ? std::optional(cone) : std::nullopt;
}

/// As the file has it: in candela, lux of a directional one.
std::optional<Light> read_light(tinygltf::Light const& source, std::string name, Mat4 const& world_from_node) {
  if (!(source.intensity > 0 && std::isfinite(source.intensity))) return std::nullopt;
  Rgb color(1);
  if (source.color.size() == 3) color = {source.color[0], source.color[1], source.color[2]};
  Rgb const intensity = color * source.intensity;
  Vec3 const position(world_from_node[3]);
  if (!is_finite(intensity) || !is_finite(position)) return std::nullopt;
  Vec3 const direction = -Vec3(world_from_node[2]);
  double const range = source.range > 0 ? source.range : infinity;
  double const length = glm::length(direction);
  bool const has_direction = length > 0 && std::isfinite(length);
  if (source.type == "directional" && has_direction) return Light::directional(std::move(name), direction, intensity);
  auto const cone = source.type == "spot" ? read_cone(source.spot) : std::nullopt;
  if (cone && has_direction) return Light::spot(std::move(name), position, direction, intensity, *cone, range);
  bool const shines_around = source.type == "point" || source.type == "spot";
  return shines_around ? std::optional(Light::falling_off(std::move(name), position, intensity, range)) : std::nullopt;
}

/// What a light throws on the middle of the scene, whatever its cone and its range.
Rgb illuminance(Light const& light, Bounds const& box) {
  if (auto const* const sun = light.get<DirectionalLight>()) return sun->ld;
  Vec3 const center = box.center();
  double const size = std::max(glm::length(box.max - box.min), 1e-30);
  // Within the model there is no telling what is near: then half its size counts.
  double const distance = std::max(glm::length(*light.position() - center), 0.5 * size);
  return light.brightness() / (distance * distance);
}

struct Exposure : LightFieldVisitor {
  double factor;
  explicit Exposure(double f) : factor(f) {}
  void brightness(char const*, Rgb& color) const { color *= factor; }
};

Light exposed(Light const& light, double exposure) {
  Light::Model model = light.model();
  Exposure const expose(exposure);
  std::visit([&](auto& exposed) { for_each_field(exposed, expose); }, model);
  return Light(light.name(), std::move(model));
}

std::string name_of(tinygltf::Model const& model, int node, std::string const& own) {
  std::string const& name = model.nodes[std::size_t(node)].name;
  if (!name.empty()) return name;
  return own.empty() ? fmt::format("node_{}", node) : own;
}

}  // namespace

std::vector<Camera> read_cameras(tinygltf::Model const& model, NodeTree const& tree, Findings& findings) {
  std::vector<Camera> cameras;
  Names names;
  for (int const node : tree.placed) {
    int const number = model.nodes[std::size_t(node)].camera;
    if (number < 0) continue;
    auto const& source = model.cameras[std::size_t(number)];
    auto const frame = frame_of(tree.world_from_node[std::size_t(node)]);
    if (!frame) {
      findings.warn(DiagnosticCode::faulty_view, fmt::format("/nodes/{}", node),
                    "its transform leaves no directions: its camera is left out");
      continue;
    }
    if (auto camera = make_camera(source, names.unique(name_of(model, node, source.name)), *frame)) {
      cameras.push_back(std::move(*camera));
      continue;
    }
    findings.warn(DiagnosticCode::faulty_view, fmt::format("/cameras/{}", number),
                  source.type == "orthographic" ? "it shows no width and height: left out"
                                                : "it has no valid opening angle: left out");
  }
  return cameras;
}

std::vector<Light> read_lights(tinygltf::Model const& model, NodeTree const& tree, Findings& findings) {
  std::vector<Light> lights;
  Names names;
  for (int const node : tree.order) {
    auto const* extension = find_extension(model.nodes[std::size_t(node)].extensions, lights_extension);
    if (!extension) continue;
    auto const number = index_of(*extension, "light", model.lights.size());
    if (!number) {
      findings.warn(DiagnosticCode::faulty_view, fmt::format("/nodes/{}/extensions/{}/light", node, lights_extension),
                    fmt::format("it is missing or out of range ({})", model.lights.size()));
      continue;
    }
    auto const& source = model.lights[std::size_t(*number)];
    auto light =
        read_light(source, names.unique(name_of(model, node, source.name)), tree.world_from_node[std::size_t(node)]);
    if (!light) continue;
    if (source.type == "spot" && !light->get<SpotLight>()) {
      findings.warn(
          DiagnosticCode::faulty_view, fmt::format("/extensions/{}/lights/{}/spot", lights_extension, *number),
          "its outer angle is not between 0 and 90 degrees, or it has no direction: it shines in all directions");
    }
    lights.push_back(std::move(*light));
  }
  return lights;
}

double light_exposure(std::vector<Light> const& lights, Bounds const& box) {
  Rgb sum(0);
  for (Light const& light : lights) sum += illuminance(light, box);
  double const brightest = largest_channel(sum);
  return brightest > 0 && std::isfinite(brightest) && std::isfinite(1 / brightest) ? 1 / brightest : 0;
}

std::vector<Light> exposed_lights(std::vector<Light> const& lights, double exposure) {
  std::vector<Light> result;
  if (!(exposure > 0)) return result;
  Names names;
  for (Light const& light : lights) {
    names.unique(light.name());
    if (is_finite(light.brightness() * exposure)) result.push_back(exposed(light, exposure));
  }
  // Light from all around, which the lights of a file leave to the viewer.
  result.push_back(Light::ambient(names.unique("soft"), Rgb(0.1)));
  return result;
}

}  // namespace lichtraum::gltf
