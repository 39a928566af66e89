#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <iterator>
#include <new>
#include <utility>

#include "core/ascii.hpp"
#include "core/read_file.hpp"
#include "io/far_origin.hpp"
#include "io/gltf/contents.hpp"
#include "io/gltf/extensions.hpp"
#include "io/gltf/materials.hpp"
#include "io/gltf/scene_graph.hpp"
#include "io/gltf/variants.hpp"
#include "io/gltf/views.hpp"
#include "io/points.hpp"
#include "lichtraum/gltf.hpp"
#include "lichtraum/orbit.hpp"
#include "scene/graph_fold.hpp"

namespace lichtraum {
namespace gltf {
namespace {

void check_extensions(tinygltf::Model const& model, Findings& findings) {
  for (std::string const& name : model.extensionsRequired) {
    if (is_supported_extension(name)) continue;
    findings.warn(
        DiagnosticCode::unsupported_extension, "/extensionsRequired",
        fmt::format("the model needs {}, which is not supported; whatever can be read without it is shown", name));
  }
}

std::string const& name_of(std::string const& name) { return name; }
template <class Element>
std::string const& name_of(Element const& element) {
  return element.name;
}

/// The element of `list` with that index or name. Throws Error{usage} that lists what there is.
template <class List>
int select(List const& list, std::string const& selector, char const* kind) {
  int index = -1;
  auto const [end, error] = std::from_chars(selector.data(), selector.data() + selector.size(), index);
  bool const is_number = error == std::errc() && end == selector.data() + selector.size();
  if (is_number && index >= 0 && std::size_t(index) < list.size()) return index;
  std::string known;
  for (std::size_t i = 0; i < list.size(); ++i) {
    if (name_of(list[i]) == selector) return int(i);
    std::string const& name = name_of(list[i]);
    known += fmt::format("{}{} {}", i == 0 ? "" : ", ", i, name.empty() ? "(unnamed)" : fmt::format("'{}'", name));
  }
  if (known.empty()) {
    throw Error(ErrorKind::usage, fmt::format("there is no {0} '{1}': the model has no {0}s", kind, selector));
  }
  throw Error(ErrorKind::usage, fmt::format("there is no {} '{}' in the model; it has: {}", kind, selector, known));
}

bool has_parts_without_material(tinygltf::Model const& model) {
  return std::ranges::any_of(model.meshes, [&](tinygltf::Mesh const& mesh) {
    return std::ranges::any_of(mesh.primitives, [&](tinygltf::Primitive const& primitive) {
      return primitive.material < 0 || std::size_t(primitive.material) >= model.materials.size();
    });
  });
}

bool has_message(std::vector<Diagnostic> const& diagnostics, std::string const& message) {
  return std::ranges::find(diagnostics, message, &Diagnostic::message) != diagnostics.end();
}

int select_scene(tinygltf::Model const& model, std::string const& selector) {
  if (!selector.empty()) return select(model.scenes, selector, "scene");
  if (model.defaultScene >= 0) return model.defaultScene;
  return model.scenes.empty() ? -1 : 0;
}

}  // namespace
}  // namespace gltf

using namespace gltf;

/// What is read once, however often the model is posed.
struct GltfAnimation::State {
  State(std::string bytes, std::filesystem::path const& path, std::optional<std::filesystem::path> folder,
        ModelOptions const& wanted)
      : options(wanted), findings(path) {
    document.path = path;
    document.folder = std::move(folder);
    document.allowed_paths = options.allowed_paths;
    document.on_read = options.on_read;
    document.bytes = std::move(bytes);
    parse_document(document, findings);
    check_extensions(document.model, findings);
    buffers.emplace(document, budget, findings);
    if (!options.animation.empty()) {
      animation = select(document.model.animations, options.animation, "animation");
    } else if (!document.model.animations.empty()) {
      animation = 0;
    }
    scene_number = select_scene(document.model, options.scene);
    check_variants(document.model, findings);
    if (!options.variant.empty()) {
      int const variant = select(variant_names(document.model), options.variant, "variant");
      apply_variant(document.model, std::size_t(variant));
    }
    auto const own = read_materials(document, options, *buffers, budget, findings);
    own_materials.assign(own.begin(), has_parts_without_material(document.model) ? own.end() : own.end() - 1);
    materials.assign(own.begin(), own.end());
    if (options.material) std::fill(materials.begin(), materials.end(), options.material);
  }

  Model pose_at(std::optional<double> seconds) {
    if (origin) return pose_near_origin(seconds);
    Model model = pose_near_origin(seconds);
    find_origin(model.scene, !(seconds && animation));
    if (*origin == Vec3(0)) return model;
    std::vector<Diagnostic> found = std::move(model.diagnostics);
    model = pose_near_origin(seconds);
    model.diagnostics = std::move(found);
    model.diagnostics.push_back(moved_from(*origin, document.path.string()));
    return model;
  }

  /// `scene`: as it was posed first. Of what moves, the file's own pose decides, so that it is the same for all
  /// moments.
  void find_origin(Scene const& scene, bool is_at_rest) {
    Bounds box = fold_bounds(scene.roots()).total();
    bool const may_be_far = far_origin(box).has_value();
    if (may_be_far && !is_at_rest) box = fold_bounds(pose_near_origin(std::nullopt).scene.roots()).total();
    origin = may_be_far ? far_origin(box).value_or(Vec3(0)) : Vec3(0);
  }

  /// The same pose without what is taken off all places.
  std::vector<NodePose> without_origin(std::vector<NodePose> pose) const {
    if (!origin || *origin == Vec3(0)) return pose;
    std::vector<bool> const is_child = find_children(document.model);
    for (std::size_t i = 0; i < pose.size(); ++i) {
      if (!is_child[i]) pose[i].translate(-*origin);
    }
    return pose;
  }

  Model pose_near_origin(std::optional<double> seconds) {
    budget.begin_pose();
    Accessors accessors(document, *buffers, budget, findings);
    std::vector<NodePose> pose = rest_pose(document.model, findings);
    if (seconds && animation) {
      apply_animation(document.model, *animation, *seconds, accessors, findings, pose);
    } else if (seconds) {
      findings.warn(DiagnosticCode::option_without_effect, "/animations", "there is none; the time has no effect");
    }
    pose = without_origin(std::move(pose));
    NodeTree const tree = build_node_tree(document.model, scene_number, pose, findings);

    Model result;
    for (auto const& material : own_materials) result.scene.materials.insert(material);
    Primitives primitives(document, *buffers, accessors, budget, findings, geometries);
    Names names;
    SceneGraph graph(document, tree, pose, primitives, accessors, materials, names, budget, findings);
    std::string const scene_name = scene_number >= 0 ? document.model.scenes[std::size_t(scene_number)].name : "";
    graph.build(scene_name.empty() ? document.path.stem().string() : scene_name, result.scene);
    if (graph.drawn() == 0) {
      if (graph.faulty_primitives() > 0)
        findings.fail(DiagnosticCode::nothing_to_draw, "", "the model has nothing to draw");
      findings.warn(DiagnosticCode::undrawn_primitive, "", "the scene shows no triangles, lines or points");
    }

    set_point_sizes(result.scene, options.point_size);
    if (options.point_size && !has_points_or_lines(result.scene)) {
      findings.warn(DiagnosticCode::option_without_effect, "", no_points_to_size);
    }
    add_view(tree, result.scene);
    std::vector<Diagnostic> found = findings.take();
    std::erase_if(found, [&](Diagnostic const& finding) { return has_message(early_diagnostics, finding.message); });
    result.diagnostics = std::exchange(early_diagnostics, {});
    std::ranges::move(found, std::back_inserter(result.diagnostics));
    if (!contents) {
      Findings::Muted const muted(findings);  // what is wrong in animations that nobody asked for
      contents = describe_contents(document.model, accessors);
    }
    result.contents = *contents;
    if (animation) result.contents.animation = std::size_t(*animation);
    if (origin) result.origin = *origin;
    return result;
  }

  void add_view(NodeTree const& tree, Scene& scene) {
    Bounds const box = framed ? *framed : fold_bounds(scene.roots()).total();
    for (Camera& camera : read_cameras(document.model, tree, findings)) scene.cameras.insert(std::move(camera));
    bool const has_camera = scene.has_own_cameras = !scene.cameras.empty();
    if (!has_camera) scene.cameras.insert(frame_box("default", box));
    if (!exposure) exposure = exposure_at_rest(box);
    std::vector<Light> lights = exposed_lights(read_lights(document.model, tree, findings), *exposure);
    scene.has_own_lights = !lights.empty();
    if (lights.empty()) lights = studio_lights(box, has_camera ? 0 : three_quarter_view.azimuth_degrees);
    for (Light& light : lights) scene.lights.insert(std::move(light));
  }

  /// Of the model as its file has it, so that lights which come near are bright.
  double exposure_at_rest(Bounds const& box) {
    Findings::Muted const muted(findings);
    std::vector<NodePose> const rest = without_origin(rest_pose(document.model, findings));
    NodeTree const tree = build_node_tree(document.model, scene_number, rest, findings);
    return light_exposure(read_lights(document.model, tree, findings), box);
  }

  void frame_whole_animation() {
    constexpr int poses = 16;  // between which little moves far, or in a straight line
    double const duration = duration_seconds();
    Bounds box;
    std::vector<Diagnostic> found;
    for (int i = 0; i < poses; ++i) {
      Model const model = pose_at(duration * i / (poses - 1));
      if (i == 0) found = model.diagnostics;
      box.add(fold_bounds(model.scene.roots()).total());
    }
    early_diagnostics = std::move(found);  // not before, or the pose at i = 1 would have them
    framed = box;
  }

  double duration_seconds() {
    if (!animation) return 0;
    budget.begin_pose();
    Accessors accessors(document, *buffers, budget, findings);
    return animation_seconds(document.model.animations[std::size_t(*animation)], accessors,
                             fmt::format("/animations/{}", *animation));
  }

  ModelOptions options;
  Findings findings;
  Budget budget{findings};
  Document document;
  std::optional<Buffers> buffers;
  Primitives::Geometries geometries;
  std::optional<int> animation;
  std::optional<ModelContents> contents;
  std::optional<Vec3> origin;                 // taken off all places (far_origin), in every pose
  std::optional<Bounds> framed;               // around the whole animation
  std::optional<double> exposure;             // of the file's lights, in every pose
  std::vector<Diagnostic> early_diagnostics;  // about the model, found when that was done
  int scene_number = -1;
  std::vector<std::shared_ptr<Material>> own_materials;
  std::vector<std::shared_ptr<Material const>> materials;  // what primitives get
};

namespace {

template <class Function>
auto with_memory_checked(std::filesystem::path const& path, Function const& function) {
  try {
    return function();
  } catch (std::bad_alloc const&) {
    throw Error(ErrorKind::scene, fmt::format("{}: the model needs more memory than there is", path.string()));
  }
}

}  // namespace

GltfAnimation::GltfAnimation(std::filesystem::path const& path, ModelOptions const& options)
    : state_(with_memory_checked(path, [&] {
        if (options.on_read) options.on_read(path);
        return std::make_unique<State>(read_file(path), path, path.parent_path(), options);
      })) {}
GltfAnimation::GltfAnimation(std::string bytes, std::string const& name, ModelOptions const& options)
    : state_(with_memory_checked(
          name, [&] { return std::make_unique<State>(std::move(bytes), name, std::nullopt, options); })) {}
GltfAnimation::~GltfAnimation() = default;
GltfAnimation::GltfAnimation(GltfAnimation&&) noexcept = default;
GltfAnimation& GltfAnimation::operator=(GltfAnimation&&) noexcept = default;

void GltfAnimation::frame_whole_animation() {
  with_memory_checked(state_->document.path, [&] { state_->frame_whole_animation(); });
}

double GltfAnimation::duration_seconds() { return state_->duration_seconds(); }

Model GltfAnimation::pose(std::optional<double> time_seconds) {
  return with_memory_checked(state_->document.path, [&] { return state_->pose_at(time_seconds); });
}

bool is_gltf_file(std::filesystem::path const& path) {
  std::string const extension = to_lower_ascii(path.extension().string());
  return extension == ".gltf" || extension == ".glb";
}

Model import_gltf(std::filesystem::path const& path, ModelOptions const& options) {
  return GltfAnimation(path, options).pose(options.time_seconds);
}

Model import_gltf_bytes(std::string bytes, std::string const& name, ModelOptions const& options) {
  return GltfAnimation(std::move(bytes), name, options).pose(options.time_seconds);
}

Scene load_gltf(std::filesystem::path const& path, ModelOptions const& options) {
  return std::move(import_gltf(path, options).scene);
}

}  // namespace lichtraum
